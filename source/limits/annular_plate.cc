#include <deltaform/limits/annular_plate.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    using Form = Eigen::MatrixXd;
    using ShapeFunctions = Eigen::Vector4d;

    /// Cubic functions of one element: by value and slope of both ends.
    struct Cubic
    {
      ShapeFunctions value, slope, curvature;

      Cubic(const double x, const double h)
        : value(1. - 3. * x * x + 2. * x * x * x, h * x * (1. - x) * (1. - x), x * x * (3. - 2. * x),
                h * x * x * (x - 1.)),
          slope(6. * x * (x - 1.) / h, 1. - 4. * x + 3. * x * x, 6. * x * (1. - x) / h, x * (3. * x - 2.)),
          curvature((12. * x - 6.) / (h * h), (6. * x - 4.) / h, (6. - 12. * x) / (h * h), (6. * x - 2.) / h)
      {
      }
    };

    RingPoint at(const std::vector<RingPoint> &ring, const double r)
    {
      auto above = std::upper_bound(ring.begin() + 1, ring.end() - 1, r,
                                    [](const double value, const RingPoint &point) { return value < point.r; });
      const RingPoint &a = *(above - 1), &b = *above;
      const double share = (r - a.r) / (b.r - a.r);
      const auto mean = [share](const double x, const double y) { return (1. - share) * x + share * y; };
      return {r, mean(a.radial, b.radial), mean(a.hoop, b.hoop), mean(a.stiffness, b.stiffness)};
    }

    /// Bending and work of the forces for a number of waves, without the factor pi.
    class PlateForms
    {
    public:
      PlateForms(const std::vector<RingPoint> &ring, const double nu)
        : nu_(nu)
      {
        const double inner = ring.front().r, h = (ring.back().r - inner) / n_elements;
        const dealii::QGauss<1> rule(4);
        for (unsigned int e = 0; e < n_elements; ++e)
          for (unsigned int g = 0; g < rule.size(); ++g)
          {
            const double x = rule.point(g)[0];
            points_.push_back({e, rule.weight(g) * h, Cubic(x, h), at(ring, inner + (e + x) * h)});
          }
      }

      void assemble(const unsigned int waves, Form &bending, Form &work) const
      {
        const double n = waves;
        bending = work = Form::Zero(2 * n_elements + 2, 2 * n_elements + 2);
        for (const auto &[element, weight, shape, ring] : points_)
        {
          const double r = ring.r, w = weight * r;
          const ShapeFunctions hoop = shape.slope / r - n * n / (r * r) * shape.value;
          const ShapeFunctions twist = n * (shape.slope / r - shape.value / (r * r));
          const ShapeFunctions &radial = shape.curvature;
          bending.block<4, 4>(2 * element, 2 * element) +=
            w * ring.stiffness *
            (radial * radial.transpose() + hoop * hoop.transpose() +
             nu_ * (radial * hoop.transpose() + hoop * radial.transpose()) +
             2. * (1. - nu_) * twist * twist.transpose());
          work.block<4, 4>(2 * element, 2 * element) -=
            w * (ring.radial * shape.slope * shape.slope.transpose() +
                 ring.hoop * n * n / (r * r) * shape.value * shape.value.transpose());
        }
        // Hinged at the inner edge.
        const Eigen::Index size = bending.rows() - 1;
        bending = Form(bending.bottomRightCorner(size, size));
        work = Form(work.bottomRightCorner(size, size));
      }

    private:
      static constexpr unsigned int n_elements = 16;

      struct Point
      {
        unsigned int element;
        double weight;
        Cubic shape;
        RingPoint ring;
      };

      double nu_;
      std::vector<Point> points_;
    };
  } // namespace


  Wrinkles wrinkle(const std::vector<RingPoint> &ring, const double poisson_ratio, const double height)
  {
    constexpr unsigned int most_waves = 60;
    const PlateForms forms(ring, poisson_ratio);
    const double area = ring.back().r * ring.back().r - ring.front().r * ring.front().r; // over pi
    Wrinkles result;
    Form bending, work;
    for (unsigned int waves = 1; waves <= most_waves; ++waves)
    {
      forms.assemble(waves, bending, work);
      const Eigen::GeneralizedSelfAdjointEigenSolver<Form> modes(work, bending);
      const Eigen::Index last = modes.eigenvalues().size() - 1;
      const double ratio = modes.eigenvalues()[last];
      if (ratio > 0. && 1. / ratio < result.factor)
      {
        result.factor = 1. / ratio;
        result.waves = waves;
      }
      // Shapes have unit energy of bending; deflections are every other unknown.
      double deflection = 0.;
      for (Eigen::Index i = 1; i <= last; i += 2)
        deflection = std::max(deflection, std::abs(modes.eigenvectors()(i, last)));
      result.pressure = std::max(result.pressure, height * (ratio - 1.) / (8. * area * deflection * deflection));
    }
    return result;
  }
} // namespace deltaform
