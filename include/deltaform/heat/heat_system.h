#pragma once

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/assembly/types.h>

#include <vector>

namespace deltaform
{
  /**
   * The linear system of an increment of heat, symmetric and positive definite. The cells of a process come first;
   * after share() all processes hold the same system, add to it what they all know, and solve it. A plane mesh has so
   * few nodes that this costs less than to distribute it.
   */
  class HeatSystem : public AssemblyTarget
  {
  public:
    /// Of vectors with @p n values.
    explicit HeatSystem(const DofIndex n)
      : residual_(n)
    {
    }

    void add(const DofIndex *dofs, unsigned int n, const double *matrix, const double *vector) override;

    bool wants_tangent() const override
    {
      return true;
    }

    /// Add what the cells of all processes have.
    void share();

    /// @return - matrix^-1 residual; 0 at places to which nobody has added
    Vector solve() const;

  private:
    struct Entry
    {
      DofIndex row, column;
      double value;
    };

    std::vector<Entry> entries_;
    Vector residual_;
  };
} // namespace deltaform
