#include <deltaform/materials/elasticity.h>
#include <deltaform/materials/material.h>
#include <deltaform/materials/read_law.h>
#include <deltaform/parameters/registry.h>

namespace deltaform
{
  namespace
  {
    /// Isotropic elasticity, linear in the logarithmic strain: see Elasticity. No history.
    class LinearElastic : public Material
    {
    public:
      explicit LinearElastic(Section &section)
        : elastic_(read_elasticity(section))
      {
      }

      const HistoryLayout &history_layout() const override
      {
        return history_;
      }

      Status update(const MaterialBatch &batch) const override
      {
        const bool strain_given = batch.third_direction == ThirdDirection::strain_given;
        for (unsigned int p = 0; p < batch.n_points; ++p)
        {
          Mandel &strain = batch.strain[p], &stress = batch.stress[p];
          if (!strain_given)
            // t3 = (K - 2/3 G) tr + 2 G e3, solved for e3
            strain[2] = (batch.third_stress[p] * elastic_.shift * (1. + elastic_.poisson) -
                         elastic_.poisson * (strain[0] + strain[1])) /
                        (1. - elastic_.poisson);
          stress = elastic_.stress(strain);
          if (!strain_given)
            stress[2] = batch.third_stress[p];
          if (!std::isfinite(stress[0] + stress[1] + stress[2] + stress[3]))
            return Status::shorten("the strain at a material point is not finite", p);
          if (batch.tangent != nullptr)
          {
            const auto &C = strain_given ? elastic_.tangent : elastic_.condensed_tangent;
            std::copy(C.begin(), C.end(), batch.tangent + p * std::size_t(16));
          }
        }
        return {};
      }

      Mandel elastic_strain(const Mandel &stress) const override
      {
        return elastic_.strain(stress);
      }

      double elastic_energy(const Mandel &stress) const override
      {
        return elastic_.energy(stress);
      }

      Mandel plastic_strain(const double *) const override
      {
        return {};
      }

      double equivalent_plastic_strain(const double *) const override
      {
        return 0.;
      }

      double shear_modulus() const override
      {
        return elastic_.shear;
      }
      double young_modulus() const override
      {
        return elastic_.young;
      }
      double poisson_ratio() const override
      {
        return elastic_.poisson;
      }

    private:
      Elasticity elastic_;
      HistoryLayout history_; ///< nothing
    };

    const Registry<Material>::Entry
      entry("linear elastic", "Isotropic, linear in the logarithmic strain", make_as<LinearElastic, Material>);
  } // namespace
} // namespace deltaform
