#include <deltaform/conditions/conditions.h>
#include <deltaform/reports/accepted_increment.h>

#include <boost/serialization/vector.hpp>

namespace deltaform
{
  namespace
  {
    /// Has every tool touched the blank?
    class UntouchedTools : public SavedCondition<UntouchedTools>
    {
    public:
      explicit UntouchedTools(const Actors &actors)
        : actors_(actors), touched_(actors.tools.size(), false)
      {
      }

      void observe(const AcceptedIncrement &increment) override
      {
        for (unsigned int i = 0; i < touched_.size(); ++i)
          if (!touched_[i] && actors_.tools[i]->exists_in(increment.stage.name))
            touched_[i] = actors_.interfaces[i]->n_touching() > 0;
      }

      std::vector<std::string> warnings(const bool done) const override
      {
        std::vector<std::string> result;
        for (unsigned int i = 0; done && i < touched_.size(); ++i)
          if (!touched_[i])
            result.push_back("tool '" + actors_.tools[i]->name() +
                             "' has never touched the blank. Look at its position, side and motion, or leave it out.");
        return result;
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &touched_;
      }

    private:
      const Actors &actors_;
      std::vector<bool> touched_; ///< tool by tool
    };

    const ConditionMakers::Entry
      entry("untouched tools", "a tool has never touched the blank", make_condition<UntouchedTools>);
  } // namespace
} // namespace deltaform
