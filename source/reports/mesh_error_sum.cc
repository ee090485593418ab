#include <deltaform/reports/accepted_increment.h>
#include <deltaform/reports/mesh_error_sum.h>

namespace deltaform
{
  void MeshErrorSum::add(const AcceptedIncrement &increment)
  {
    constexpr double samples = 50.;
    if (increment.time < last_ + (increment.stage.end - increment.stage.begin) / samples)
      return;
    last_ = increment.time;
    const MeshError &now = increment.mesh_error();
    work_ += now.work;
    error_ += now.error;
  }
} // namespace deltaform
