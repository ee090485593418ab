// State of the undeformed solid, and its law.
#include "solid.h"

#include <algorithm>

namespace deltaform
{
  void Solid::set_up_state()
  {
    constant_matrices_.clear();
    material_.reset(points_.size());
    if (material_.carries())
      spin_.assign(points_.size(), Turn());
    deformation_.assign(points_.size(), Deformation());
    committed_deformation_ = deformation_;
    volume_offset_.assign(points_.size(), 0.);
    plastic_metric_.assign(points_.size(), {{1., 1., 1., 0.}});
    linear_ = has_linear_law();
  }


  bool Solid::has_linear_law() const
  {
    if (finite_ || material_.plastic())
      return false;
    std::array<Mandel, 2> strain{{{}, {{1e-3, -2e-3, 5e-4, 7e-4}}}}, stress;
    std::array<double, 32> moduli;
    MaterialBatch batch;
    batch.n_points = 2;
    batch.strain = strain.data();
    batch.stress = stress.data();
    batch.tangent = moduli.data();
    const bool good = material_.law().update(batch).good();
    return good && std::equal(moduli.begin(), moduli.begin() + 16, moduli.begin() + 16);
  }


  void Solid::update_areas(const Vector &q) const
  {
    const Vector none(q.size());
    for (const auto &face : faces_)
      face.update_areas(finite_ ? q : none);
  }
} // namespace deltaform
