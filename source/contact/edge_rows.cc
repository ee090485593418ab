#include <deltaform/contact/edge_rows.h>

#include <algorithm>

namespace deltaform
{
  void EdgeRows::begin(const bool tangent)
  {
    tangent_ = tangent;
    blocks_.clear();
  }


  void EdgeRows::add(const DofIndex *dofs, const unsigned int n, const double *matrix, const double *vector)
  {
    Assert(n <= most, dealii::ExcInternalError());
    const bool has_matrix = matrix != nullptr;
    if (blocks_.empty() || blocks_.back().n != n || blocks_.back().has_matrix != has_matrix ||
        !std::equal(dofs, dofs + n, blocks_.back().dofs.begin()))
    {
      Block &block = blocks_.emplace_back();
      block.n = n;
      block.has_matrix = has_matrix;
      std::copy_n(dofs, n, block.dofs.begin());
      std::copy_n(vector, n, block.vector.begin());
      if (has_matrix)
        std::copy_n(matrix, n * n, block.matrix.begin());
      return;
    }
    Block &block = blocks_.back();
    for (unsigned int i = 0; i < n; ++i)
      block.vector[i] += vector[i];
    if (has_matrix)
      for (unsigned int i = 0; i < n * n; ++i)
        block.matrix[i] += matrix[i];
  }


  void EdgeRows::add_to(AssemblyTarget &target) const
  {
    for (const Block &block : blocks_)
      target.add(block.dofs.data(), block.n, block.has_matrix ? block.matrix.data() : nullptr, block.vector.data());
  }
} // namespace deltaform
