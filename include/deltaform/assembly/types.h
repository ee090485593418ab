#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>
#include <deal.II/lac/vector.h>

namespace deltaform
{
  /// Vector of all unknowns or of all residuals.
  using Vector = dealii::Vector<double>;

  /// Number of an unknown.
  using DofIndex = dealii::types::global_dof_index;

  /// A point and a vector of the (r, z) or (x, y) plane.
  using Point2 = dealii::Point<2>;
  using Tensor1 = dealii::Tensor<1, 2>;
  using Tensor2 = dealii::Tensor<2, 2>;

  constexpr unsigned int invalid_index = static_cast<unsigned int>(-1);
} // namespace deltaform
