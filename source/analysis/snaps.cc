#include <deltaform/analysis/conditions.h>
#include <deltaform/base/text.h>
#include <deltaform/model/accepted_increment.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

namespace deltaform
{
  namespace
  {
    /// Has the blank snapped to another equilibrium, and a node turned by more than is allowed?
    class Snaps : public Condition
    {
    public:
      explicit Snaps(const Actors &)
      {
      }

      void observe(const AcceptedIncrement &increment) override
      {
        if (increment.snap_rotation <= 0.)
          return;
        ++n_snaps_;
        if (increment.snap_rotation <= rotation_)
          return;
        rotation_ = increment.snap_rotation;
        time_ = increment.time;
      }

      std::vector<std::string> warnings(bool) const override
      {
        if (n_snaps_ == 0)
          return {};
        return {"snap: in " + std::to_string(n_snaps_) +
                " increments the blank snapped to another equilibrium, and nodes turned by up to " +
                text::rounded(rotation_) + " rad (the most at time " + text::rounded(time_) +
                "), more than Solver/Largest rotation increment. Look at the pictures before and after: which "
                "equilibrium the blank snaps to is not certain."};
      }

      void save(boost::archive::binary_oarchive &archive) const override
      {
        archive << n_snaps_ << rotation_ << time_;
      }

      void load(boost::archive::binary_iarchive &archive) override
      {
        archive >> n_snaps_ >> rotation_ >> time_;
      }

    private:
      unsigned int n_snaps_ = 0;
      double rotation_ = 0., time_ = 0.; ///< of the largest one
    };

    const ConditionEntry entry("snaps", [](const Actors &actors) -> std::unique_ptr<Condition> {
      return std::make_unique<Snaps>(actors);
    });
  } // namespace
} // namespace deltaform
