#pragma once

#include <functional>
#include <vector>

namespace deltaform
{
  /// Relative size of the elements of a line at t in [0, 1].
  using RelativeSize = std::function<double(double)>;

  /// Integral of 1/size over [a, b], to 1e-9 of it: in proportion to the number of elements there.
  double element_density(const RelativeSize &size, double a, double b);

  /// Ends of @p n elements on [a, b], n + 1 values: every element has the same share of the integral of 1/size.
  std::vector<double> element_ends(const RelativeSize &size, double a, double b, unsigned int n);
} // namespace deltaform
