#include "material_points.h"
#include "usable_material.h"

#include <deltaform/base/registry.h>

#include <algorithm>

namespace deltaform
{
  MaterialPoints::MaterialPoints(Section &blank, const ThirdDirection third, const bool axisymmetric)
    : third_(third)
  {
    auto section = blank.root().sub("Material");
    law_ = Registry<Material>::choose(section, "Model", "elastoplastic", "Stress-strain law.");
    check_usable(*law_, third, axisymmetric, section);
  }


  void MaterialPoints::reset(const std::size_t n)
  {
    history_ = PointHistory(n, law_->history_layout());
    if (law_->two_steps())
      carried_ = CarriedFlow(n, law_->history_size());
    strain_.assign(n, Mandel{});
    stress_ = strain_;
    committed_stress_ = strain_;
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
    batch.duration = duration_;
    batch.carried = carried_.at(first);
    batch.trial = history_.trial(first);
    batch.stress = &stress_[first];
    batch.tangent = tangent;
    return law_->update(batch);
  }


  void MaterialPoints::commit()
  {
    carried_.keep(history_);
    history_.commit();
    // What becomes trial is overwritten before it is read, as in the history.
    committed_stress_.swap(stress_);
  }


  void MaterialPoints::set_history(const std::vector<double> &values)
  {
    std::copy(values.begin(), values.end(), history_.trial(0));
    history_.commit();
    history_.rollback();
    carried_.forget();
  }


  void MaterialPoints::add_energy(const double elastic, const double plastic, const double normal)
  {
    if (!energy_)
      return;
    energy_->elastic = elastic;
    energy_->plastic += plastic;
    energy_->normal += normal;
  }


  void MaterialPoints::put(KeyedArrays &state) const
  {
    const BlankEnergy total = energy();
    history_.put(state);
    carried_.put(state);
    if (law_->traits().needs_duration)
      state.put("duration of the last increment", duration_);
    state.put("stress", committed_stress_);
    state.put("energies", std::vector<double>{total.elastic, total.plastic, total.normal});
  }


  void MaterialPoints::take(const KeyedArrays &state)
  {
    history_.take(state);
    carried_.take(state);
    if (law_->traits().needs_duration)
      state.take("duration of the last increment", duration_);
    state.take("stress", committed_stress_);
    stress_ = committed_stress_;
    std::vector<double> energies = state.at("energies");
    energies.resize(3); // states of solids once held two
    if (energy_)
      energy_ = BlankEnergy{energies[0], energies[1], energies[2]};
  }
} // namespace deltaform
