#include "virgin_metal.h"

#include <vector>

namespace deltaform
{
  Status VirginMetal::evaluate(Mandel strain, const double third_stress, Answer &answer) const
  {
    const Material &law = material_.law();
    const unsigned int n = law.history_size();
    std::vector<double> history(2ul * n, 0.); // before, which stays zero, and after
    MaterialBatch batch;
    batch.n_points = 1;
    batch.third_direction = ThirdDirection::stress_given;
    batch.strain = &strain;
    batch.third_stress = &third_stress;
    batch.committed = history.data();
    batch.duration = material_.duration();
    batch.trial = history.data() + n;
    batch.stress = &answer.stress;
    batch.tangent = answer.moduli.data();
    const Status status = law.update(batch);
    answer.flow = law.equivalent_plastic_strain(batch.trial);
    answer.plastic = law.plastic_strain(batch.trial);
    return status;
  }
} // namespace deltaform
