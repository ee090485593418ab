#include "lanczos.h"

#include <deal.II/base/exceptions.h>

#include <arpack/arpack.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace deltaform
{
  namespace condition
  {
    double largest_eigenvalue(const int n, const std::function<Eigen::VectorXd(const Eigen::VectorXd &)> &apply)
    {
      if (n < 3) // too small for ARPACK
      {
        Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(n, 1., 2.).normalized(), y;
        for (unsigned int k = 0; k < 10000; ++k)
        {
          y = apply(x);
          if (!(y.norm() > 0))
            return 0.;
          x = y.normalized();
        }
        return x.dot(apply(x));
      }
      const a_int n_wanted = 1, n_vectors = std::min(n, 30);
      const a_int n_work = n_vectors * (n_vectors + 8);
      std::vector<double> residual(n), vectors(static_cast<std::size_t>(n) * n_vectors), work(3 * n), more(n_work);
      for (int i = 0; i < n; ++i)
        residual[i] = 1. + .37 * ((7 * i) % 11); // a start without symmetry
      std::array<a_int, 11> parameters{}, pointers{};
      parameters[0] = 1; // exact shifts
      parameters[2] = 3000; // restarts
      parameters[6] = 1; // A x = lambda x
      a_int ido = 0, info = 1;
      do
      {
        arpack::saupd(ido,
                      arpack::bmat::identity,
                      n,
                      arpack::which::largest_algebraic,
                      n_wanted,
                      1e-6,
                      residual.data(),
                      n_vectors,
                      vectors.data(),
                      n,
                      parameters.data(),
                      pointers.data(),
                      work.data(),
                      more.data(),
                      n_work,
                      info);
        if (ido == 1 || ido == -1)
        {
          const Eigen::Map<const Eigen::VectorXd> x(work.data() + pointers[0] - 1, n);
          Eigen::Map<Eigen::VectorXd>(work.data() + pointers[1] - 1, n) = apply(x);
        }
      } while (ido == 1 || ido == -1);
      AssertThrow(info == 0 && parameters[4] >= 1,
                  dealii::ExcMessage("ARPACK's Lanczos iteration ended with info " + std::to_string(info) + "."));

      std::vector<a_int> select(n_vectors);
      std::vector<double> value(n_wanted), vector(n);
      arpack::seupd(false,
                    arpack::howmny::ritz_vectors,
                    select.data(),
                    value.data(),
                    vector.data(),
                    n,
                    0.,
                    arpack::bmat::identity,
                    n,
                    arpack::which::largest_algebraic,
                    n_wanted,
                    1e-6,
                    residual.data(),
                    n_vectors,
                    vectors.data(),
                    n,
                    parameters.data(),
                    pointers.data(),
                    work.data(),
                    more.data(),
                    n_work,
                    info);
      AssertThrow(info == 0,
                  dealii::ExcMessage("ARPACK could not extract an eigenvalue: info " + std::to_string(info) + "."));
      return value[0];
    }
  } // namespace condition
} // namespace deltaform
