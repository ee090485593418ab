#include "return_map.h"

#include <deltaform/base/registry.h>

#include <algorithm>
#include <array>

namespace deltaform
{
  namespace
  {
    /**
     * Metal plasticity at large strain: J2 (von Mises) yield condition in the Kirchhoff stress, associated flow,
     * isotropic hardening of any registered law, additive in the logarithmic strain:
     *
     *     tau = C : (e - e_p),   q = sqrt(3/2) |dev tau| <= flow(x),   d e_p = dx (3/2) dev tau / q,   dx >= 0.
     *
     * Integrated by backward Euler (first order in the increment; exact where the direction of flow is constant) or by
     * the two-step formula of CarriedFlow (second order), with the consistent tangent. C. Miehe, N. Apel, M. Lambrecht,
     * Anisotropic additive plasticity in the logarithmic strain space, Comput. Methods Appl. Mech. Eng. 191 (2002)
     * 5383.
     */
    class Elastoplastic : public Material
    {
    public:
      explicit Elastoplastic(Section &section)
        : elastic_(section)
      {
        Section hardening_section = section.sub("Hardening");
        hardening_ = Registry<Hardening>::choose(
          hardening_section, "Law", "swift", "Flow stress against the equivalent plastic strain.");
        initial_flow_stress_ = hardening_->evaluate(0.).value;
        two_steps_ = section.choice("Integration",
                                    "two steps",
                                    {"backward Euler", "two steps"},
                                    "Of flow over an increment. Two steps: of second order, goes on from the flow of "
                                    "the last increment.") == "two steps";
      }

      const HistoryLayout &history_layout() const override
      {
        return history_;
      }

      bool two_steps() const override
      {
        return two_steps_;
      }

      Status update(const MaterialBatch &batch) const override
      {
        const J2 j2{elastic_, *hardening_, initial_flow_stress_};
        constexpr std::size_t n = J2::n_history;
        const bool strain_given = batch.third_direction == ThirdDirection::strain_given;
        for (unsigned int p = 0; p < batch.n_points; ++p)
        {
          const double *committed = batch.committed + p * n;
          double *trial = batch.trial + p * n;
          double *tangent = batch.tangent != nullptr ? batch.tangent + p * std::size_t(16) : nullptr;
          const auto return_from = [&](const double *start) {
            return strain_given ? radial_return(j2, batch.strain[p], start, trial, batch.stress[p], tangent)
                                : plane_stress_return(
                                    j2, batch.strain[p], batch.third_stress[p], start, trial, batch.stress[p], tangent);
          };
          double *carried = batch.carried != nullptr ? batch.carried + p * n : nullptr;
          PointOutcome outcome = PointOutcome::good;
          bool goes_on = false;
          if (carried != nullptr && carried[J2::equivalent] > 0.)
          {
            std::array<double, n> start;
            for (unsigned int i = 0; i < n; ++i)
              start[i] = committed[i] + carried[i];
            outcome = return_from(start.data());
            double along = 0.;
            for (unsigned int i = 0; i < 4; ++i)
              along += carried[i] * (trial[i] - start[i]);
            goes_on = outcome == PointOutcome::good && along > 0.;
            // Decided once: points that change their minds from iteration to iteration keep Newton from converging.
            if (!goes_on)
              std::fill_n(carried, n, 0.);
          }
          // Where there is much less flow now, or none, or it has turned back, the last flow has nothing to go on with.
          if (!goes_on)
            outcome = return_from(committed);
          if (outcome == PointOutcome::not_finite)
            return Status::shorten("the strain at a material point is not finite", p);
          if (outcome == PointOutcome::not_converged)
            return Status::shorten("the yield condition at a material point could not be met", p);
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

      Mandel plastic_strain(const double *history) const override
      {
        return {{history[0], history[1], history[2], history[3]}};
      }

      double equivalent_plastic_strain(const double *history) const override
      {
        return history[J2::equivalent];
      }

      double flow_stress(const double *history) const override
      {
        return hardening_->evaluate(history[J2::equivalent]).value;
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
      HistoryLayout history_{{"plastic_strain", HistoryKind::tensor, "1"},
                             {"equivalent_plastic_strain", HistoryKind::positive, "1"}};
      std::unique_ptr<Hardening> hardening_;
      double initial_flow_stress_ = 0.;
      bool two_steps_ = false;
    };

    const Registry<Material>::Entry entry("elastoplastic",
                                          "J2 plasticity with isotropic hardening, Hencky elasticity",
                                          make_as<Elastoplastic, Material>);
  } // namespace
} // namespace deltaform
