#include <deltaform/increment/viscous_equations.h>

namespace deltaform
{
  Status ViscousEquations::assemble(const Vector &q, const bool tangent)
  {
    const Status status = equations_.assemble(q, tangent);
    if (status.good())
      add_viscous_forces(q);
    return status;
  }


  bool ViscousEquations::assemble_foreseen(const Vector &q)
  {
    if (!equations_.assemble_foreseen(q))
      return false;
    add_viscous_forces(q);
    return true;
  }


  void ViscousEquations::add_viscous_forces(const Vector &q)
  {
    for (DofIndex i = 0; i < q.size(); ++i)
    {
      if (system_.prescribed(i))
        continue;
      const double stiffness = c_ * scale_[i] * scale_[i], value = force(i, q);
      system_.add(&i, 1, system_.wants_tangent() ? &stiffness : nullptr, &value);
    }
  }
} // namespace deltaform
