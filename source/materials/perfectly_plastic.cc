#include <deltaform/base/registry.h>
#include <deltaform/materials/hardening.h>

namespace deltaform
{
  namespace
  {
    /**
     * Perfect plasticity: s(e) = s0, s0 > 0 a stress; slope 0.
     * R. Hill, The Mathematical Theory of Plasticity, Oxford 1950, chapter II.
     */
    class PerfectlyPlastic : public Hardening
    {
    public:
      explicit PerfectlyPlastic(Section &section)
        : flow_stress_(section.number("Flow stress", required(200.), Range::positive(), "stress", "Flow stress s0."))
      {
      }

      FlowStress evaluate(double) const override
      {
        return {flow_stress_, 0.};
      }

    private:
      double flow_stress_;
    };

    const Registry<Hardening>::Entry entry("perfectly plastic", "s0", make_as<PerfectlyPlastic, Hardening>);
  } // namespace
} // namespace deltaform
