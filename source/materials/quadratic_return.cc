#include "quadratic_return.h"

#include "consistency.h"
#include "rate_dependent_flow.h"

#include <Eigen/Eigenvalues>

#include <array>
#include <limits>

namespace deltaform
{
  namespace
  {
    constexpr unsigned int normal = 2; ///< the third direction
    constexpr double tolerance = 1e-14; ///< of the yield condition

    using RowMajor = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

    Eigen::Map<const Eigen::Vector4d> vector(const double *const a)
    {
      return Eigen::Map<const Eigen::Vector4d>(a);
    }
  } // namespace


  /// The elastic trial state in its components.
  struct QuadraticReturn::Trial
  {
    double stiffness; ///< c
    double pressure; ///< what a stress has besides its components: the third one, or its mean
    Vector3 y;
    unsigned int n_terms = 0;
    std::array<Vector3, most_terms> back_stress; ///< each term at the start
  };


  /// After a growth x.
  struct QuadraticReturn::Flow
  {
    double x = 0;
    FlowStress stress{}; ///< s
    double size = 0; ///< h
    Vector3 direction, direction_by_growth; ///< n, its derivative at fixed s
    Vector3 denominator; ///< D
  };


  bool QuadraticReturn::serves(const FlowLaws &laws)
  {
    return laws.yield_surface->quadratic_form() != nullptr &&
           (!laws.back_stress || laws.back_stress->terms() != nullptr);
  }


  QuadraticReturn::QuadraticReturn(const FlowLaws &laws,
                                   const ThirdDirection third,
                                   const double poisson,
                                   const unsigned int n_history)
    : laws_(laws), terms_(laws.back_stress ? laws.back_stress->terms() : nullptr),
      third_stress_given_(third == ThirdDirection::stress_given), n_history_(n_history),
      rate_first_(FlowHistory::size + (laws.back_stress ? laws.back_stress->history_layout().size() : 0)),
      relative_stiffness_(third_stress_given_ ? 1. : 1. / (1. + poisson))
  {
    const RowMajor P = Eigen::Map<const RowMajor>(laws.yield_surface->quadratic_form()->data());
    // Stresses that count: less the third one, or deviators. Of these the compliance times c is S.
    Matrix43 basis = Matrix43::Zero();
    Matrix3 S = Matrix3::Identity();
    if (third_stress_given_)
    {
      basis(0, 0) = basis(1, 1) = basis(3, 2) = 1.;
      S(0, 1) = S(1, 0) = -poisson;
      S(2, 2) = 1. + poisson;
    }
    else
    {
      basis.col(0) << 1. / std::sqrt(2.), -1. / std::sqrt(2.), 0., 0.;
      basis.col(1) << 1. / std::sqrt(6.), 1. / std::sqrt(6.), -2. / std::sqrt(6.), 0.;
      basis(3, 2) = 1.;
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix3> common(basis.transpose() * P * basis, S);
    weight_ = common.eigenvalues();
    stress_ = basis * common.eigenvectors();
    components_ = basis * (S * common.eigenvectors());
    flow_ = P * stress_;
    deviator_ = stress_;
    for (unsigned int k = 0; k < 3; ++k)
    {
      flow_.col(k).head<3>().array() -= flow_.col(k).head<3>().mean();
      deviator_.col(k).head<3>().array() -= deviator_.col(k).head<3>().mean();
    }
    if (third_stress_given_) // a pressure has no components
      components_.row(normal) = -components_.row(0) - components_.row(1);
  }


  QuadraticReturn::Trial QuadraticReturn::trial_of(const FlowLaw &law, const PointUpdate &point) const
  {
    const Elasticity &elastic = law.elastic;
    Trial trial;
    trial.stiffness = relative_stiffness_ * elastic.young;
    Eigen::Vector4d e = vector(point.strain.data()) - vector(point.start);
    if (third_stress_given_)
    {
      trial.pressure = point.third_stress;
      e.head<3>().array() -= point.third_stress * elastic.shift;
      e[normal] = 0.; // not known yet
    }
    else
      trial.pressure = elastic.bulk * e.head<3>().sum();
    trial.y = trial.stiffness * (stress_.transpose() * e);
    if (terms_ != nullptr)
      for (const double *history = point.start + FlowHistory::size; trial.n_terms < terms_->size(); history += 4)
        trial.back_stress[trial.n_terms++] = components_.transpose() * vector(history);
    return trial;
  }


  void QuadraticReturn::set_flow(const Trial &trial, const double x, Flow &flow) const
  {
    Vector3 Z = trial.y, Z_by_x = Vector3::Zero();
    double back = 0., back_by_x = 0.; // sum C x/(1 + gamma x)
    for (unsigned int i = 0; i < trial.n_terms; ++i)
    {
      const auto [C, gamma] = (*terms_)[i];
      const double scale = 1. / (1. + gamma * x);
      Z -= scale * trial.back_stress[i];
      Z_by_x += gamma * scale * scale * trial.back_stress[i];
      back += C * x * scale;
      back_by_x += C * scale * scale;
    }
    flow.x = x;
    flow.denominator = (trial.stiffness * x) * weight_;
    // Without flow stress and flow it is 0: h is infinite, and what has no trial stress keeps none.
    flow.denominator.array() += std::fmax(flow.stress.value + back, std::numeric_limits<double>::min());
    flow.direction = Z.cwiseQuotient(flow.denominator);
    Vector3 denominator_by_x = trial.stiffness * weight_;
    denominator_by_x.array() += back_by_x;
    flow.direction_by_growth =
      (Z_by_x - flow.direction.cwiseProduct(denominator_by_x)).cwiseQuotient(flow.denominator);
    flow.size = std::sqrt(weight_.dot(flow.direction.cwiseAbs2()));
  }


  PointOutcome QuadraticReturn::update(const FlowLaw &law, const PointUpdate &point) const
  {
    const Trial trial = trial_of(law, point);
    const auto q_of = [&](const Vector3 &y) { return std::sqrt(weight_.dot(y.cwiseAbs2())); };
    Vector3 relative = trial.y;
    double bound = q_of(trial.y);
    for (unsigned int i = 0; i < trial.n_terms; ++i)
    {
      relative -= trial.back_stress[i];
      bound += q_of(trial.back_stress[i]);
    }
    const double q = q_of(relative);
    if (!std::isfinite(q + trial.pressure))
      return PointOutcome::not_finite;
    Flow flow;
    flow.stress = rate_dependent_flow_stress(laws_, law, point, rate_first_, 0.);
    // Twice: what has flowed before has solved equations whose terms, strains, are rounded again.
    if (q - flow.stress.value <= 2. * yield_round_off(law, point.start, q))
      return stay_elastic(law, point, trial);

    const double guess = expected_increment(point.start, point.trial);
    const auto excess = [&](const double x) -> Excess {
      flow.stress = rate_dependent_flow_stress(laws_, law, point, rate_first_, x);
      set_flow(trial, x, flow);
      const double inverse = 1. / flow.size;
      const Vector3 wn = weight_.cwiseProduct(flow.direction);
      const double by_growth = wn.dot(flow.direction_by_growth);
      const double by_stress = wn.dot(flow.direction.cwiseQuotient(flow.denominator));
      return {1. - inverse, (by_growth - flow.stress.slope * by_stress) * inverse * inverse * inverse};
    };
    const double start = (q - flow.stress.value) / (trial.stiffness * weight_.maxCoeff());
    const double upper = bound / (trial.stiffness * weight_.minCoeff());
    const PlasticFlow solved = solve_consistency(excess, guess, start, upper, tolerance);
    if (!solved.found)
      return PointOutcome::not_converged;
    if (solved.amount == 0.)
      return stay_elastic(law, point, trial);
    set_end(law, point, trial, flow);
    if (point.tangent != nullptr)
      set_tangent(law, trial, flow, point.tangent);
    return PointOutcome::good;
  }


  void QuadraticReturn::set_stress(const FlowLaw &law,
                                   const PointUpdate &point,
                                   const Trial &trial,
                                   const Vector3 &y) const
  {
    const Eigen::Vector4d stress = stress_ * y;
    for (unsigned int i = 0; i < 4; ++i)
      point.stress[i] = stress[i] + (i < 3 ? trial.pressure : 0.);
    if (third_stress_given_)
      point.strain[normal] = law.elastic.third_strain(point.stress) + point.trial[normal];
  }


  PointOutcome QuadraticReturn::stay_elastic(const FlowLaw &law, const PointUpdate &point, const Trial &trial) const
  {
    keep_history(point.start, point.trial, n_history_);
    set_stress(law, point, trial, trial.y);
    if (point.tangent != nullptr)
    {
      const auto &C = third_stress_given_ ? law.elastic.condensed_tangent : law.elastic.tangent;
      std::copy(C.begin(), C.end(), point.tangent);
    }
    return PointOutcome::good;
  }


  void
  QuadraticReturn::set_end(const FlowLaw &law, const PointUpdate &point, const Trial &trial, const Flow &flow) const
  {
    const double x = flow.x;
    const Eigen::Vector4d plastic = flow_ * (x * flow.direction);
    for (unsigned int i = 0; i < 4; ++i)
      point.trial[i] = point.start[i] + plastic[i];
    point.trial[FlowHistory::equivalent] = point.start[FlowHistory::equivalent] + x;
    // Backstress and flow stress have the digits that the trial stress loses after a large increment.
    Vector3 y = flow.stress.value * flow.direction;
    const Eigen::Vector4d direction = deviator_ * flow.direction;
    for (unsigned int i = 0; i < trial.n_terms; ++i)
    {
      const auto [C, gamma] = (*terms_)[i];
      const double scale = 1. / (1. + gamma * x);
      const unsigned int first = FlowHistory::size + 4 * i;
      y += scale * (trial.back_stress[i] + C * x * flow.direction);
      for (unsigned int k = 0; k < 4; ++k)
        point.trial[first + k] = scale * (point.start[first + k] + C * x * direction[k]);
    }
    set_stress(law, point, trial, y);
  }


  void QuadraticReturn::set_tangent(const FlowLaw &law, const Trial &trial, const Flow &flow, double *tangent) const
  {
    // y = y_trial - c w x n; at the end w n . dn = 0, where H dx, not H alone, is finite.
    const double c = trial.stiffness, H = flow.stress.slope, young = law.elastic.young;
    const double share = std::isinf(H) ? 1. : H / (young + H), rest = std::isinf(H) ? 0. : 1. / (young + H);
    const Vector3 &n = flow.direction;
    const Vector3 wn = weight_.cwiseProduct(n), by_trial = c * wn.cwiseQuotient(flow.denominator);
    const Vector3 by_stress = n.cwiseQuotient(flow.denominator);
    const double resistance = share * wn.dot(by_stress) - rest * wn.dot(flow.direction_by_growth);
    const Vector3 cw = c * weight_;
    const Vector3 column =
      rest * cw.cwiseProduct(n + flow.x * flow.direction_by_growth) - share * flow.x * cw.cwiseProduct(by_stress);
    Matrix3 M = (-1. / resistance * column) * by_trial.transpose();
    M.diagonal().array() += c * (1. - flow.x * cw.array() / flow.denominator.array());
    Eigen::Map<RowMajor> result(tangent);
    const Matrix43 half = stress_ * M;
    result.noalias() = half * stress_.transpose();
    if (!third_stress_given_)
      result.topLeftCorner<3, 3>().array() += law.elastic.bulk;
  }
} // namespace deltaform
