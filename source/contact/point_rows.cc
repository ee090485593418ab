#include <deltaform/contact/point_rows.h>

#include <algorithm>

namespace deltaform
{
  PointRows::PointRows(const ContactPoint &point)
    : point_(point), n_(point.n_dofs), n_motion_(point.n_dofs)
  {
    std::copy_n(point.dofs.begin(), n_, dofs_.begin());
    std::copy_n(point.jacobian.begin(), n_, jacobian_.begin());
  }


  void PointRows::add_column(const DofIndex unknown, const Tensor1 &direction)
  {
    dofs_[n_] = unknown;
    jacobian_[n_++] = -direction;
    n_motion_ = n_;
  }


  void PointRows::append(const DofIndex own)
  {
    dofs_[n_++] = own;
  }


  void PointRows::add_force(const Tensor1 &force)
  {
    for (unsigned int k = 0; k < n_motion_; ++k)
      residual_[k] = -(force * jacobian_[k]);
  }


  void PointRows::add_gradient(const Tensor1 &force, const Tensor2 &gradient)
  {
    std::array<Tensor1, most> by_unknown;
    for (unsigned int l = 0; l < n_motion_; ++l)
      by_unknown[l] = gradient * jacobian_[l];
    if (n_ > n_motion_)
      std::fill_n(matrix_.begin(), n_ * n_, 0.);
    for (unsigned int k = 0; k < n_motion_; ++k)
    {
      for (unsigned int l = 0; l < n_motion_; ++l)
        matrix_[k * n_ + l] = -(jacobian_[k] * by_unknown[l]);
      if (k < point_.n_dofs)
        matrix_[k * n_ + k] -= force * point_.second[k];
    }
  }


  void PointRows::add_square(const double factor,
                             const std::array<double, ContactPoint::max_dofs> &own,
                             const Tensor1 &by_place)
  {
    std::array<double, most> a{};
    for (unsigned int k = 0; k < n_motion_; ++k)
      a[k] = jacobian_[k] * by_place + (k < point_.n_dofs ? own[k] : 0.);
    for (unsigned int k = 0; k < n_motion_; ++k)
      for (unsigned int l = 0; l < n_motion_; ++l)
        matrix_[k * n_ + l] += factor * a[k] * a[l];
  }


  void PointRows::add_equation(const double residual, const double diagonal)
  {
    const unsigned int m = n_motion_;
    residual_[m] = residual;
    matrix_[m * n_ + m] = diagonal;
  }


  void PointRows::add_equation(const double residual,
                               const double diagonal,
                               const Tensor1 &by_place,
                               const Tensor1 &force_rate)
  {
    add_equation(residual, diagonal);
    const unsigned int m = n_motion_;
    for (unsigned int k = 0; k < m; ++k)
    {
      matrix_[k * n_ + m] = -(force_rate * jacobian_[k]);
      matrix_[m * n_ + k] = by_place * jacobian_[k];
    }
  }


  void PointRows::copy_residual(std::array<double, ContactPoint::max_dofs> &result) const
  {
    std::copy_n(residual_.begin(), point_.n_dofs, result.begin());
  }


  void PointRows::add_to(AssemblyTarget &target, const bool tangent) const
  {
    target.add(dofs_.data(), n_, tangent ? matrix_.data() : nullptr, residual_.data());
  }
} // namespace deltaform
