#include <deltaform/materials/hardening_laws.h>
#include <deltaform/materials/read_law.h>

namespace deltaform
{
  const ParameterTable<Swift> &Swift::parameters()
  {
    static const ParameterTable<Swift> table{
      {{"Strength coefficient", &Swift::K, Range::positive(), "stress", "K: flow stress at e0 + e = 1.", 589.},
       {"Prestrain", &Swift::e0, Range::not_negative(), "1", "Strain e0 that the material has seen before.", 1e-4},
       {"Hardening exponent", &Swift::n, Range::above_to(0., 1.), "1", "Exponent n.", .216}}};
    return table;
  }


  namespace
  {
    const Registry<Hardening>::Entry entry("swift", "K (e0 + e)^n", hardening_from<Swift>);
  } // namespace
} // namespace deltaform
