#include <deltaform/materials/hardening_laws.h>
#include <deltaform/materials/read_law.h>

namespace deltaform
{
  const ParameterTable<Voce> &Voce::parameters()
  {
    static const ParameterTable<Voce> table{
      {{"Initial flow stress", &Voce::s0, Range::not_negative(), "stress", "Flow stress s0 at plastic strain 0.", 450.},
       {"Saturation stress", &Voce::ss, Range::positive(), "stress", "ss: the limit at large strain.", 715.},
       {"Saturation rate", &Voce::b, Range::positive(), "1", "b in s = s0 + (ss - s0) (1 - exp(-b e)) + H e.", 16.93},
       {"Linear modulus", &Voce::H, Range::not_negative(), "stress", "Slope H of the linear term, 0: none.", 0.,
        false}},
      {{"Saturation stress", "must not be less than the initial flow stress.",
        [](const Voce &law) { return law.ss >= law.s0; }}}};
    return table;
  }


  namespace
  {
    const Registry<Hardening>::Entry entry("voce", "s0 + (ss - s0) (1 - exp(-b e)) + H e", hardening_from<Voce>);
  } // namespace
} // namespace deltaform
