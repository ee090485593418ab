#include "plane_stress_points.h"

#include <deltaform/materials/repeated_bending.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    /// A cross-section of unit width, bent and stretched in plane strain.
    class StripSection
    {
    public:
      StripSection(const Material &law, const double thickness, const StripThickness change)
        : metal_(law, n_points), rule_(n_points), initial_thickness_(thickness), change_(change),
          tolerance_(1e-9 * law.young_modulus() * thickness)
      {
      }

      /// Bend to @p curvature under the @p tension (force per width). @return can it be carried?
      bool bend(const double curvature, const double tension)
      {
        constexpr unsigned int most_iterations = 50;
        for (unsigned int iteration = 0; iteration < most_iterations; ++iteration)
        {
          double stiffness = 0.;
          if (!evaluate(curvature, stiffness) || !(stiffness > 0.))
            return false;
          if (std::abs(force_ - tension) < tolerance_)
          {
            metal_.accept();
            return true;
          }
          stretch_ += (tension - force_) / stiffness;
        }
        return false;
      }

      /// Of the last curvature, per width.
      double moment() const
      {
        return moment_;
      }

    private:
      static constexpr unsigned int n_points = 64; // the stress has kinks: 32 are off by 2e-3

      bool evaluate(const double curvature, double &stiffness)
      {
        const double thickness =
          initial_thickness_ * (change_ == StripThickness::follows ? std::exp(-stretch_) : 1.);
        const auto y = [&](const unsigned int p) { return thickness * (rule_.point(p)[0] - .5); };
        for (unsigned int p = 0; p < n_points; ++p)
          metal_.strain(p) = {{stretch_ + y(p) * curvature, 0., 0., 0.}};
        if (!metal_.update())
          return false;
        force_ = moment_ = 0.;
        for (unsigned int p = 0; p < n_points; ++p)
        {
          const double weight = thickness * rule_.weight(p);
          force_ += weight * metal_.stress(p)[0];
          moment_ += weight * metal_.stress(p)[0] * y(p);
          stiffness += weight * metal_.tangent(p)[0];
        }
        if (change_ == StripThickness::follows)
          stiffness -= force_;
        return true;
      }

      PlaneStressPoints metal_;
      dealii::QGauss<1> rule_;
      double initial_thickness_;
      StripThickness change_;
      double tolerance_, stretch_ = 0., force_ = 0., moment_ = 0.;
    };
  } // namespace


  std::optional<double> drawing_force(const Material &law,
                                      const double thickness,
                                      const std::vector<double> &radii,
                                      const StripThickness change)
  {
    constexpr unsigned int n_steps = 100; // of a bending or straightening
    StripSection section(law, thickness, change);
    double tension = 0., sense = 1.;
    for (const double radius : radii)
    {
      for (unsigned int step = 1; step <= 2 * n_steps; ++step)
      {
        const double share = 1. - std::abs(1. - static_cast<double>(step) / n_steps);
        const double bent = (step <= n_steps ? sense : -sense) / (radius * n_steps), before = section.moment();
        if (!section.bend(sense * share / radius, tension))
          return std::nullopt;
        tension += .5 * (before + section.moment()) * bent;
      }
      sense = -sense;
    }
    return tension;
  }
} // namespace deltaform
