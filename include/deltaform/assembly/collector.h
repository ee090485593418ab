#pragma once

#include <deltaform/assembly/assembly_target.h>

namespace deltaform
{
  /// Collects the residual of a part of the equations.
  class Collector : public AssemblyTarget
  {
  public:
    explicit Collector(const unsigned int n)
      : residual(n)
    {
    }

    void add(const DofIndex *dofs, const unsigned int n, const double *, const double *vector) override
    {
      for (unsigned int i = 0; i < n; ++i)
        residual[dofs[i]] += vector[i];
    }

    bool wants_tangent() const override
    {
      return false;
    }

    Vector residual;
  };
} // namespace deltaform
