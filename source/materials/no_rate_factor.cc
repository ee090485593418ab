#include <deltaform/materials/rate_factor.h>
#include <deltaform/parameters/registry.h>

namespace deltaform
{
  namespace
  {
    /// The flow stress depends neither on the rate of strain nor on the temperature.
    class NoRateFactor : public RateFactor
    {
    public:
      HistoryLayout history_layout() const override
      {
        return {};
      }

      bool acts() const override
      {
        return false;
      }

      bool needs_duration() const override
      {
        return false;
      }

      FlowStress evaluate(const FlowStress &slow, const PointFlow &, const double *, double *) const override
      {
        return slow;
      }
    };

    std::unique_ptr<RateFactor> make(Section &)
    {
      return std::make_unique<NoRateFactor>();
    }

    const Registry<RateFactor>::Entry entry("none", "Neither rate nor temperature", make);
  } // namespace
} // namespace deltaform
