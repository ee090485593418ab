#include <deltaform/materials/hardening_laws.h>
#include <deltaform/materials/read_law.h>

namespace deltaform
{
  const ParameterTable<LinearHardening> &LinearHardening::parameters()
  {
    using Law = LinearHardening;
    static const ParameterTable<Law> table{
      {{"Initial flow stress", &Law::s0, Range::positive(), "stress", "Flow stress s0 at plastic strain 0.", 200.},
       {"Hardening modulus",
        &Law::H,
        Range::not_negative(),
        "stress",
        "Slope H of the flow stress against the plastic strain (not the tangent modulus).",
        300.}}};
    return table;
  }


  namespace
  {
    const Registry<Hardening>::Entry entry("linear", "s0 + H e", hardening_from<LinearHardening>);
  } // namespace
} // namespace deltaform
