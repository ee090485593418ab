// The shell against thin-plate and thin-shell solutions: no locking at a fixed coarse mesh, orders of convergence.
// Small displacements: one linear solve from the initial state.
#include "any_blank.h"

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double E = 2e5, nu = .3, PI = dealii::numbers::PI;

  std::unique_ptr<Blank>
  make_shell(const unsigned int degree, const unsigned int n, const double thickness, const Entries &more)
  {
    Entries entries = {"Material/Model=linear elastic",
                       "Material/Young's modulus=2e5",
                       "Material/Poisson's ratio=.3",
                       "Blank/Layers=2", // exact for a linear distribution
                       "Blank/Degree=" + std::to_string(degree),
                       "Blank/Elements=" + std::to_string(n)};
    std::ostringstream h;
    h << "Blank/Thickness=" << std::setprecision(17) << thickness;
    entries.push_back(h.str());
    entries.insert(entries.end(), more.begin(), more.end());
    return make_blank("shell", entries);
  }

  /// Displacements from K(0) q = f with some unknowns held.
  Eigen::VectorXd solve(Blank &blank, Eigen::VectorXd force, std::vector<DofIndex> held)
  {
    DenseTarget target(blank.n_dofs());
    assemble(blank, Vector(blank.n_dofs()), target);
    for (const auto dof : blank.fixed_dofs())
      held.push_back(dof);
    for (const auto dof : held)
    {
      target.matrix.row(dof).setZero();
      target.matrix.col(dof).setZero();
      target.matrix(dof, dof) = E;
      force[dof] = 0.;
    }
    return target.matrix.partialPivLu().solve(force);
  }

  Eigen::VectorXd pressure_load(Blank &blank, const double pressure)
  {
    DenseTarget target(blank.n_dofs(), false);
    const Boundary &boundary = blank.boundary();
    boundary.assemble_pressure(Vector(blank.n_dofs()), boundary.faces().front(), pressure, true, target);
    return -target.residual;
  }

  std::vector<DofIndex> all_of(const Blank &blank, const std::string &boundary)
  {
    std::vector<DofIndex> result;
    for (const auto component : {Component::r, Component::z, Component::rotation})
      result.push_back(blank.boundary().dofs(boundary, component).front());
    return result;
  }

  /// Deflection of a clamped circular plate of radius 1 under pressure over that of a thin plate.
  double circular_plate(const unsigned int degree, const unsigned int n, const double t)
  {
    const auto blank = make_shell(degree, n, t, {"Blank/Points=0 0; 1 0"});
    const double D = E * t * t * t / (12. * (1. - nu * nu)), p = 64. * D;
    const auto q = solve(*blank, pressure_load(*blank, p), all_of(*blank, "end"));
    return q[blank->boundary().dofs("start", Component::z).front()];
  }

  /// The same with Mindlin's shear: exact for the equations that the elements discretize.
  double mindlin_plate(const double t)
  {
    const double D = E * t * t * t / (12. * (1. - nu * nu)), G = E / (2. * (1. + nu));
    return 1. + 64. * D / (4. * 5. / 6. * G * t);
  }

  /// Shortening of a ring in plane strain (quarter, radius 1) between two point loads over (pi/4 - 2/pi) P R^3 / (E'
  /// I).
  double pinched_ring(const unsigned int degree, const unsigned int n, const double t)
  {
    const auto blank = make_shell(
      degree, n, t, {"Blank/Symmetry=plane strain", "Blank/Points=1 0; 1 1; 0 1", "Blank/Fillet radii=0, 1, 0"});
    const double bending = E * t * t * t / (12. * (1. - nu * nu));
    Eigen::VectorXd force = Eigen::VectorXd::Zero(blank->n_dofs());
    const auto top = blank->boundary().dofs("end", Component::z).front();
    force[top] = -.5 * bending;
    const auto q = solve(*blank,
                         force,
                         {blank->boundary().dofs("start", Component::z).front(),
                          blank->boundary().dofs("start", Component::rotation).front(),
                          blank->boundary().dofs("end", Component::r).front(),
                          blank->boundary().dofs("end", Component::rotation).front()});
    return -2. * q[top] / (PI / 4. - 2. / PI);
  }

  /// Radial displacement of the loaded edge of a long cylinder (radius 1) over that of thin-shell theory, Q / (2 b^3
  /// D).
  double edge_of_a_cylinder(const unsigned int degree, const unsigned int n, const double t)
  {
    const double D = E * t * t * t / (12. * (1. - nu * nu)), b = std::pow(3. * (1. - nu * nu), .25) / std::sqrt(t);
    std::ostringstream points;
    points << "Blank/Points=1 0; 1 " << std::setprecision(17) << 8. / b;
    const auto blank = make_shell(degree, n, t, {points.str(), "Blank/Grading=.1 + t"});
    Eigen::VectorXd force = Eigen::VectorXd::Zero(blank->n_dofs());
    const auto edge = blank->boundary().dofs("start", Component::r).front();
    force[edge] = 2. * PI * 2. * b * b * b * D;
    return solve(*blank, force, {blank->boundary().dofs("end", Component::z).front()})[edge];
  }

  using Problem = double (*)(unsigned int degree, unsigned int n, double t);
} // namespace

BOOST_AUTO_TEST_SUITE(shell_benchmarks)

BOOST_AUTO_TEST_CASE(thin_shells_do_not_lock)
{
  // A coarse mesh is as good at t/R = 1e-3 as at 1e-2: an element that locks is off by a factor of hundreds.
  struct Case
  {
    const char *name;
    Problem problem;
    double tolerance[2];
  };
  for (const Case &what : {Case{"clamped circular plate", &circular_plate, {1e-2, 1e-3}},
                           Case{"pinched ring", &pinched_ring, {2e-2, 1e-3}},
                           Case{"edge of a cylinder", &edge_of_a_cylinder, {5e-2, 5e-3}}})
    for (const unsigned int degree : {1, 2})
      BOOST_TEST_CONTEXT(what.name << ", degree " << degree)
      {
        const double thin = what.problem(degree, 16, 1e-3), thick = what.problem(degree, 16, 1e-2);
        BOOST_TEST_MESSAGE(what.name << ", degree " << degree << ": " << thin << " " << thick);
        BOOST_TEST(std::abs(thin - 1.) < what.tolerance[degree - 1]);
        BOOST_TEST(std::abs(thin - thick) < 2e-2);
      }
}

BOOST_AUTO_TEST_CASE(order_of_convergence)
{
  const double t = .1;
  const double exact = mindlin_plate(t);
  const auto order_of = [&](const unsigned int degree, const unsigned int n) {
    const double coarse = std::abs(circular_plate(degree, n, t) - exact);
    const double fine = std::abs(circular_plate(degree, 2 * n, t) - exact);
    BOOST_TEST_MESSAGE("degree " << degree << ", " << n << " elements: error " << coarse << ", order "
                                 << std::log2(coarse / fine));
    return std::log2(coarse / fine);
  };
  BOOST_TEST(order_of(1, 8) > 1.85);
  BOOST_TEST(order_of(1, 32) > 1.9);
  BOOST_TEST(order_of(2, 4) > 3.7);
  BOOST_TEST(order_of(2, 8) > 3.7);
}

BOOST_AUTO_TEST_CASE(order_of_convergence_on_an_arc)
{
  // Against the finest mesh; the chords of degree 1 lie off the arc by O(h^2), and so do the results.
  const double reference = pinched_ring(2, 256, .01);
  for (const unsigned int degree : {1, 2})
  {
    const double coarse = std::abs(pinched_ring(degree, 8, .01) - reference);
    const double fine = std::abs(pinched_ring(degree, 16, .01) - reference);
    BOOST_TEST_MESSAGE("degree " << degree << ": errors " << coarse << " " << fine);
    BOOST_TEST(std::log2(coarse / fine) > (degree == 1 ? 1.9 : 2.9));
  }
}

BOOST_AUTO_TEST_CASE(cylinder_under_internal_pressure)
{
  // Free to extend: u = p R^2 / (E t) but for O(t / R), the hoop stress being larger on the inner face.
  for (const unsigned int degree : {1, 2})
  {
    const auto blank = make_shell(degree, 4, 1e-3, {"Blank/Points=1 0; 1 .5"});
    const double p = 1e-6;
    const auto q = solve(*blank, -pressure_load(*blank, p), {blank->boundary().dofs("end", Component::z).front()});
    for (const auto *const boundary : {"start", "end"})
      BOOST_TEST(std::abs(q[blank->boundary().dofs(boundary, Component::r).front()] / (p / (E * 1e-3)) - 1.) < 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(cantilever_rolled_up)
{
  // Pure bending with finite rotation: a moment M = E' I phi / L bends a strip to an arc of the angle phi; tip and
  // shape are those of the circle. The logarithmic strain of the faces makes M differ from the linear law by O((t phi /
  // L)^2).
  for (const unsigned int degree : {1, 2})
  {
    const double t = 1e-3, phi = 2. * PI;
    const auto blank = make_shell(degree, 10, t, {"Blank/Symmetry=plane strain", "Blank/Points=0 0; 1 0"});
    const auto role = roles(*blank);
    const auto X = blank->positions(Vector(blank->n_dofs()));
    const auto tip = blank->boundary().dofs("end", Component::rotation).front();
    const double M = E * t * t * t / (12. * (1. - nu * nu)) * phi;
    Vector q(blank->n_dofs());
    double norm = 1.;
    for (unsigned int step = 1; step <= 40; ++step)
      for (unsigned int iteration = 0; iteration < 15; ++iteration)
      {
        DenseTarget target(blank->n_dofs());
        assemble(*blank, q, target);
        target.residual[tip] -= M * step / 40.;
        for (const auto dof : all_of(*blank, "start"))
        {
          target.matrix.row(dof).setZero();
          target.matrix(dof, dof) = E;
          target.residual[dof] = 0.;
        }
        norm = target.residual.norm() / M;
        if (norm < 1e-8)
          break;
        const Eigen::VectorXd d = target.matrix.partialPivLu().solve(target.residual);
        for (unsigned int i = 0; i < q.size(); ++i)
          q[i] -= d[i];
      }
    BOOST_TEST(norm < 1e-8);
    BOOST_TEST(std::abs(q[tip] - phi) < 1e-4);
    for (unsigned int i = 0; i < q.size(); ++i)
      if (role[i].node != invalid_index)
      {
        const double s = X[role[i].node][0];
        const double expected = role[i].axis == 0 ? std::sin(phi * s) / phi - s : (1. - std::cos(phi * s)) / phi;
        BOOST_TEST(std::abs(q[i] - expected) < (degree == 1 ? 1e-2 : 1e-3));
      }
  }
}

BOOST_AUTO_TEST_SUITE_END()
