#include <deltaform/contact/augmentation.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  Augmentation::Augmentation(const unsigned int depth, const unsigned int patience)
    : depth_(depth), patience_(patience)
  {
  }


  void Augmentation::restart()
  {
    rounds_ = 0;
    discard();
  }


  void Augmentation::discard()
  {
    last_shift_.clear();
    shift_differences_.clear();
    change_differences_.clear();
  }


  bool Augmentation::collect(const ContactInterface &interface,
                             const double relaxation,
                             Values &shifts,
                             Values &forces)
  {
    const double allowed = std::min(1., relaxation * interface.normal_law().augmentation_tolerance());
    bool exact = true;
    for (const auto &state : interface.trial())
    {
      const double force = state.touching ? std::max(state.force, 0.) : 0.;
      shifts.push_back(state.shift);
      forces.push_back(force);
      const double gap = force > 0 ? std::abs(state.gap) : std::max(-state.gap, 0.);
      exact &= !state.touching || gap <= std::max(allowed * state.delta, state.noise);
    }
    return exact;
  }


  void Augmentation::look_back(const Values &shift, const Values &change)
  {
    const auto difference = [](const Values &a, const Values &b) {
      Values result(a.size());
      std::transform(a.begin(), a.end(), b.begin(), result.begin(), std::minus<double>());
      return result;
    };
    shift_differences_.push_back(difference(shift, last_shift_));
    change_differences_.push_back(difference(change, last_change_));
    if (shift_differences_.size() > depth_)
    {
      shift_differences_.pop_front();
      change_differences_.pop_front();
    }
  }


  Augmentation::Values Augmentation::correction(const Values &change) const
  {
    const unsigned int n = change.size(), m = shift_differences_.size();
    Eigen::MatrixXd dF(n, m), dX(n, m);
    for (unsigned int k = 0; k < m; ++k)
    {
      dF.col(k) = Eigen::Map<const Eigen::VectorXd>(change_differences_[k].data(), n);
      dX.col(k) = Eigen::Map<const Eigen::VectorXd>(shift_differences_[k].data(), n);
    }
    const Eigen::Map<const Eigen::VectorXd> f(change.data(), n);
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> least_squares(dF);
    least_squares.setThreshold(1e-10);
    const Eigen::VectorXd weights = least_squares.solve(f);
    const Eigen::VectorXd result = (dX + dF) * weights;
    return Values(result.data(), result.data() + n);
  }


  unsigned int Augmentation::update(const std::vector<ContactInterface *> &interfaces)
  {
    Values shift, force;
    bool exact = true;
    const double relaxation = std::pow(10., rounds_ / patience_);
    for (const auto *interface : interfaces)
      exact &= collect(*interface, relaxation, shift, force);
    if (exact)
      return 0;
    ++rounds_;

    const unsigned int n = shift.size();
    Values change(n), next = force;
    for (unsigned int i = 0; i < n; ++i)
      change[i] = force[i] - shift[i];
    // Another set of loaded points is another fixed-point problem.
    std::vector<bool> loaded(n);
    for (unsigned int i = 0; i < n; ++i)
      loaded[i] = force[i] > 0;
    if (loaded != loaded_)
      discard();
    loaded_ = loaded;
    if (depth_ > 0 && last_shift_.size() == n)
    {
      look_back(shift, change);
      const Values less = correction(change);
      for (unsigned int i = 0; i < n; ++i)
        next[i] = force[i] > 0 ? std::max(0., force[i] - less[i]) : 0.;
    }
    last_shift_ = shift;
    last_change_ = change;
    for (unsigned int i = 0; i < n; ++i)
      if (!std::isfinite(next[i]))
        next = force;

    const double *position = next.data();
    for (auto *interface : interfaces)
      position = interface->set_shifts(position);
    return n;
  }
} // namespace deltaform
