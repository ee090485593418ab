#include <deltaform/model/discretization.h>

#include <algorithm>
#include <utility>

namespace deltaform
{
  Discretization::Discretization(Actors &actors, const LinearSolverSettings &linear_solver)
    : actors_(actors), linear_solver_(linear_solver)
  {
    renumber();
  }


  void Discretization::renumber()
  {
    numbering_ = Numbering(actors_);
    const std::size_t width = front_width(*numbering_.pattern);
    linear_solver_.choose(numbering_.n_sparse, width);
    // Newton's method holds on to the object.
    System system(std::move(*numbering_.pattern), numbering_.n_border, linear_solver_, numbering_.owned);
    if (system_)
      *system_ = std::move(system);
    else
      system_ = std::make_unique<System>(std::move(system));
    numbering_.pattern.reset();
    if (on_linear_path())
      system_->keep_constant_part(numbering_.contact_unknowns, std::clamp<std::size_t>(width / 2, 100, 600));
    if (on_linear_path() || linear_solver_.iterative())
      system_->set_near_null_space(numbering_.rigid_motions(*actors_.blank));
  }
} // namespace deltaform
