#include <deltaform/conditions/conditions.h>
#include <deltaform/limits/ironing.h>
#include <deltaform/reports/accepted_increment.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

namespace deltaform
{
  namespace
  {
    /// Do two tools iron a shell? It ends the run.
    class IronedShell : public SavedCondition<IronedShell>
    {
    public:
      void observe(const AcceptedIncrement &increment) override
      {
        watch_.observe(increment.sections());
      }

      std::string failure(const Stage &) override
      {
        return with_remedy(watch_.finding());
      }

      std::string likely_cause(const std::vector<SheetSection> &) const override
      {
        return with_remedy(watch_.suspicion());
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &watch_;
      }

    private:
      static constexpr const char *remedy =
        ". Model the blank as a solid of degree 2 with two elements through the thickness (Blank/Kind = solid), or "
        "give the tools more clearance";

      static std::string with_remedy(const std::string &finding)
      {
        return finding.empty() ? "" : finding + remedy;
      }

      IroningWatch watch_;
    };

    const ConditionMakers::Entry
      entry("ironed shell", "two tools iron a shell; ends the run", make_condition<IronedShell>);
  } // namespace
} // namespace deltaform
