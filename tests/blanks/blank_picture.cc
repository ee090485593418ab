// Tensors and pressures of the pictures, in homogeneous deformations whose strains are known.
#include "any_blank.h"

#include <cmath>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double along = .08, across = -.05, angle = .6; // logarithmic stretches; turned by an angle afterwards

  Entries flat(const std::string &degree, const Entries &more)
  {
    Entries result = {"Blank/Symmetry=plane strain",
                      "Blank/Points=0 0; 1 0",
                      "Blank/Thickness=.2",
                      "Blank/Elements=3",
                      "Blank/Degree=" + degree,
                      "Material/Young's modulus=2e3",
                      "Material/Poisson's ratio=.3"};
    result.insert(result.end(), more.begin(), more.end());
    return result;
  }

  /// Stretched by exp(@p a) along r and exp(@p b) along z, then turned by @p turn.
  Vector stretched_and_turned(const Blank &blank, const double a, const double b, const double turn)
  {
    const auto role = roles(blank);
    const auto X = blank.positions(Vector(blank.n_dofs()));
    Vector q(blank.n_dofs());
    for (unsigned int i = 0; i < q.size(); ++i)
      if (role[i].node == invalid_index)
        q[i] = turn;
      else
      {
        const Point2 &x = X[role[i].node];
        const double r = std::exp(a) * x[0], z = std::exp(b) * x[1], c = std::cos(turn), s = std::sin(turn);
        q[i] = role[i].axis == 0 ? c * r - s * z - x[0] : s * r + c * z - x[1];
      }
    return q;
  }

  Drawing reached(Blank &blank, const Vector &q)
  {
    residual(blank, q);
    blank.commit(q);
    return blank.fields().draw(q, {});
  }

  const std::vector<double> &field(const Drawing &drawing, const std::string &name)
  {
    for (const auto &one : drawing.fields)
      if (one.name == name)
        return one.values;
    BOOST_FAIL("no field " << name);
    throw;
  }

  /// Every cell has this tensor: principal values along and across a direction, and hoop.
  void check_tensor(const std::vector<double> &values,
                    const double first,
                    const double second,
                    const double hoop,
                    const double turn)
  {
    const double c = std::cos(turn), s = std::sin(turn);
    const std::array<double, 4> expected{
      {c * c * first + s * s * second, s * s * first + c * c * second, hoop, c * s * (first - second)}};
    BOOST_TEST_REQUIRE(values.size() % 4 == 0u);
    BOOST_TEST_REQUIRE(!values.empty());
    for (unsigned int i = 0; i < values.size(); ++i)
      BOOST_TEST(std::abs(values[i] - expected[i % 4]) < 1e-9, values[i] << " instead of " << expected[i % 4]);
  }
} // namespace

BOOST_AUTO_TEST_SUITE(blank_picture)

BOOST_AUTO_TEST_CASE(strain_of_a_solid_is_the_logarithm_of_its_stretch_turned_with_it)
{
  for (const std::string degree : {"1", "2"})
  {
    const auto blank = make_blank("solid", flat(degree, elastic));
    const auto drawing = reached(*blank, stretched_and_turned(*blank, along, across, angle));
    check_tensor(field(drawing, "strain"), along, across, 0., angle);
  }
}

BOOST_AUTO_TEST_CASE(plastic_strain_of_a_solid_keeps_its_volume_and_turns_with_it)
{
  for (const std::string kinematics : {"finite", "small"})
  {
    const auto blank = make_blank("solid",
                                  flat("1",
                                       [&] {
                                         Entries more = plastic;
                                         more.push_back("Blank/Kinematics=" + kinematics);
                                         return more;
                                       }()));
    const auto straight = reached(*blank, stretched_and_turned(*blank, along, -along, 0.));
    const auto tensor = field(straight, "plastic_strain");
    const double e = tensor[0];
    BOOST_TEST(e > .5 * along); // nearly all of it
    // Plane strain at constant volume: (e, -e, 0), whose equivalent strain is 2/sqrt(3) e.
    const double doubt = kinematics == "small" ? .1 * e : 1e-9;
    BOOST_TEST(std::abs(tensor[0] + tensor[1] + tensor[2]) < 1e-9);
    BOOST_TEST(std::abs(tensor[3]) < 1e-9);
    BOOST_TEST(std::abs(field(straight, "equivalent_plastic_strain")[0] - 2. / std::sqrt(3.) * e) < doubt);
    if (kinematics == "small")
      continue;
    check_tensor(tensor, e, -e, 0., 0.);
    const auto turned = reached(*blank, stretched_and_turned(*blank, along, -along, angle));
    check_tensor(field(turned, "plastic_strain"), e, -e, 0., angle);
  }
}

BOOST_AUTO_TEST_CASE(strain_of_a_shell_is_turned_from_its_meridian)
{
  for (const std::string degree : {"1", "2"})
  {
    const auto blank = make_blank("shell", flat(degree, elastic));
    const auto drawing = reached(*blank, stretched_and_turned(*blank, along, 0., angle));
    // Without transverse stress the sheet gets thinner by nu/(1 - nu).
    check_tensor(field(drawing, "strain"), along, -.3 / .7 * along, 0., angle);
  }
}

BOOST_AUTO_TEST_CASE(plastic_strain_of_a_shell_keeps_its_volume_and_turns_with_it)
{
  const auto blank = make_blank("shell", flat("1", plastic));
  const auto drawing = reached(*blank, stretched_and_turned(*blank, along, 0., angle));
  const auto &tensor = field(drawing, "plastic_strain");
  const double c = std::cos(angle), s = std::sin(angle);
  // Back to the meridian.
  const double first = c * c * tensor[0] + s * s * tensor[1] + 2 * c * s * tensor[3];
  check_tensor(tensor, first, -first - tensor[2], tensor[2], angle);
  BOOST_TEST(first > .5 * along);
}

BOOST_AUTO_TEST_CASE(hydrostatic_pressure_is_minus_the_mean_stress)
{
  const auto shell = make_blank("shell", flat("1", elastic));
  const auto of_shell = reached(*shell, stretched_and_turned(*shell, along, 0., angle));
  // Plane strain, plane stress: tau_1 = E/(1 - nu^2) e, tau_2 = nu tau_1.
  for (const double p : field(of_shell, "hydrostatic_pressure"))
    BOOST_TEST(p == -2e3 / .91 * along * 1.3 / 3., boost::test_tools::tolerance(1e-9));
  const auto solid = make_blank("solid", flat("1", elastic));
  const auto of_solid = reached(*solid, stretched_and_turned(*solid, along, across, angle));
  // K tr(e), K = E/(3 (1 - 2 nu)).
  for (const double p : field(of_solid, "hydrostatic_pressure"))
    BOOST_TEST(p == -2e3 / 1.2 * (along + across), boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(elastic_blanks_show_no_plastic_strain)
{
  for (const std::string kind : {"shell", "solid"})
  {
    const auto blank = make_blank(kind, flat("1", elastic));
    for (const auto &one : blank->fields().draw(Vector(blank->n_dofs()), {}).fields)
      BOOST_TEST((one.name != "plastic_strain"));
  }
}

BOOST_AUTO_TEST_CASE(nodes_of_a_face_lie_on_it)
{
  const auto solid = make_blank("solid", flat("2", elastic));
  const auto X = solid->positions(Vector(solid->n_dofs()));
  const auto nodes = solid->boundary().face_nodes("top");
  BOOST_TEST(nodes.size() == 7u); // three quadratic elements
  for (const auto node : nodes)
    BOOST_TEST(X[node][1] == .1, boost::test_tools::tolerance(1e-12));
  const auto shell = make_blank("shell", flat("1", elastic));
  BOOST_TEST(shell->boundary().face_nodes("bottom").size() == 4u);
}

BOOST_AUTO_TEST_SUITE_END()
