#include <deltaform/materials/hardening_laws.h>
#include <deltaform/materials/read_law.h>

namespace deltaform
{
  const ParameterTable<PerfectlyPlastic> &PerfectlyPlastic::parameters()
  {
    static const ParameterTable<PerfectlyPlastic> table{
      {{"Flow stress", &PerfectlyPlastic::s0, Range::positive(), "stress", "Flow stress s0.", 200.}}};
    return table;
  }


  namespace
  {
    const Registry<Hardening>::Entry entry("perfectly plastic", "s0", hardening_from<PerfectlyPlastic>);
  } // namespace
} // namespace deltaform
