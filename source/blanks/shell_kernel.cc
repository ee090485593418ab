#include "shell_kernel.h"
#include "shell_cell.h"

namespace deltaform
{
  template <unsigned int n_nodes, bool membrane>
  Status ShellKernel::assemble_cells(const Vector &q, AssemblyTarget &target)
  {
    ShellCell<n_nodes, membrane> cell(
      space_, points_, state_, material_, core_, shear_stiffness(), target.wants_tangent());
    for (unsigned int c = 0; c < space_.mesh().cells().size(); ++c)
    {
      cell.enter(c);
      if (!cell.set_strains(q))
        return Status::shorten("a layer of the shell is turned inside out", c);
      if (Status status = cell.update_stresses(); !status.good())
      {
        status.place = c;
        return status;
      }
      cell.add_up();
      cell.add_to(target);
    }
    return {};
  }


  Status ShellKernel::assemble(const Vector &q, AssemblyTarget &target)
  {
    if (space_.membrane())
      return space_.degree() == 1 ? assemble_cells<2, true>(q, target) : assemble_cells<3, true>(q, target);
    return space_.degree() == 1 ? assemble_cells<2, false>(q, target) : assemble_cells<3, false>(q, target);
  }


  double ShellKernel::shear_stiffness() const
  {
    return space_.membrane() ? 0. : shear_factor_ * material_.law().shear_modulus() * points_.thickness();
  }
} // namespace deltaform
