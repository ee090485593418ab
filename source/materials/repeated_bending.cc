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
        : law_(law), rule_(n_points), initial_thickness_(thickness), change_(change), strain_(n_points),
          stress_(n_points),
          tangent_(16 * n_points), no_stress_(n_points, 0.), committed_(n_points * law.history_size(), 0.),
          trial_(committed_)
      {
      }

      /// Bend to @p curvature under the @p tension (force per width). @return can it be carried?
      bool bend(const double curvature, const double tension)
      {
        constexpr unsigned int most_iterations = 50;
        const double tolerance = 1e-9 * law_.young_modulus() * initial_thickness_;
        for (unsigned int iteration = 0; iteration < most_iterations; ++iteration)
        {
          double stiffness = 0.;
          if (!evaluate(curvature, stiffness) || !(stiffness > 0.))
            return false;
          if (std::abs(force_ - tension) < tolerance)
          {
            committed_ = trial_;
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
          strain_[p] = {{stretch_ + y(p) * curvature, 0., 0., 0.}};
        MaterialBatch batch;
        batch.n_points = n_points;
        batch.third_direction = ThirdDirection::stress_given;
        batch.strain = strain_.data();
        batch.third_stress = no_stress_.data();
        batch.committed = committed_.data();
        batch.duration = 1.;
        batch.trial = trial_.data();
        batch.stress = stress_.data();
        batch.tangent = tangent_.data();
        if (!law_.update(batch).good())
          return false;
        force_ = moment_ = 0.;
        for (unsigned int p = 0; p < n_points; ++p)
        {
          const double weight = thickness * rule_.weight(p);
          force_ += weight * stress_[p][0];
          moment_ += weight * stress_[p][0] * y(p);
          stiffness += weight * tangent_[16 * p];
        }
        if (change_ == StripThickness::follows)
          stiffness -= force_;
        return true;
      }

      const Material &law_;
      dealii::QGauss<1> rule_;
      double initial_thickness_;
      StripThickness change_;
      double stretch_ = 0., force_ = 0., moment_ = 0.;
      std::vector<Mandel> strain_, stress_;
      std::vector<double> tangent_, no_stress_, committed_, trial_;
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
