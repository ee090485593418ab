#include <deltaform/materials/plasticity.h>

#include "general_return.h"
#include "quadratic_return.h"

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace deltaform
{
  namespace
  {
    constexpr std::array<ThirdDirection, 2> both = {{ThirdDirection::strain_given, ThirdDirection::stress_given}};

    std::size_t index(const ThirdDirection third)
    {
      return third == ThirdDirection::strain_given ? 0 : 1;
    }

    /// Laws that do nothing need no call; a hardening that knows the rate brings its own.
    FlowLaws effective(FlowLaws laws)
    {
      if (laws.back_stress && !laws.back_stress->acts())
        laws.back_stress.reset();
      if (!laws.rate_factor || !laws.rate_factor->acts())
        laws.rate_factor = laws.hardening->own_rate_factor(0.);
      if (laws.rate_factor && !laws.rate_factor->acts())
        laws.rate_factor.reset();
      return laws;
    }

    HistoryLayout layout_of(const FlowLaws &laws)
    {
      HistoryLayout layout = FlowHistory::layout();
      if (laws.back_stress)
        layout.append(laws.back_stress->history_layout());
      if (laws.rate_factor)
        layout.append(laws.rate_factor->history_layout());
      return layout;
    }
  } // namespace


  Elastoplastic::Elastoplastic(const Elasticity &elastic,
                               FlowLaws laws,
                               const Integration integration,
                               const std::optional<FallingModulus> &falling)
    : elastic_(elastic), falling_(falling), laws_(effective(std::move(laws))), integration_(integration),
      history_(layout_of(laws_)), initial_flow_stress_(laws_.hardening->evaluate(0.).value),
      rate_first_(history_.size() - (laws_.rate_factor ? laws_.rate_factor->history_layout().size() : 0))
  {
    const std::string objection =
      laws_.back_stress ? laws_.back_stress->objection(*laws_.yield_surface, *laws_.hardening) : std::string();
    if (!objection.empty())
      throw std::invalid_argument(objection);
    if (history_.size() > most_values)
      throw std::invalid_argument("the laws of a metal remember more than " + std::to_string(most_values) + " values");
    choose_return_maps();
  }


  void Elastoplastic::choose_return_maps()
  {
    for (const auto third : both)
    {
      const std::size_t i = index(third);
      map_[i] = nullptr;
      if (!laws_.yield_surface->serves(third) || (falling_ && third == ThirdDirection::strain_given))
        continue;
      if (!laws_.back_stress && !laws_.rate_factor)
        map_[i] = laws_.yield_surface->closed_form(third);
      if (map_[i] != nullptr)
        continue;
      if (QuadraticReturn::serves(laws_))
        own_[i] = std::make_unique<QuadraticReturn>(laws_, third, elastic_.poisson, history_.size());
      else
        own_[i] = std::make_unique<GeneralReturn>(laws_, third, history_.size());
      map_[i] = own_[i].get();
    }
  }


  const HistoryLayout &Elastoplastic::history_layout() const
  {
    return history_;
  }


  MaterialTraits Elastoplastic::traits() const
  {
    MaterialTraits traits;
    traits.symmetry = laws_.yield_surface->symmetry();
    traits.symmetric_tangent = !laws_.back_stress || laws_.back_stress->symmetric();
    traits.isotropic_hardening = !laws_.back_stress && !laws_.rate_factor;
    traits.needs_duration = laws_.rate_factor && laws_.rate_factor->needs_duration();
    traits.strain_given = map_[0] != nullptr;
    traits.stress_given = map_[1] != nullptr;
    traits.section = traits.strain_given && (traits.symmetry == Symmetry::isotropic ||
                                             laws_.yield_surface->in_section() != nullptr);
    return traits;
  }


  void Elastoplastic::set_axes(const PointAxes axes)
  {
    if (axes == PointAxes::sheet || laws_.yield_surface->symmetry() == Symmetry::isotropic)
      return;
    auto surface = laws_.yield_surface->in_section();
    AssertThrow(surface != nullptr, dealii::ExcMessage("This yield surface is defined in a sheet only."));
    laws_.yield_surface = std::move(surface);
    choose_return_maps();
  }


  bool Elastoplastic::two_steps() const
  {
    // The last change of the plastic strain contains that of the modulus: it is no flow that goes on.
    return integration_ == Integration::two_steps && !falling_;
  }


  std::optional<MetalHeat> Elastoplastic::heat() const
  {
    return laws_.rate_factor ? laws_.rate_factor->heat() : std::nullopt;
  }


  double Elastoplastic::first_stress(Mandel stress, const double *const committed) const
  {
    if (laws_.back_stress)
    {
      const Mandel back = laws_.back_stress->value(committed + FlowHistory::size);
      for (unsigned int i = 0; i < 4; ++i)
        stress[i] -= back[i];
    }
    return laws_.yield_surface->equivalent_stress(stress);
  }


  template <typename Size>
  Status Elastoplastic::update_points(const MaterialBatch &batch,
                                      const ReturnMap &map,
                                      const Elasticity &elastic,
                                      const Size n) const
  {
    constexpr double unknown = std::numeric_limits<double>::infinity();
    FlowLaw law{elastic, *laws_.hardening, initial_flow_stress_, batch.duration, 1., unknown};
    const bool first_matters = n > FlowHistory::size && batch.committed_stress != nullptr && laws_.rate_factor &&
                               laws_.rate_factor->knows_first_stress();
    const bool third_stress = batch.third_direction == ThirdDirection::stress_given;
    for (unsigned int p = 0; p < batch.n_points; ++p)
    {
      const double *committed = batch.committed + p * n;
      double *trial = batch.trial + p * n;
      double *tangent = batch.tangent != nullptr ? batch.tangent + p * std::size_t(16) : nullptr;
      const double given_stress = third_stress ? batch.third_stress[p] : 0.;
      const auto return_from = [&](const double *start) {
        return map.update(
          law,
          {batch.strain[p], given_stress, start, committed, trial, batch.stress[p], tangent});
      };
      double *predictor = batch.predictor != nullptr ? batch.predictor + p * n : nullptr;
      PointOutcome outcome = PointOutcome::good;
      bool goes_on = false;
      if (predictor != nullptr && predictor[FlowHistory::equivalent] > 0.)
      {
        std::array<double, most_values> start;
        for (std::size_t i = 0; i < n; ++i)
          start[i] = committed[i] + predictor[i];
        law.share = batch.duration_share;
        outcome = return_from(start.data());
        law.share = 1.;
        double along = 0.;
        for (unsigned int i = 0; i < 4; ++i)
          along += predictor[i] * (trial[i] - start[i]);
        goes_on = outcome == PointOutcome::good && along > 0.;
        // Decided once: points that change their minds from iteration to iteration keep Newton from converging.
        if (!goes_on)
          std::fill_n(predictor, std::size_t(n), 0.);
      }
      // Where there is much less flow now, or none, or it has turned back, the last flow has nothing to go on with.
      if (!goes_on)
      {
        if (first_matters)
          law.first_stress = first_stress(batch.committed_stress[p], committed);
        outcome = return_from(committed);
        law.first_stress = unknown;
      }
      if (outcome == PointOutcome::not_finite)
        return Status::shorten("the strain at a material point is not finite", p);
      if (outcome == PointOutcome::not_converged)
        return Status::shorten("the yield condition at a material point could not be met", p);
    }
    return {};
  }


  Status Elastoplastic::update(const MaterialBatch &batch) const
  {
    const ReturnMap *map = map_[index(batch.third_direction)];
    AssertThrow(map != nullptr,
                dealii::ExcMessage("This yield surface does not know what is asked of the third direction."));
    AssertThrow(!laws_.rate_factor || !laws_.rate_factor->needs_duration() || batch.duration > 0.,
                dealii::ExcMessage("The rate factor wants to know how long the increment takes."));
    if (falling_)
      return update_falling(batch, *map);
    if (history_.size() == FlowHistory::size)
      return update_points(batch, *map, elastic_, std::integral_constant<std::size_t, FlowHistory::size>());
    return update_points(batch, *map, elastic_, std::size_t(history_.size()));
  }


  Elasticity Elastoplastic::elasticity(const double *const history) const
  {
    if (!falling_)
      return elastic_;
    return {(*falling_)(elastic_.young, history[FlowHistory::equivalent]), elastic_.poisson};
  }


  Status Elastoplastic::update_falling(const MaterialBatch &batch, const ReturnMap &map) const
  {
    // The modulus of the begin holds over the increment. At its end the plastic strain is measured again, from the same
    // stress by the modulus that is left: the stress does not know of the change.
    const std::size_t n = history_.size();
    for (unsigned int p = 0; p < batch.n_points; ++p)
    {
      MaterialBatch one = batch;
      one.n_points = 1;
      one.strain += p;
      one.third_stress += p;
      one.committed += p * n;
      one.predictor += batch.predictor != nullptr ? p * n : 0;
      one.trial += p * n;
      one.committed_stress += batch.committed_stress != nullptr ? p : 0;
      one.stress += p;
      one.tangent += batch.tangent != nullptr ? p * std::size_t(16) : 0;
      Status status = update_points(one, map, elasticity(one.committed), n);
      if (!status.good())
      {
        status.place = p;
        return status;
      }
      if (one.trial[FlowHistory::equivalent] == one.committed[FlowHistory::equivalent])
        continue;
      const Mandel elastic = elasticity(one.trial).strain(*one.stress);
      for (unsigned int k = 0; k < 4; ++k)
        one.trial[k] = (*one.strain)[k] - elastic[k];
    }
    return {};
  }


  Mandel Elastoplastic::elastic_strain(const Mandel &stress) const
  {
    return elastic_.strain(stress);
  }


  double Elastoplastic::elastic_energy(const Mandel &stress) const
  {
    return elastic_.energy(stress);
  }


  double Elastoplastic::stored_energy(const Mandel &stress, const double *const history) const
  {
    return falling_ ? elasticity(history).energy(stress) : elastic_.energy(stress);
  }


  Mandel Elastoplastic::plastic_strain(const double *history) const
  {
    return {{history[0], history[1], history[2], history[3]}};
  }


  double Elastoplastic::equivalent_plastic_strain(const double *history) const
  {
    return history[FlowHistory::equivalent];
  }


  double Elastoplastic::flow_stress(const double *history) const
  {
    const double strain = history[FlowHistory::equivalent], slow = laws_.hardening->evaluate(strain).value;
    if (!laws_.rate_factor)
      return slow;
    return laws_.rate_factor->at_rest(slow, strain, history + rate_first_);
  }


  double Elastoplastic::shear_modulus() const
  {
    return elastic_.shear;
  }


  double Elastoplastic::young_modulus() const
  {
    return elastic_.young;
  }


  double Elastoplastic::poisson_ratio() const
  {
    return elastic_.poisson;
  }
} // namespace deltaform
