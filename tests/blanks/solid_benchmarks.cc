// The solid alone: patch test, volumetric locking, bending of thin strips, meshes from files.
#include "any_blank.h"

#include <fstream>
#include <numeric>
#include <set>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  /// Small displacements under loads: K d = f with @p held unknowns at zero.
  Vector solve(Blank &blank, const Eigen::VectorXd &load, const std::vector<std::vector<DofIndex>> &held)
  {
    DenseTarget target(blank.n_dofs());
    assemble(blank, Vector(blank.n_dofs()), target);
    Eigen::VectorXd right = load;
    auto all = held;
    all.push_back(blank.fixed_dofs());
    for (const auto &dofs : all)
      for (const auto dof : dofs)
      {
        target.matrix.row(dof).setZero();
        target.matrix(dof, dof) = 1.;
        right[dof] = 0.;
      }
    const Eigen::VectorXd d = target.matrix.lu().solve(right);
    Vector result(blank.n_dofs());
    std::copy(d.data(), d.data() + d.size(), result.begin());
    return result;
  }

  Eigen::VectorXd pressure_load(Blank &blank, const std::string &face, const double pressure)
  {
    DenseTarget target(blank.n_dofs(), false);
    blank.boundary().assemble_pressure(Vector(blank.n_dofs()), face, pressure, false, target);
    return -target.residual;
  }

  /// Radial displacement of the outside of a thick sphere under internal pressure over Lame's solution, minus 1.
  double sphere_error(const unsigned int degree, const unsigned int n, const double nu)
  {
    const auto blank = make_blank("solid",
                                  {"Blank/Kinematics=small",
                                   "Blank/Degree=" + std::to_string(degree),
                                   "Blank/Points=1.5 0; 1.5 1.5; 0 1.5",
                                   "Blank/Fillet radii=0, 1.5, 0",
                                   "Blank/Thickness=1",
                                   "Blank/Elements=" + std::to_string(n),
                                   "Blank/Elements through thickness=" + std::to_string(n),
                                   "Material/Model=linear elastic",
                                   "Material/Young's modulus=1",
                                   "Material/Poisson's ratio=" + std::to_string(nu)});
    const Vector u = solve(*blank, pressure_load(*blank, "top", 1.), {blank->boundary().dofs("start", Component::z)});
    double sum = 0.;
    const auto outer = blank->boundary().dofs("bottom", Component::r);
    const auto where = blank->boundary().points("bottom");
    for (unsigned int i = 0; i < outer.size(); ++i)
      if (where[i][1] < 1e-9)
        sum += u[outer[i]];
    return sum / (3. * (1. - std::stod(std::to_string(nu))) * 2. / (2. * 7.)) - 1.;
  }

  /// Deflection of a cantilever strip of length 1 under a pressure over that of a beam (with shear), minus 1.
  double bending_error(const unsigned int degree,
                       const double thickness,
                       const unsigned int n_along,
                       const unsigned int n_across)
  {
    const auto blank = make_blank("solid",
                                  {"Blank/Kinematics=small",
                                   "Blank/Symmetry=plane strain",
                                   "Blank/Degree=" + std::to_string(degree),
                                   "Blank/Points=0 0; 1 0",
                                   "Blank/Thickness=" + std::to_string(thickness),
                                   "Blank/Elements=" + std::to_string(n_along),
                                   "Blank/Elements through thickness=" + std::to_string(n_across),
                                   "Material/Model=linear elastic",
                                   "Material/Young's modulus=1",
                                   "Material/Poisson's ratio=0.3"});
    const Boundary &boundary = blank->boundary();
    const Vector u = solve(*blank,
                           pressure_load(*blank, "bottom", 1.),
                           {boundary.dofs("start", Component::r), boundary.dofs("start", Component::z)});
    const double stiffness = std::pow(thickness, 3) / (12. * (1. - .09)), shear = 5. / 6. * thickness / 2.6;
    const auto table = blank->fields().profile(u);
    const auto column = std::find(table.names.begin(), table.names.end(), "u_z") - table.names.begin();
    return table.rows.back()[column] / (1. / (8. * stiffness) + 1. / (2. * shear)) - 1.;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(solid_benchmarks)

BOOST_AUTO_TEST_CASE(patch_test)
{
  // A homogeneous large deformation of a distorted mesh: no forces inside, and on the boundary those of a uniform
  // stress.
  for (const std::string degree : {"1", "2"})
    for (const std::string kinematics : {"finite", "small"})
      for (const std::string symmetry : {"axisymmetric", "plane strain"})
      {
        const auto blank = make_blank("solid",
                                      {"Blank/Kinematics=" + kinematics,
                                       "Blank/Degree=" + degree,
                                       "Blank/Symmetry=" + symmetry,
                                       "Blank/Points=.5 0; 1 .2; 2 0; 3 .1",
                                       "Blank/Thickness=.6",
                                       "Blank/Thickness variation=0: 1, .5: .7, 1: 1.3",
                                       "Blank/Elements=6",
                                       "Blank/Grading=1+t",
                                       "Blank/Elements through thickness=3",
                                       "Blank/Grading through thickness=2-t",
                                       "Material/Model=linear elastic",
                                       "Material/Young's modulus=1",
                                       "Material/Poisson's ratio=0.45"});
        const auto role = roles(*blank);
        const auto X = blank->positions(Vector(blank->n_dofs()));
        Vector q(blank->n_dofs());
        for (unsigned int i = 0; i < q.size(); ++i)
          q[i] = (role[i].axis == 0 ? .15 : -.2) * X[role[i].node][role[i].axis];
        const auto forces = residual(*blank, q);
        std::vector<bool> outside(q.size(), false);
        for (const auto &name : blank->boundary().parts())
          for (const auto component : {Component::r, Component::z})
            for (const auto dof : blank->boundary().dofs(name, component))
              outside[dof] = true;
        unsigned int inside = 0;
        for (unsigned int i = 0; i < q.size(); ++i)
          if (!outside[i])
          {
            ++inside;
            BOOST_TEST(std::abs(forces[i]) < 1e-13);
          }
        BOOST_TEST(inside > 0u);
        BOOST_TEST(forces.lpNorm<Eigen::Infinity>() > 1e-3);
      }
}

BOOST_AUTO_TEST_CASE(no_volumetric_locking)
{
  for (const unsigned int degree : {1, 2})
    for (const double nu : {.3, .499, .49999})
    {
      const double coarse = std::abs(sphere_error(degree, 4, nu)), fine = std::abs(sphere_error(degree, 8, nu));
      BOOST_TEST_MESSAGE("degree " << degree << ", nu " << nu << ": " << coarse << ", " << fine);
      BOOST_TEST(coarse < (degree == 1 ? 6e-2 : 2e-3));
      BOOST_TEST(std::log2(coarse / fine) > (degree == 1 ? 1.6 : 2.7));
    }
}

BOOST_AUTO_TEST_CASE(bending_of_thin_strips)
{
  // Degree 2 bends with one cell across and cells ten times as long as high; degree 1 needs cells that are about as
  // long as high, and four of them across.
  for (const double thickness : {.1, .02, .005})
  {
    const double error = bending_error(2, thickness, 20, 1);
    BOOST_TEST_MESSAGE("degree 2, thickness " << thickness << ", 20 x 1 cells: " << error);
    BOOST_TEST(std::abs(error) < 1e-2);
  }
  for (const unsigned int across : {1, 2, 4})
    for (const unsigned int aspect : {1, 5})
    {
      const double error = bending_error(1, .1, 10 * across / aspect, across);
      BOOST_TEST_MESSAGE("degree 1, " << across << " across, " << aspect << " times as long as high: " << error);
    }
  BOOST_TEST(std::abs(bending_error(1, .1, 40, 4)) < 4e-2);
  BOOST_TEST(bending_error(1, .02, 20, 2) < -.3); // locks, and the documentation says so
}

BOOST_AUTO_TEST_CASE(weights_of_loads)
{
  const auto blank =
    make_blank("solid", {"Blank/Degree=2", "Blank/Points=1 0; 3 0", "Blank/Thickness=.5", "Blank/Elements=4"});
  const auto sum = [](const std::vector<double> &values) {
    return std::accumulate(values.begin(), values.end(), 0.) / dealii::numbers::PI;
  };
  BOOST_TEST(sum(blank->boundary().weights("bottom")) == 8., boost::test_tools::tolerance(1e-14));
  BOOST_TEST(sum(blank->boundary().weights("end")) == 3., boost::test_tools::tolerance(1e-14));
  double volume = 0.;
  for (const auto &[dof, weight] : blank->boundary().volume_weights(Component::z))
    volume += weight / dealii::numbers::PI;
  BOOST_TEST(volume == 4., boost::test_tools::tolerance(1e-14));
  BOOST_TEST(blank->boundary().dofs("end", Component::rotation).empty());
}

BOOST_AUTO_TEST_CASE(mesh_from_a_file)
{
  // Two cells, 2 x 1, with three named boundaries.
  const std::string name = "solid_benchmarks.msh";
  std::ofstream(name) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 1 \"die side\"\n1 2 \"rim\"\n2 9 "
                         "\"body\"\n$EndPhysicalNames\n$Nodes\n6\n1 1 0 0\n2 2 0 0\n3 3 0 0\n4 1 1 0\n5 2 1 0\n6 3 1 "
                         "0\n$EndNodes\n$Elements\n5\n1 1 2 1 1 1 2\n2 1 2 1 1 2 3\n3 1 2 2 2 3 6\n4 3 2 9 9 1 2 5 "
                         "4\n5 3 2 9 9 2 3 6 5\n$EndElements\n";
  for (const std::string degree : {"1", "2"})
  {
    const auto blank = make_blank("solid",
                                  {"Blank/Mesh=gmsh",
                                   "Blank/File=" + name,
                                   "Blank/Degree=" + degree,
                                   "Blank/Contact bottom=die side, rim",
                                   "Blank/Contact top="});
    const auto names = blank->boundary().parts();
    BOOST_TEST((std::set<std::string>(names.begin(), names.end()) == std::set<std::string>{"die side", "rim", "rest"}));
    BOOST_TEST(blank->surface().n_contact_points(Side::bottom) == (degree == "1" ? 4u : 7u));
    BOOST_TEST(blank->surface().n_contact_points(Side::top) == 0u);
    BOOST_TEST(pressure_load(*blank, "rim", 1.).sum() == -6. * dealii::numbers::PI,
               boost::test_tools::tolerance(1e-13));
    BOOST_TEST(blank->initial_thickness() == 1.);
    BOOST_TEST(blank->typical_length() == (degree == "1" ? 1. : .5));
  }
  const auto fails = [](const Entries &entries, const std::string &what) {
    BOOST_CHECK_EXCEPTION(make_blank("solid", entries),
                          SceneError,
                          [&](const SceneError &error) {
                            return std::string(error.what()).find(what) != std::string::npos;
                          });
  };
  fails({"Blank/Mesh=gmsh", "Blank/File=nowhere.msh"}, "cannot read 'nowhere.msh'");
  fails({"Blank/Mesh=gmsh", "Blank/File=" + name, "Blank/Contact bottom=rim", "Blank/Contact top=lid"},
        "there is no boundary 'lid'");
  fails({"Blank/Points=-1 0; 1 0", "Blank/Thickness=.1"}, "must lie at r >= 0");
  fails({"Blank/Points=2 0; 3 0; 3 1", "Blank/Fillet radii=0, .1, 0", "Blank/Thickness=.5", "Blank/Elements=20"},
        "turned inside out");
}

BOOST_AUTO_TEST_SUITE_END()
