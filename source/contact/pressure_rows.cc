#include <deltaform/contact/pressure_rows.h>

#include <algorithm>

namespace deltaform
{
  unsigned int PressureRows::row(const DofIndex dof)
  {
    const unsigned int found = std::find(dofs_.begin(), dofs_.begin() + n_, dof) - dofs_.begin();
    if (found == n_)
    {
      Assert(n_ < most, dealii::ExcInternalError());
      dofs_[n_] = dof;
      column_[n_] = row_[n_] = 0.;
      ++n_;
    }
    return found;
  }


  void PressureRows::add(const PointRows &rows, const Tensor1 &force_rate, const Tensor1 &by_place)
  {
    for (unsigned int k = 0; k < rows.n_motion(); ++k)
    {
      const unsigned int r = row(rows.dof(k));
      column_[r] -= force_rate * rows.jacobian(k);
      row_[r] += by_place * rows.jacobian(k);
    }
  }


  void PressureRows::add_to(AssemblyTarget &target) const
  {
    if (n_ == 0 || std::all_of(column_.begin(), column_.begin() + n_, [](const double entry) { return entry == 0.; }))
      return;
    std::array<double, most * most> matrix;
    for (unsigned int k = 0; k < n_; ++k)
      for (unsigned int l = 0; l < n_; ++l)
        matrix[k * n_ + l] = column_[k] * row_[l];
    const std::array<double, most> none{};
    target.add(dofs_.data(), n_, matrix.data(), none.data());
  }
} // namespace deltaform
