#include <deltaform/solver/system.h>

#include "bordered_solve.h"
#include "constant_part.h"
#include "factorization.h"
#include "prescribed_rows.h"
#include "tangent.h"

#include <deltaform/process/ranks.h>

#include <cmath>
#include <string>
#include <utility>

namespace deltaform
{
  struct System::Kept
  {
    TangentCopy tangent;
    Vector residual, magnitude;
  };


  System::System(dealii::DynamicSparsityPattern &&pattern,
                 const unsigned int n_border,
                 const LinearSolverSettings &settings,
                 const dealii::IndexSet &owned)
    : tangent_(std::make_unique<Tangent>(pattern, n_border, owned)),
      rows_(std::make_unique<PrescribedRows>(size(), settings.iterative())), residual_(size()), magnitude_(size())
  {
    auto solver = tangent_->distributed() != nullptr
                    ? LinearSolver::distributed(settings, pattern, tangent_->first(), tangent_->end())
                    : LinearSolver::local(settings, pattern);
    tangent_->connect(solver->matrix());
    factorization_ = std::make_unique<Factorization>(std::move(solver), *tangent_);
  }


  System::System(dealii::DynamicSparsityPattern &&pattern, const unsigned int n_border, const std::string &solver)
    : System(std::move(pattern), n_border, LinearSolverSettings(solver), dealii::complete_index_set(pattern.n_rows()))
  {
  }


  System::~System() = default;
  System::System(System &&) noexcept = default;
  System &System::operator=(System &&) noexcept = default;


  unsigned int System::size() const
  {
    return tangent_->n_sparse() + tangent_->n_border();
  }


  void System::keep_constant_part(std::vector<DofIndex> candidates, const std::size_t largest_rank)
  {
    constant_ = std::make_unique<ConstantPart>(*tangent_, std::move(candidates), largest_rank);
  }


  void System::discard_factors()
  {
    factorization_->solver().discard_factors();
  }


  void System::clear(const bool tangent)
  {
    wanted_ = tangent;
    common_ = tangent_->distributed() == nullptr;
    residual_ = 0.;
    magnitude_ = 0.;
    kept_.reset();
    if (constant_)
      constant_->begin();
    if (tangent && !(constant_ && constant_->restore()))
      tangent_->clear(nullptr);
  }


  bool System::wants_tangent() const
  {
    return wanted_ && !(constant_ && constant_->passes_by());
  }


  void System::add(const DofIndex *dofs, const unsigned int n, const double *matrix, const double *vector)
  {
    for (unsigned int i = 0; i < n; ++i)
    {
      residual_[dofs[i]] += vector[i];
      magnitude_[dofs[i]] += std::abs(vector[i]);
    }
    if (matrix != nullptr && wanted_)
      tangent_->add(dofs, n, matrix, common_, constant_ ? constant_->update() : nullptr);
  }


  void System::add_to_diagonal(const double factor, const std::vector<double> &scale)
  {
    tangent_->add_to_diagonal(factor, scale, constant_ ? constant_->update() : nullptr);
  }


  void System::sum_over_ranks()
  {
    if (tangent_->distributed() != nullptr)
    {
      ranks::sum(residual_.begin(), residual_.size());
      ranks::sum(magnitude_.begin(), magnitude_.size());
      common_ = true;
      if (wanted_ && !(constant_ && constant_->known()))
        tangent_->sum_over_ranks();
    }
    if (constant_)
      constant_->complete(wanted_);
  }


  bool System::keep()
  {
    kept_.reset();
    if (!wanted_ || constant_ || tangent_->distributed() != nullptr || !factorization_->solver().is_cheap())
      return false;
    kept_ = std::make_unique<Kept>(Kept{tangent_->copy(), residual_, magnitude_});
    return true;
  }


  bool System::go_back()
  {
    if (!kept_)
      return false;
    tangent_->go_back(kept_->tangent);
    residual_ = kept_->residual;
    magnitude_ = kept_->magnitude;
    return true;
  }


  void System::block(const DofIndex *dofs, const unsigned int n, double *result) const
  {
    tangent_->block(dofs, n, result);
  }


  void System::multiply(const Vector &direction, Vector &result) const
  {
    tangent_->multiply(direction, result);
  }


  void System::linear_residual(const Vector &d, Vector &result) const
  {
    tangent_->multiply(d, result);
    tangent_->border().multiply(d, result);
    result += residual_;
  }


  void System::for_each_entry(const std::function<void(DofIndex, DofIndex, double)> &action) const
  {
    tangent_->for_each_entry(action);
  }


  double System::diagonal(const DofIndex dof) const
  {
    return tangent_->diagonal(dof);
  }


  double System::largest_diagonal() const
  {
    return tangent_->largest_diagonal(rows_->prescribed());
  }


  void System::set_near_null_space(const std::vector<Vector> &motions)
  {
    if (constant_)
      constant_->set_motions(motions);
    factorization_->solver().set_near_null_space(motions, tangent_->first(), tangent_->end());
  }


  void System::set_prescribed(const std::vector<bool> &prescribed)
  {
    rows_->set(prescribed);
  }


  bool System::prescribed(const DofIndex dof) const
  {
    return rows_->prescribed()[dof];
  }


  bool System::factorize(const double shift)
  {
    if (constant_ && shift == 0. && constant_->factorize(*rows_, *factorization_))
      return true;
    return factorize_whole(shift);
  }


  bool System::factorize_whole(const double shift)
  {
    if (constant_)
      constant_->drop();
    const double scale = largest_diagonal();
    double *const staged = tangent_->stage();
    rows_->eliminate(staged, *tangent_, scale, shift);
    // A force-driven tool that has lost the blank: it moves along its force.
    tangent_->stiffen_border(shift * scale);
    return factorization_->factorize(staged);
  }


  bool System::solve(const Vector &increments, Vector &d)
  {
    if (constant_ && constant_->condensed())
    {
      if (constant_->solve(*factorization_, *rows_, residual_, increments, d))
        return true;
      // The sum is singular, or nearly: what the whole matrix makes of it is what a run without an update would see.
      if (!factorize_whole(0.))
        return false;
    }
    return solve_bordered(*factorization_, *tangent_, *rows_, residual_, increments, d);
  }


  std::string System::linear_failure() const
  {
    return factorization_->solver().failure();
  }


  unsigned int System::n_linear_iterations() const
  {
    return factorization_->solver().n_iterations();
  }


  unsigned int System::n_factorizations() const
  {
    return factorization_->n();
  }


  unsigned int System::n_compliances() const
  {
    return constant_ ? constant_->n_compliances() : 0;
  }
} // namespace deltaform
