// What the instruction counts of deltaform are compared with: arithmetic of the kind that it does, small dense products
// and a few functions of the mathematical library, compiled with the same flags and in no need of ever being changed.
// A new compiler or library moves both counts, a slower deltaform only one. tests/benchmark/instructions.py counts it.
#include <array>
#include <cmath>
#include <cstdio>

namespace
{
  constexpr unsigned int n = 18; // unknowns of a quadrilateral of degree 2

  using Matrix = std::array<double, n * n>;
} // namespace

/// One unit: a product of two 18 x 18 matrices and 18 logarithms and powers. Found by its name: not to be inlined.
__attribute__((noinline)) void
reference_unit(const Matrix &a, const Matrix &b, Matrix &result)
{
  result.fill(0.);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int j = 0; j < n; ++j)
        result[n * i + j] += a[n * i + k] * b[n * k + j];
  for (unsigned int i = 0; i < n; ++i)
    result[n * i + i] = std::log(1. + std::pow(std::abs(result[n * i + i]) + 1., .2));
}

int
main()
{
  Matrix a{}, b{}, c{};
  for (unsigned int i = 0; i < n * n; ++i)
  {
    a[i] = 1. / (1. + i);
    b[i] = 1. / (2. + i);
  }
  for (unsigned int repetition = 0; repetition < 100; ++repetition)
  {
    reference_unit(a, b, c);
    b = c;
    for (auto &value : b)
      value += 1e-3;
  }
  std::printf("%.17g\n", c[0]);
  return 0;
}
