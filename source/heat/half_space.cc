#include <deltaform/heat/half_space.h>
#include <deltaform/parameters/scene_error.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    constexpr int last = 40; ///< the rates are 2^-40 to 2^40
    const double log2_over_pi = std::log(2.) / std::acos(-1.);

    /// ln(2)/pi times the sum of 2^(-k/2) over k > last: what is slower as well as what is faster.
    double beyond()
    {
      return log2_over_pi * std::exp2(-.5 * (last + 1)) / (1. - std::sqrt(.5));
    }
  } // namespace


  HalfSpace::HalfSpace(const double effusivity, const unsigned int n_points)
    : inverse_effusivity_(1. / effusivity), modes_{{0., beyond()}}
  {
    for (int k = -last; k <= last; ++k)
      modes_.push_back({std::exp2(k), log2_over_pi * std::exp2(.5 * k)});
    heat_.assign(n_points * modes_.size(), 0.);
    surface_.assign(n_points, 0.);
  }


  void HalfSpace::begin(const double duration)
  {
    double sum = beyond();
    for (Mode &mode : modes_)
    {
      mode.kept = std::exp(-mode.rate * duration);
      mode.taken = mode.rate > 0. ? -std::expm1(-mode.rate * duration) / mode.rate : duration;
      sum += mode.weight * mode.taken;
    }
    rise_per_flux_ = inverse_effusivity_ * sum;
  }


  double HalfSpace::rest(const unsigned int point) const
  {
    double sum = 0.;
    for (unsigned int k = 0; k < modes_.size(); ++k)
      sum += modes_[k].weight * modes_[k].kept * heat_[point * modes_.size() + k];
    return inverse_effusivity_ * sum;
  }


  std::pair<double, double>
  HalfSpace::joint(const unsigned int point, const double conductance, const double flux) const
  {
    // q = h (T - rest - a (q + flux))
    return {conductance / (1. + rise_per_flux_ * conductance), rest(point) + rise_per_flux_ * flux};
  }


  void HalfSpace::end(const std::vector<double> &flux)
  {
    for (unsigned int i = 0; i < surface_.size(); ++i)
    {
      surface_[i] = rest(i) + rise_per_flux_ * flux[i];
      for (unsigned int k = 0; k < modes_.size(); ++k)
      {
        double &heat = heat_[i * modes_.size() + k];
        heat = modes_[k].kept * heat + modes_[k].taken * flux[i];
      }
    }
  }


  void HalfSpace::transfer(const std::vector<PointOrigin> &origins)
  {
    const std::size_t n = modes_.size();
    std::vector<double> heat, surface;
    for (const auto &[a, b, share] : origins)
    {
      surface.push_back((1. - share) * surface_[a] + share * surface_[b]);
      for (std::size_t k = 0; k < n; ++k)
        heat.push_back((1. - share) * heat_[a * n + k] + share * heat_[b * n + k]);
    }
    heat_ = std::move(heat);
    surface_ = std::move(surface);
  }


  std::vector<double> HalfSpace::state() const
  {
    std::vector<double> result = surface_;
    result.insert(result.end(), heat_.begin(), heat_.end());
    return result;
  }


  void HalfSpace::set_state(const std::vector<double> &state, const unsigned int n_points)
  {
    if (state.size() != n_points * (1 + modes_.size()))
      throw SceneError("The saved state has another number of points on a tool: it is damaged. Start again.");
    surface_.assign(state.begin(), state.begin() + n_points);
    heat_.assign(state.begin() + n_points, state.end());
  }
} // namespace deltaform
