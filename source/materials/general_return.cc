#include "general_return.h"

#include "consistency.h"
#include "rate_dependent_flow.h"

#include <Eigen/Dense>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    using Vector4 = Eigen::Vector4d;
    using Matrix4 = Eigen::Matrix4d;
    using RowMajor = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

    constexpr unsigned int normal = 2; ///< the third direction
    constexpr double tolerance = 1e-14; ///< of the yield condition: that of find_stress() is in it

    Eigen::Map<const Vector4> vector(const Mandel &a)
    {
      return Eigen::Map<const Vector4>(a.data());
    }

    Eigen::Map<Vector4> vector(Mandel &a)
    {
      return Eigen::Map<Vector4>(a.data());
    }

    Eigen::Map<const RowMajor> matrix(const std::array<double, 16> &a)
    {
      return Eigen::Map<const RowMajor>(a.data());
    }

    Mandel mandel(const Vector4 &a)
    {
      return {{a[0], a[1], a[2], a[3]}};
    }

    /// The surface at @p stress, whose flow keeps the volume to the last digit: it is blind to the pressure.
    YieldPoint evaluate(const YieldSurface &surface, const Vector4 &stress)
    {
      YieldPoint at = surface.evaluate(mandel(stress));
      const double mean = (at.gradient[0] + at.gradient[1] + at.gradient[2]) / 3.;
      for (unsigned int i = 0; i < 3; ++i)
        at.gradient[i] -= mean;
      return at;
    }

    Matrix4 compliance(const Elasticity &elastic)
    {
      Matrix4 S = elastic.compliance * Matrix4::Identity();
      S.topLeftCorner<3, 3>().array() -= elastic.contraction;
      return S;
    }
  } // namespace


  /// One point on the way to its yield surface.
  struct GeneralReturn::State
  {
    const PointUpdate &point;
    Matrix4 compliance;
    Vector4 strain; ///< total less plastic at the start
    Vector4 relative_stress; ///< xi
    YieldPoint at; ///< the yield surface at xi
    double flow; ///< x
    Vector4 back_stress, back_stress_by_flow; ///< alpha, d alpha/dx
    Matrix4 stress_by_relative; ///< 1 + d alpha/d xi
    Vector4 residual, by_mu; ///< of the first equation, its derivative at fixed xi
    Matrix4 jacobian; ///< d residual/d xi at fixed mu
  };


  GeneralReturn::GeneralReturn(const FlowLaws &laws, const ThirdDirection third, const unsigned int n_history)
    : laws_(laws), third_stress_given_(third == ThirdDirection::stress_given), n_history_(n_history),
      back_stress_first_(FlowHistory::size),
      rate_first_(FlowHistory::size + (laws.back_stress ? laws.back_stress->history_layout().size() : 0))
  {
  }


  void GeneralReturn::set_elastic(const FlowLaw &law, const PointUpdate &point, State &state) const
  {
    const Elasticity &elastic = law.elastic;
    Mandel e;
    for (unsigned int i = 0; i < 4; ++i)
      e[i] = point.strain[i] - point.start[i];
    if (third_stress_given_)
      e[normal] = (point.third_stress * elastic.shift * (1. + elastic.poisson) - elastic.poisson * (e[0] + e[1])) /
                  (1. - elastic.poisson);
    point.stress = elastic.stress(e);
    if (third_stress_given_)
      point.stress[normal] = point.third_stress;
    state.compliance = compliance(elastic);
    state.strain = vector(e);
    state.back_stress = Vector4::Zero();
    if (laws_.back_stress)
      state.back_stress = vector(laws_.back_stress->value(point.start + back_stress_first_));
    state.relative_stress = vector(point.stress) - state.back_stress;
  }


  void GeneralReturn::set_residual(const FlowLaw &law, State &state, const double mu) const
  {
    const Mandel xi = mandel(state.relative_stress);
    state.at = evaluate(*laws_.yield_surface, state.relative_stress);
    const double q = state.at.value;
    const auto N = vector(state.at.gradient);
    state.flow = mu * q;
    state.stress_by_relative = Matrix4::Identity();
    state.back_stress_by_flow = Vector4::Zero();
    if (laws_.back_stress)
    {
      const PointUpdate &point = state.point;
      const BackStressStart from{point.start + back_stress_first_,
                                 point.committed + back_stress_first_,
                                 point.start[FlowHistory::equivalent] - point.committed[FlowHistory::equivalent]};
      const BackStressEnd end =
        laws_.back_stress->update(from, xi, state.at, state.flow, point.trial + back_stress_first_);
      state.back_stress = vector(end.value);
      state.stress_by_relative += matrix(end.by_relative_stress);
      state.back_stress_by_flow = vector(end.by_flow);
    }
    const Matrix4 &S = state.compliance;
    const Vector4 stress = state.relative_stress + state.back_stress;
    const Matrix4 stress_by_xi = state.stress_by_relative + mu * state.back_stress_by_flow * N.transpose();
    state.residual = S * stress + state.flow * N - state.strain;
    state.jacobian = S * stress_by_xi + mu * (N * N.transpose() + q * matrix(state.at.hessian));
    state.by_mu = q * (S * state.back_stress_by_flow + N);
    if (third_stress_given_)
    {
      const double scale = 1. / law.elastic.young;
      state.residual[normal] = scale * (stress[normal] - state.point.third_stress);
      state.jacobian.row(normal) = scale * stress_by_xi.row(normal);
      state.by_mu[normal] = scale * q * state.back_stress_by_flow[normal];
    }
  }


  bool GeneralReturn::find_stress(const FlowLaw &law, State &state, const double mu) const
  {
    constexpr unsigned int max_iter = 100;
    constexpr double close = 1e-8; // after one more step of second order: round-off
    set_residual(law, state, mu);
    for (unsigned int iteration = 0; iteration < max_iter; ++iteration)
    {
      const Vector4 from = state.relative_stress, step = -state.jacobian.partialPivLu().solve(state.residual);
      const double before = state.residual.squaredNorm(), size = step.norm();
      if (!std::isfinite(size))
        return false;
      double share = 1.;
      while (true)
      {
        state.relative_stress = from + share * step;
        set_residual(law, state, mu);
        if (size <= close * from.norm())
          return true;
        if (state.residual.squaredNorm() <= (1. - 1e-4 * share) * before)
          break;
        share /= 2.;
        if (share < 1e-9)
          return false;
      }
    }
    return false;
  }


  double GeneralReturn::largest_multiplier(const FlowLaw &law, const State &state) const
  {
    if (laws_.back_stress || (laws_.rate_factor && laws_.rate_factor->softens()))
      return std::numeric_limits<double>::infinity();
    // The first equation times xi: mu q^2 = xi . C^-1 (xi_trial - xi) <= xi_trial . C^-1 xi_trial / 4, with q no less
    // than the initial flow stress. What is blind to the pressure needs no pressure.
    Vector4 xi = state.relative_stress;
    xi.head<3>().array() -= third_stress_given_ ? xi[normal] : xi.head<3>().mean();
    return xi.dot(state.compliance * xi) / (4. * law.initial_flow_stress * law.initial_flow_stress);
  }


  PointOutcome GeneralReturn::update(const FlowLaw &law, const PointUpdate &point) const
  {
    State state{point, {}, {}, {}, {}, 0., {}, {}, {}, {}, {}, {}};
    set_elastic(law, point, state);
    const double guess = expected_increment(point.start, point.trial);
    const double q = laws_.yield_surface->equivalent_stress(mandel(state.relative_stress));
    if (!std::isfinite(q + vector(point.stress).sum()))
      return PointOutcome::not_finite;
    FlowStress flow = rate_dependent_flow_stress(laws_, law, point, rate_first_, 0.);
    // Twice: what has flowed before has solved equations whose terms, strains, are rounded again.
    if (q - flow.value <= 2. * yield_round_off(law, point.start, q))
      return stay_elastic(law, point, state);

    const auto excess = [&](const double mu) -> Excess {
      constexpr double none = std::numeric_limits<double>::quiet_NaN();
      if (!find_stress(law, state, mu))
        return {none, none};
      const double q_now = state.at.value;
      const double q_slope = -vector(state.at.gradient).dot(state.jacobian.partialPivLu().solve(state.by_mu));
      flow = rate_dependent_flow_stress(laws_, law, point, rate_first_, state.flow);
      const double ratio = flow.value / q_now;
      return {1. - ratio, (ratio * q_slope - flow.slope * (q_now + mu * q_slope)) / q_now};
    };
    const double stiffness = 3. * law.elastic.shear;
    const double start = std::fmin(q / flow.value - 1., 1.) / stiffness;
    const double expected = guess / (q - stiffness * guess);
    const PlasticFlow solved = solve_consistency(
      excess, expected > 1e-8 * start ? expected : 0., start, largest_multiplier(law, state), tolerance);
    if (!solved.found)
      return PointOutcome::not_converged;
    if (solved.amount == 0.)
      return stay_elastic(law, point, state);

    set_flow(law, point, state);
    if (point.tangent != nullptr)
      set_tangent(law, state, flow, point.tangent);
    return PointOutcome::good;
  }


  PointOutcome GeneralReturn::stay_elastic(const FlowLaw &law, const PointUpdate &point, State &state) const
  {
    keep_history(point.start, point.trial, n_history_);
    set_elastic(law, point, state);
    if (third_stress_given_)
      point.strain[normal] = law.elastic.third_strain(point.stress) + point.trial[normal];
    if (point.tangent != nullptr)
    {
      const auto &C = third_stress_given_ ? law.elastic.condensed_tangent : law.elastic.tangent;
      std::copy(C.begin(), C.end(), point.tangent);
    }
    return PointOutcome::good;
  }


  void GeneralReturn::set_flow(const FlowLaw &law, const PointUpdate &point, const State &state) const
  {
    for (unsigned int i = 0; i < 4; ++i)
      point.trial[i] = point.start[i] + state.flow * state.at.gradient[i];
    point.trial[FlowHistory::equivalent] = point.start[FlowHistory::equivalent] + state.flow;
    const double pressure = vector(point.stress).head<3>().sum(); // three times that of the trial stress
    point.stress = mandel(state.relative_stress + state.back_stress);
    if (!third_stress_given_)
      vector(point.stress).head<3>().array() += (pressure - vector(point.stress).head<3>().sum()) / 3.;
    else
    {
      point.stress[normal] = point.third_stress;
      point.strain[normal] = law.elastic.third_strain(point.stress) + point.trial[normal];
    }
  }


  void GeneralReturn::set_tangent(const FlowLaw &law, const State &state, const FlowStress &flow, double *tangent) const
  {
    // Both equations at fixed e_p, for d xi and dx; the second one, N . d xi = H dx, is scaled: H may be infinite.
    using Matrix5 = Eigen::Matrix<double, 5, 5>;
    const auto N = vector(state.at.gradient);
    const double young = law.elastic.young;
    Matrix5 J;
    J.topLeftCorner<4, 4>() = state.compliance * state.stress_by_relative + state.flow * matrix(state.at.hessian);
    J.topRightCorner<4, 1>() = state.compliance * state.back_stress_by_flow + N;
    J.bottomLeftCorner<1, 4>() = N.transpose() / (young + flow.slope);
    J(4, 4) = std::isinf(flow.slope) ? -1. : -flow.slope / (young + flow.slope);
    Eigen::Matrix<double, 5, 4> rates = Eigen::Matrix<double, 5, 4>::Identity();
    if (third_stress_given_)
    {
      J.row(normal).head<4>() = state.stress_by_relative.row(normal) / young;
      J(normal, 4) = state.back_stress_by_flow[normal] / young;
      rates(normal, normal) = 0.;
    }
    const Eigen::Matrix<double, 5, 4> solution = J.partialPivLu().solve(rates);
    Eigen::Map<RowMajor> result(tangent);
    result = state.stress_by_relative * solution.topRows<4>() + state.back_stress_by_flow * solution.row(4);
    if (third_stress_given_)
    {
      result.row(normal).setZero();
      result.col(normal).setZero();
    }
  }
} // namespace deltaform
