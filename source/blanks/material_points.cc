#include "material_points.h"
#include "usable_material.h"

#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <algorithm>
#include <array>

namespace deltaform
{
  MaterialPoints::MaterialPoints(Section &blank, const ThirdDirection third, const bool axisymmetric)
    : third_(third)
  {
    auto section = blank.root().sub("Material");
    law_ = Registry<Material>::choose(section, "Model", "elastoplastic", "Stress-strain law.");
    check_usable(*law_, third, axisymmetric, section);
    criteria_ = std::make_unique<PointCriteria>(blank.root(),
                                                PointFieldHost{*law_, third == ThirdDirection::stress_given});
    if (third == ThirdDirection::stress_given)
      return; // the axes of a shell are those of the sheet
    has_axes_ = law_->traits().symmetry != Symmetry::isotropic;
    for (const auto &field : law_->history_layout().fields())
      has_axes_ = has_axes_ || (field.kind == HistoryKind::tensor && field.name != "plastic_strain");
    law_->set_axes(PointAxes::section);
  }


  void MaterialPoints::reset(const std::size_t n)
  {
    history_ = PointHistory(n, law_->history_layout());
    if (law_->two_steps())
      predictor_ = Bdf2Predictor(n, law_->history_size());
    strain_.assign(n, Mandel{});
    stress_ = strain_;
    committed_stress_ = strain_;
    criteria_->reset(n);
    axes_.assign(has_axes_ ? n : 0, MetalAxes());
    stress_by_angle_.assign(axes_.size(), Mandel{});
  }


  double MaterialPoints::initial_flow_stress() const
  {
    const std::vector<double> history(law_->history_size(), 0.);
    return law_->flow_stress(history.data());
  }


  Status MaterialPoints::update(const std::size_t first,
                                const unsigned int n,
                                double *const tangent,
                                const double *const third_stress)
  {
    MaterialBatch batch;
    batch.n_points = n;
    batch.third_direction = third_;
    batch.strain = &strain_[first];
    batch.third_stress = third_stress;
    batch.committed = history_.committed(first);
    // That of axes of its own would have to turn with them.
    batch.committed_stress = has_axes_ ? nullptr : &committed_stress_[first];
    batch.duration = duration();
    batch.duration_share = predictor_.duration_share();
    batch.predictor = predictor_.at(first);
    batch.trial = history_.trial(first);
    batch.stress = &stress_[first];
    batch.tangent = tangent;
    return has_axes_ ? update_in_axes(batch, first) : law_->update(batch);
  }


  Status MaterialPoints::update_in_axes(MaterialBatch batch, const std::size_t first)
  {
    // The stress Q t(Q^T e Q) Q^T depends on the angle of Q through both: at a fixed elastic strain e of r and z its
    // derivative is W t - t W - C : (W e - e W), W the spin.
    constexpr unsigned int most_points = 16;
    std::array<Mandel, most_points> strain;
    Assert(batch.n_points <= most_points, dealii::ExcInternalError());
    for (unsigned int p = 0; p < batch.n_points; ++p)
      strain[p] = axes_[first + p].into(strain_[first + p]);
    batch.strain = strain.data();
    const Status status = law_->update(batch);
    if (!status.good())
      return status;
    for (unsigned int p = 0; p < batch.n_points; ++p)
    {
      const std::size_t i = first + p;
      stress_[i] = axes_[i].out_of(stress_[i]);
      if (batch.tangent == nullptr)
        continue;
      double *const moduli = batch.tangent + 16 * p;
      axes_[i].turn_out(moduli);
      Mandel elastic = strain_[i];
      const Mandel plastic = plastic_strain(i);
      for (unsigned int k = 0; k < 4; ++k)
        elastic[k] -= plastic[k];
      const Mandel of_strain = MetalAxes::spin(elastic);
      stress_by_angle_[i] = MetalAxes::spin(stress_[i]);
      for (unsigned int k = 0; k < 4; ++k)
        for (unsigned int j = 0; j < 4; ++j)
          stress_by_angle_[i][k] -= moduli[4 * k + j] * of_strain[j];
    }
    return {};
  }


  double MaterialPoints::dissipation_of_stiffness(const std::size_t point) const
  {
    if (flow(point) == 0.)
      return 0.;
    // The energy is quadratic in the stress: the mixed term is that of the sum without those of both.
    const auto freed = [&](const Mandel &stress) {
      return law_->stored_energy(stress, history_.trial(point)) -
             law_->stored_energy(stress, history_.committed(point));
    };
    const Mandel &start = committed_stress_[point], &end = stress_[point];
    const double of_end = freed(end);
    if (of_end == 0.)
      return 0.;
    Mandel sum = start;
    for (unsigned int k = 0; k < 4; ++k)
      sum[k] += end[k];
    return .5 * (freed(sum) - freed(start) - of_end);
  }


  void MaterialPoints::commit()
  {
    if (criteria_->n_fields() > 0)
      grow_criteria();
    predictor_.keep(history_);
    history_.commit();
    // What becomes trial is overwritten before it is read, as in the history.
    committed_stress_.swap(stress_);
  }


  void MaterialPoints::grow_criteria()
  {
    const HistoryField *const rise = law_->history_layout().find("temperature_rise");
    for (std::size_t i = 0; i < size(); ++i)
    {
      // What had no stress has flown under that of the end.
      const Mandel &start = committed_stress_[i] == Mandel{} ? stress_[i] : committed_stress_[i];
      PointStep step{start, stress_[i], trial_plastic_strain(i), flow(i)};
      if (step.equivalent <= 0.)
        continue;
      const Mandel before = plastic_strain(i);
      for (unsigned int k = 0; k < 4; ++k)
        step.flow[k] -= before[k];
      if (rise != nullptr)
        step.warming = history_.trial(i)[rise->first] - history_.committed(i)[rise->first];
      criteria_->grow(i, step);
    }
  }


  void MaterialPoints::set_history(const std::vector<double> &values)
  {
    std::copy(values.begin(), values.end(), history_.trial(0));
    history_.commit();
    history_.rollback();
    predictor_.discard();
  }


  void MaterialPoints::put(KeyedArrays &state) const
  {
    each_array(*this, PutInto(state));
    account_.put(state);
  }


  void MaterialPoints::take(const KeyedArrays &state)
  {
    each_array(*this, TakeFrom(state));
    predictor_.pause();
    stress_ = committed_stress_;
    account_.take(state);
  }
} // namespace deltaform
