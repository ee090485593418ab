#include <deltaform/assembly/collector.h>

#include <deltaform/loads/load.h>
#include <deltaform/loads/load_way.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    /// Collects the residual R of a load and K^T q of its tangent K.
    class TransposedProduct : public AssemblyTarget
    {
    public:
      explicit TransposedProduct(const Vector &q)
        : residual(q.size()), product(q.size()), q_(q)
      {
      }

      void add(const DofIndex *dofs, const unsigned int n, const double *matrix, const double *vector) override
      {
        for (unsigned int i = 0; i < n; ++i)
        {
          residual[dofs[i]] += vector[i];
          for (unsigned int j = 0; matrix != nullptr && j < n; ++j)
            product[dofs[j]] += matrix[i * n + j] * q_[dofs[i]];
        }
      }

      bool wants_tangent() const override
      {
        return true;
      }

      Vector residual, product;

    private:
      const Vector &q_;
    };
  } // namespace


  LoadWay::LoadWay(const Load &load, const Vector &q)
    : load_(load), q_(q), gradient_(q.size())
  {
    for (const double s : {.5 - std::sqrt(3.) / 6., .5 + std::sqrt(3.) / 6.})
    {
      Vector on_the_way = q;
      on_the_way *= s;
      TransposedProduct unit(q);
      load.add(on_the_way, 1., unit);
      value_ -= .5 * (unit.residual * q);
      gradient_.add(-.5, unit.residual, -.5 * s, unit.product);
    }
  }


  void LoadWay::assemble(const double prescribed, AssemblyTarget &target) const
  {
    const DofIndex size = load_.unknown();
    // Only their difference: were both added, their magnitude would hide the forces of the blank.
    const double residual = prescribed - value_, zero = 0.;
    target.add(&size, 1, target.wants_tangent() ? &zero : nullptr, &residual);
    if (!target.wants_tangent())
      return;
    Collector unit(q_.size());
    load_.add(q_, 1., unit);
    for (DofIndex i = 0; i < q_.size(); ++i)
      if (unit.residual[i] != 0. || gradient_[i] != 0.)
      {
        const DofIndex dofs[] = {i, size};
        const double matrix[] = {0., unit.residual[i], -gradient_[i], 0.}, none[] = {0., 0.};
        target.add(dofs, 2, matrix, none);
      }
  }
} // namespace deltaform
