#pragma once

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/assembly/contact_point.h>
#include <deltaform/contact/counterpart.h>

#include <array>

namespace deltaform
{
  /**
   * What a contact point adds to residual and tangent: rows of the unknowns that move it relative to its counterpart,
   * then the row of the unknown of its normal law, if there is one.
   */
  class PointRows
  {
  public:
    static constexpr unsigned int most = ContactPoint::max_dofs + Counterpart::max_unknowns + 1;

    explicit PointRows(const ContactPoint &point);

    /// An unknown that moves the counterpart along @p direction under the point.
    void add_column(DofIndex unknown, const Tensor1 &direction);

    /// An unknown that does not move the point; after those columns.
    void append(DofIndex own);

    /// Residual -J^T F of the force @p force on the blank.
    void add_force(const Tensor1 &force);

    /// Tangent -J^T dF/dx J - F . d2x/dq2 of that force.
    void add_gradient(const Tensor1 &force, const Tensor2 &gradient);

    /// Tangent @p factor a a^T, a = @p own + J^T @p by_place; @p own: of the blank's unknowns.
    void add_square(double factor, const std::array<double, ContactPoint::max_dofs> &own, const Tensor1 &by_place);

    /// Row of the appended unknown: its residual and derivative by itself.
    void add_equation(double residual, double diagonal);

    /// The same of an equation that also depends on the place, by @p by_place, and whose unknown changes the force by
    /// @p force_rate.
    void add_equation(double residual, double diagonal, const Tensor1 &by_place, const Tensor1 &force_rate);

    /// Residuals of the point's own unknowns.
    void copy_residual(std::array<double, ContactPoint::max_dofs> &result) const;

    /// @p tangent: has the gradient been added?
    void add_to(AssemblyTarget &target, bool tangent) const;

    /// Unknowns that move the point relative to its counterpart, their numbers, and by what they do.
    ///@{
    unsigned int n_motion() const
    {
      return n_motion_;
    }

    DofIndex dof(const unsigned int k) const
    {
      return dofs_[k];
    }

    const Tensor1 &jacobian(const unsigned int k) const
    {
      return jacobian_[k];
    }
    ///@}

  private:
    const ContactPoint &point_;
    unsigned int n_ = 0, n_motion_ = 0;
    std::array<DofIndex, most> dofs_;
    std::array<Tensor1, most> jacobian_;
    std::array<double, most> residual_;
    std::array<double, most * most> matrix_; ///< n x n, row-major
  };
} // namespace deltaform
