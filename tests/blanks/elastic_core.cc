// A strip that is bent, with layers that know where the elastic core ends: the tangent is exact while the core shrinks.
// Moments and springback: scenes springback_core*.
#include "any_blank.h"

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  /// It yields at the faces when the curvature is about .11.
  std::unique_ptr<Blank> strip(const std::string &symmetry, const Entries &metal = {})
  {
    Entries entries = plastic;
    entries.insert(entries.end(),
                   {"Blank/Points=1 0; 2 0",
                    "Blank/Symmetry=" + symmetry,
                    "Blank/Thickness=.04",
                    "Blank/Elements=3",
                    "Blank/Layers=9",
                    "Blank/Layer rule=elastic core",
                    "Material/Integration=backward Euler",
                    "Material/Young's modulus=2e3"});
    entries.insert(entries.end(), metal.begin(), metal.end());
    return make_blank("shell", entries);
  }

  /// Nodes on a circle, their normals along its radii; a little disturbed.
  Vector bent(const Blank &blank, const double curvature, const double disturbance)
  {
    std::mt19937 generator(1);
    const auto role = roles(blank);
    const auto X = blank.positions(Vector(blank.n_dofs()));
    Vector q = random_state(blank, generator, disturbance);
    for (unsigned int i = 0; i < q.size(); ++i)
    {
      // Two displacements, then the rotation of the same node.
      const bool rotation = role[i].node == invalid_index;
      const double s = X[role[rotation ? i - 1 : i].node][0] - 1., angle = curvature * s;
      if (rotation)
        q[i] += angle;
      else
        q[i] += role[i].axis == 0 ? std::sin(angle) / curvature - s : (1. - std::cos(angle)) / curvature;
    }
    return q;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(elastic_core)

BOOST_AUTO_TEST_CASE(tangent_while_the_core_shrinks)
{
  const std::string yield = "Material/Yield surface/";
  const std::vector<Entries> metals = {{},
                                       {yield + "Law=hill", yield + "r-bar=.6"},
                                       {yield + "Law=hosford", yield + "Exponent=6", yield + "r-bar=1.8"}};
  for (const std::string symmetry : {"plane strain", "axisymmetric"})
    for (const Entries &metal : metals)
    {
      auto blank = strip(symmetry, metal);
      for (const double curvature : {.05, .12, .2, .5, 1., .8})
      {
        const Vector q = bent(*blank, curvature, 2e-6);
        BOOST_TEST_CONTEXT(symmetry << ", " << (metal.empty() ? "mises" : metal[0]) << ", curvature " << curvature)
        BOOST_TEST(tangent_error(internal_forces(*blank), q, scales(*blank), 3e-8) < 1e-5); // no layer yields within
        residual(*blank, q);
        blank->commit(q);
      }
    }
}

BOOST_AUTO_TEST_CASE(core_is_part_of_the_state)
{
  auto blank = strip("plane strain"), other = strip("plane strain");
  const Vector q = bent(*blank, .5, 0.);
  residual(*blank, q);
  blank->commit(q);
  other->set_state(blank->state());
  const Vector next = bent(*blank, .45, 0.);
  BOOST_TEST((residual(*blank, next) - residual(*other, next)).norm() == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
