#pragma once

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/assembly/contact_point.h>

#include <array>
#include <vector>

namespace deltaform
{
  /// What the points of an edge add to residual and tangent, those with the same unknowns as one block. As long as
  /// nothing moves and the same points touch it is added again as it is.
  class EdgeRows final : public AssemblyTarget
  {
  public:
    /// The points follow. @p tangent: is that of the pass wanted?
    void begin(bool tangent);

    bool wants_tangent() const override
    {
      return tangent_;
    }

    void add(const DofIndex *dofs, unsigned int n, const double *matrix, const double *vector) override;

    void add_to(AssemblyTarget &target) const;

  private:
    static constexpr unsigned int most = ContactPoint::max_dofs + 2; ///< a travel and an unknown of the law

    struct Block
    {
      Block()
      {
        // Only what is used of the arrays is written: to clear them first took half of the time of add().
      }

      unsigned int n = 0; ///< unknowns
      bool has_matrix = false;
      std::array<DofIndex, most> dofs;
      std::array<double, most> vector;
      std::array<double, most * most> matrix;
    };

    bool tangent_ = false;
    std::vector<Block> blocks_;
  };
} // namespace deltaform
