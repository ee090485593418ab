#include <deltaform/materials/back_stress.h>
#include <deltaform/parameters/registry.h>

namespace deltaform
{
  namespace
  {
    /// The yield surface stays where it is.
    class NoBackStress : public BackStress
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

      bool symmetric() const override
      {
        return true;
      }

      Mandel value(const double *) const override
      {
        return {};
      }

      BackStressEnd
      update(const BackStressStart &, const Mandel &, const YieldPoint &, double, double *) const override
      {
        return {};
      }
    };

    std::unique_ptr<BackStress> make(Section &)
    {
      return std::make_unique<NoBackStress>();
    }

    const Registry<BackStress>::Entry entry("none", "Isotropic hardening only", make);
  } // namespace
} // namespace deltaform
