#include "bordered_solve.h"

#include "factorization.h"
#include "prescribed_rows.h"
#include "tangent.h"

#include <Eigen/Dense>

#include <cmath>
#include <vector>

namespace deltaform
{
  bool solve_bordered(Factorization &factorization,
                      const Tangent &tangent,
                      const PrescribedRows &rows,
                      const Vector &residual,
                      const Vector &increments,
                      Vector &d)
  {
    const unsigned int n = tangent.n_sparse(), n_border = tangent.n_border();
    Vector right_side(n);
    rows.right_side(residual, increments, right_side);
    if (!factorization.solve(right_side, d))
      return false;
    if (n_border == 0)
      return true;

    // (D - C K^-1 B) w = -R_w - C K^-1 (-R), then d -= K^-1 B w
    const auto &prescribed = rows.prescribed();
    std::vector<Vector> eliminated(n_border, Vector(n));
    Eigen::MatrixXd schur(n_border, n_border);
    Eigen::VectorXd load(n_border);
    for (unsigned int b = 0; b < n_border; ++b)
    {
      for (unsigned int i = 0; i < n; ++i)
        right_side[i] = prescribed[i] ? 0. : tangent.border().columns()[b][i];
      if (!factorization.solve(right_side, eliminated[b]))
        return false;
    }
    for (unsigned int a = 0; a < n_border; ++a)
    {
      const Vector &row = tangent.border().rows()[a];
      load[a] = -residual[n + a];
      for (unsigned int i = 0; i < n; ++i)
        load[a] -= row[i] * d[i];
      for (unsigned int b = 0; b < n_border; ++b)
        schur(a, b) = tangent.border().block(a, b) - row * eliminated[b];
      if (prescribed[n + a])
      {
        schur.row(a).setZero();
        schur(a, a) = 1.;
        load[a] = increments[n + a];
      }
    }
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(schur);
    if (!lu.isInvertible())
      return false;
    const Eigen::VectorXd w = lu.solve(load);
    for (unsigned int b = 0; b < n_border; ++b)
    {
      if (!std::isfinite(w[b]))
        return false;
      d[n + b] = w[b];
      for (unsigned int i = 0; i < n; ++i)
        d[i] -= eliminated[b][i] * w[b];
    }
    return true;
  }
} // namespace deltaform
