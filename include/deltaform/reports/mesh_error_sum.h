#pragma once

#include <limits>

namespace deltaform
{
  class AcceptedIncrement;

  /// Does the mesh of a solid resolve how the metal flows? Work and error of Fields::mesh_error() over a run, of fifty
  /// increments of a stage at most: an estimate takes a few hundredths of an increment.
  class MeshErrorSum
  {
  public:
    void add(const AcceptedIncrement &increment);

    /// Estimated error over the plastic work; negative where there is no estimate.
    double share() const
    {
      return work_ > 0. ? error_ / work_ : -1.;
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive &work_ &error_ &last_;
    }

  private:
    double work_ = 0., error_ = 0.; ///< of the increments that were looked at (force*length)
    double last_ = -std::numeric_limits<double>::infinity(); ///< time of the last of them
  };
} // namespace deltaform
