#include <deltaform/materials/hardening_laws.h>
#include <deltaform/materials/read_law.h>

namespace deltaform
{
  const ParameterTable<HockettSherby> &HockettSherby::parameters()
  {
    using Law = HockettSherby;
    static const ParameterTable<Law> table{
      {{"Initial flow stress", &Law::s0, Range::not_negative(), "stress", "Flow stress s0 at plastic strain 0.", 120.},
       {"Saturation stress", &Law::ss, Range::positive(), "stress", "ss: the limit at large strain.", 380.},
       {"Saturation rate", &Law::m, Range::positive(), "1", "m in s = ss - (ss - s0) exp(-m e^n).", 5.},
       {"Hardening exponent", &Law::n, Range::above_to(0., 1.), "1", "Exponent n.", .75}},
      {{"Saturation stress",
        "must not be less than the initial flow stress.",
        [](const Law &law) { return law.ss >= law.s0; }}}};
    return table;
  }


  namespace
  {
    const Registry<Hardening>::Entry
      entry("hockett-sherby", "ss - (ss - s0) exp(-m e^n)", hardening_from<HockettSherby>);
  } // namespace
} // namespace deltaform
