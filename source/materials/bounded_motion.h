#pragma once

#include <array>
#include <cmath>

namespace deltaform
{
  /**
   * theta of Yoshida and Uemori's yield surface after s = C x, x the growth of the equivalent plastic strain:
   *
   *     d theta/ds = a n - sqrt(a/|theta|) theta,      |theta|^2 = <theta, theta>,
   *
   * n constant, a linear in s. It stays in the plane of its begin and n, theta = p theta_0 + q n, so that scalars
   * suffice. theta relaxes within few increments, and as a root of s from theta = 0: a step of BDF2 is too long for
   * it. So it has three steps by the L-stable Runge-Kutta method of second order and two stages, each of which has a
   * closed form: of V = theta (1 + k/sqrt|theta|) the size of theta is w^2, w^2 + k w = |V|. R. Alexander, Diagonally
   * implicit Runge-Kutta methods for stiff O.D.E.'s, SIAM J. Numer. Anal. 14 (1977) 1006.
   */
  class BoundedMotion
  {
  public:
    /// What p and q depend on.
    enum Parameter : unsigned char
    {
      along, ///< <theta_0, n> (stress)
      square, ///< <n, n> (1)
      length, ///< s (1)
      bound, ///< a at the end (stress)
      n_parameters
    };

    /// A number with its derivatives by the parameters.
    struct Number
    {
      double value;
      std::array<double, n_parameters> by;
    };

    /// @param start_square <theta_0, theta_0>; @p along_n, @p n_square, @p s see Parameter; @p first, @p last a
    BoundedMotion(const double start_square,
                  const double along_n,
                  const double n_square,
                  const double s,
                  const double first,
                  const double last)
      : start_square_(start_square), along_(along_n), square_(n_square), length_(s), first_(first), last_(last)
    {
      constexpr double gamma = 1. - .70710678118654752, rest = (1. - gamma) / gamma;
      for (unsigned int step = 0; step < n_steps; ++step)
      {
        const Number p = p_, q = q_;
        relax(gamma, (step + gamma) / n_steps);
        go_on(p, p_, rest);
        go_on(q, q_, rest);
        relax(gamma, (step + 1.) / n_steps);
      }
    }

    const Number &p() const
    {
      return p_;
    }

    const Number &q() const
    {
      return q_;
    }

  private:
    static constexpr unsigned int n_steps = 3;

    /// @p now = @p before + @p factor (@p now - @p before)
    static void go_on(const Number &before, Number &now, const double factor)
    {
      now.value = before.value + factor * (now.value - before.value);
      for (unsigned int z = 0; z < n_parameters; ++z)
        now.by[z] = before.by[z] + factor * (now.by[z] - before.by[z]);
    }

    /// One stage from theta, @p share of a step long, with a at @p time (1: the end).
    void relax(const double share, const double time)
    {
      const double h = share / n_steps, a = first_ + time * (last_ - first_), root = std::sqrt(a);
      const double k = h * length_ * root;
      q_.value += h * length_ * a;
      q_.by[length] += h * a;
      q_.by[bound] += h * length_ * time;
      const double P = p_.value, Q = q_.value, size_by_P = P * start_square_ + Q * along_,
                   size_by_Q = P * along_ + Q * square_;
      const double size = std::sqrt(std::fmax(P * size_by_P + Q * size_by_Q, 0.));
      if (!(size > 0.))
        return;
      const double w = 2. * size / (k + std::sqrt(k * k + 4. * size)), ratio = w / (w + k);
      const std::array<double, n_parameters> k_by = {{0., 0., h * root, .5 * h * length_ * time / root}};
      const std::array<double, n_parameters> size_squared_by = {{2. * P * Q, Q * Q, 0., 0.}};
      for (unsigned int z = 0; z < n_parameters; ++z)
      {
        const double size_z = (size_by_P * p_.by[z] + size_by_Q * q_.by[z] + .5 * size_squared_by[z]) / size;
        const double w_z = (size_z - w * k_by[z]) / (2. * w + k);
        const double ratio_z = (k * w_z - w * k_by[z]) / ((w + k) * (w + k));
        p_.by[z] = ratio * p_.by[z] + ratio_z * P;
        q_.by[z] = ratio * q_.by[z] + ratio_z * Q;
      }
      p_.value *= ratio;
      q_.value *= ratio;
    }

    double start_square_, along_, square_, length_, first_, last_;
    Number p_{1., {}}, q_{0., {}};
  };
} // namespace deltaform
