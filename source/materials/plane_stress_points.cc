#include "plane_stress_points.h"

namespace deltaform
{
  PlaneStressPoints::PlaneStressPoints(const Material &law, const unsigned int n)
    : law_(law), strain_(n), accepted_strain_(n), stress_(n), tangent_(16 * n), no_stress_(n, 0.),
      committed_(n * law.history_size(), 0.), trial_(committed_)
  {
  }


  bool PlaneStressPoints::update()
  {
    MaterialBatch batch;
    batch.n_points = static_cast<unsigned int>(strain_.size());
    batch.third_direction = ThirdDirection::stress_given;
    batch.strain = strain_.data();
    batch.third_stress = no_stress_.data();
    batch.duration = 1.;
    batch.committed = committed_.data();
    batch.trial = trial_.data();
    batch.stress = stress_.data();
    batch.tangent = tangent_.data();
    return law_.update(batch).good();
  }


  void PlaneStressPoints::accept()
  {
    accepted_strain_ = strain_;
    committed_ = trial_;
  }


  double PlaneStressPoints::equivalent_plastic_strain(const unsigned int point) const
  {
    return law_.equivalent_plastic_strain(&committed_[point * law_.history_size()]);
  }
} // namespace deltaform
