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
    Vector4 residual, by_mu; ///< of the first equation, its derivative by mu at fixed xi
    Matrix4 jacobian; ///< d residual/d xi at fixed mu
  };


  /// Both equations about a point, solved for d xi and dx.
  struct GeneralReturn::Linearized
  {
    Matrix4 inverse; ///< d xi/d residual of the first one, at fixed x
    Vector4 stress_by_flow; ///< minus d xi/dx of the first one
    Vector4 normal; ///< d/d xi of the second one
    double pivot; ///< d/dx of the second one along the first one
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


  void GeneralReturn::set_residual(const FlowLaw &law, State &state, const double x) const
  {
    const Mandel xi = mandel(state.relative_stress);
    state.flow = x;
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
    const Vector4 stress = state.relative_stress + state.back_stress;
    state.residual = state.compliance * stress + x * vector(state.at.gradient) - state.strain;
    if (third_stress_given_)
      state.residual[normal] = (stress[normal] - state.point.third_stress) / law.elastic.young;
  }


  void GeneralReturn::set_jacobian(const FlowLaw &law, State &state, const double mu) const
  {
    const Matrix4 &S = state.compliance;
    const double q = state.at.value;
    const auto N = vector(state.at.gradient);
    const Matrix4 stress_by_xi = state.stress_by_relative + mu * state.back_stress_by_flow * N.transpose();
    state.jacobian = S * stress_by_xi + mu * (N * N.transpose() + q * matrix(state.at.hessian));
    state.by_mu = q * (S * state.back_stress_by_flow + N);
    if (third_stress_given_)
    {
      const double scale = 1. / law.elastic.young;
      state.jacobian.row(normal) = scale * stress_by_xi.row(normal);
      state.by_mu[normal] = scale * q * state.back_stress_by_flow[normal];
    }
  }


  bool GeneralReturn::find_stress(const FlowLaw &law, State &state, const double mu) const
  {
    constexpr unsigned int max_iter = 100;
    constexpr double close = 1e-8; // after one more step of second order: round-off
    const auto set = [&]() {
      state.at = evaluate(*laws_.yield_surface, state.relative_stress);
      set_residual(law, state, mu * state.at.value);
      set_jacobian(law, state, mu);
    };
    set();
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
        set();
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

    if (!find_at_once(law, state, flow, guess))
    {
      const PlasticFlow solved = find_nested(law, state, flow, guess);
      if (!solved.found)
        return PointOutcome::not_converged;
      if (solved.amount == 0.)
        return stay_elastic(law, point, state);
    }

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


  GeneralReturn::Linearized
  GeneralReturn::linearize(const FlowLaw &law, const State &state, const FlowStress &flow) const
  {
    // The second equation, N . d xi = H dx, is scaled: H may be infinite.
    const double young = law.elastic.young, scale = 1. / (young + flow.slope);
    Matrix4 by_stress = state.compliance * state.stress_by_relative + state.flow * matrix(state.at.hessian);
    Vector4 by_flow = state.compliance * state.back_stress_by_flow + vector(state.at.gradient);
    if (third_stress_given_)
    {
      by_stress.row(normal) = state.stress_by_relative.row(normal) / young;
      by_flow[normal] = state.back_stress_by_flow[normal] / young;
    }
    Linearized result;
    result.inverse = by_stress.inverse();
    // By minors it has lost digits where the pressure is much stiffer than the flow: one step of Newton's method.
    result.inverse += result.inverse * (Matrix4::Identity() - by_stress * result.inverse);
    result.stress_by_flow = result.inverse * by_flow;
    result.normal = scale * vector(state.at.gradient);
    result.pivot = (std::isinf(flow.slope) ? -1. : -flow.slope * scale) - result.normal.dot(result.stress_by_flow);
    return result;
  }


  bool GeneralReturn::find_at_once(const FlowLaw &law, State &state, FlowStress &flow, const double guess) const
  {
    constexpr unsigned int most_iterations = 12;
    constexpr double close = 1e-8; // after one more step of second order: round-off
    const double young = law.elastic.young;
    const double q = laws_.yield_surface->equivalent_stress(mandel(state.relative_stress));
    const double base = third_stress_given_ ? state.relative_stress[normal] : state.relative_stress.head<3>().mean();
    const double scale = flow.value / q; // the trial stress in its direction
    state.relative_stress *= scale;
    state.relative_stress.head<3>().array() += (1. - scale) * base;
    double x = guess > 0. ? guess : (q - flow.value) / (3. * law.elastic.shear + std::fmin(flow.slope, young));
    bool last = false;
    for (unsigned int iteration = 0; iteration < most_iterations; ++iteration)
    {
      state.at = evaluate(*laws_.yield_surface, state.relative_stress);
      set_residual(law, state, x);
      flow = rate_dependent_flow_stress(laws_, law, state.point, rate_first_, x);
      const double excess = state.at.value - flow.value;
      if (last && std::abs(excess) <= tolerance * state.at.value)
        return true;
      const Linearized all = linearize(law, state, flow);
      const Vector4 at_fixed_flow = all.inverse * state.residual;
      const double second = std::isinf(flow.slope) ? 0. : excess / (young + flow.slope);
      const double growth = (second - all.normal.dot(at_fixed_flow)) / all.pivot;
      const Vector4 step = at_fixed_flow - growth * all.stress_by_flow;
      const double size = step.norm(), length = state.relative_stress.norm();
      x -= growth;
      // Not where it may be lost: what turns far, or flows back, is left to the one that is sure.
      if (!(size <= length && x > 0.))
        return false;
      state.relative_stress -= step;
      last = size <= close * length && std::abs(growth) <= close * x;
    }
    return false;
  }


  PlasticFlow GeneralReturn::find_nested(const FlowLaw &law, State &state, FlowStress &flow, const double guess) const
  {
    set_elastic(law, state.point, state);
    flow = rate_dependent_flow_stress(laws_, law, state.point, rate_first_, 0.);
    const double q = laws_.yield_surface->equivalent_stress(mandel(state.relative_stress));
    const auto excess = [&](const double mu) -> Excess {
      constexpr double none = std::numeric_limits<double>::quiet_NaN();
      if (!find_stress(law, state, mu))
        return {none, none};
      const double q_now = state.at.value;
      const double q_slope = -vector(state.at.gradient).dot(state.jacobian.partialPivLu().solve(state.by_mu));
      flow = rate_dependent_flow_stress(laws_, law, state.point, rate_first_, state.flow);
      const double ratio = flow.value / q_now;
      return {1. - ratio, (ratio * q_slope - flow.slope * (q_now + mu * q_slope)) / q_now};
    };
    const double stiffness = 3. * law.elastic.shear;
    const double start = std::fmin(q / flow.value - 1., 1.) / stiffness;
    const double expected = guess / (q - stiffness * guess);
    return solve_consistency(
      excess, expected > 1e-8 * start ? expected : 0., start, largest_multiplier(law, state), tolerance);
  }


  void GeneralReturn::set_tangent(const FlowLaw &law, const State &state, const FlowStress &flow, double *tangent) const
  {
    const Linearized all = linearize(law, state, flow);
    Matrix4 stress = all.inverse; // d xi/d strain, first at fixed flow
    if (third_stress_given_)
      stress.col(normal).setZero();
    const Eigen::RowVector4d growth = (-1. / all.pivot) * (all.normal.transpose() * stress);
    stress -= all.stress_by_flow * growth;
    Eigen::Map<RowMajor> result(tangent);
    result = state.stress_by_relative * stress + state.back_stress_by_flow * growth;
    if (third_stress_given_)
    {
      result.row(normal).setZero();
      result.col(normal).setZero();
    }
  }
} // namespace deltaform
