#include <deltaform/materials/softening.h>
#include <deltaform/parameters/registry.h>

namespace deltaform
{
  namespace
  {
    /// The temperature is counted, the flow stress does not care.
    class NoSoftening final : public Softening
    {
    public:
      bool acts() const override
      {
        return false;
      }

      Softened evaluate(double) const override
      {
        return {1., 0.};
      }
    };

    std::unique_ptr<Softening> make(Section &)
    {
      return std::make_unique<NoSoftening>();
    }

    const Registry<Softening>::Entry entry("none", "The flow stress does not depend on the temperature", make);
  } // namespace
} // namespace deltaform
