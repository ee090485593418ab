#include <deltaform/materials/hardening_laws.h>
#include <deltaform/materials/read_law.h>

namespace deltaform
{
  const ParameterTable<Ludwik> &Ludwik::parameters()
  {
    static const ParameterTable<Ludwik> table{
      {{"Initial flow stress",
        &Ludwik::s0,
        Range::not_negative(),
        "stress",
        "Flow stress s0 at plastic strain 0.",
        194.},
       {"Strength coefficient",
        &Ludwik::K,
        Range::not_negative(),
        "stress",
        "K: what plastic strain 1 adds to the flow stress.",
        550.},
       {"Hardening exponent", &Ludwik::n, Range::above_to(0., 1.), "1", "Exponent n.", .223}},
      {{"Strength coefficient",
        "the flow stress would be zero at all strains.",
        [](const Ludwik &law) { return law.s0 > 0. || law.K > 0.; }}}};
    return table;
  }


  namespace
  {
    const Registry<Hardening>::Entry entry("ludwik", "s0 + K e^n", hardening_from<Ludwik>);
  } // namespace
} // namespace deltaform
