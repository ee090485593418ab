#pragma once

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/assembly/contact_point.h>

#include <algorithm>
#include <array>

namespace deltaform
{
  /// Adds up what comes in a row for the same unknowns, as the points of an edge do: another target gets the sum.
  class GatheredRows final : public AssemblyTarget
  {
  public:
    explicit GatheredRows(AssemblyTarget &target)
      : target_(target)
    {
    }

    bool wants_tangent() const override
    {
      return target_.wants_tangent();
    }

    void add(const DofIndex *dofs, const unsigned int n, const double *matrix, const double *vector) override
    {
      Assert(n <= most, dealii::ExcInternalError());
      if (n != n_ || (matrix != nullptr) != has_matrix_ || !std::equal(dofs, dofs + n, dofs_.begin()))
      {
        flush();
        n_ = n;
        has_matrix_ = matrix != nullptr;
        std::copy_n(dofs, n, dofs_.begin());
        std::copy_n(vector, n, vector_.begin());
        if (has_matrix_)
          std::copy_n(matrix, n * n, matrix_.begin());
        return;
      }
      for (unsigned int i = 0; i < n; ++i)
        vector_[i] += vector[i];
      if (has_matrix_)
        for (unsigned int i = 0; i < n * n; ++i)
          matrix_[i] += matrix[i];
    }

    /// Hand over what is left.
    void flush()
    {
      if (n_ > 0)
        target_.add(dofs_.data(), n_, has_matrix_ ? matrix_.data() : nullptr, vector_.data());
      n_ = 0;
    }

  private:
    static constexpr unsigned int most = ContactPoint::max_dofs + 2; ///< a travel and an unknown of the law

    AssemblyTarget &target_;
    unsigned int n_ = 0; ///< unknowns; 0: nothing is there
    bool has_matrix_ = false;
    std::array<DofIndex, most> dofs_;
    std::array<double, most> vector_;
    std::array<double, most * most> matrix_;
  };
} // namespace deltaform
