// A normal law in its interface: the face in series, continuation, what the iteration forbids, and its own equation.
#include "../blanks/dense_target.h"
#include "../materials/material_point.h"

#include <deltaform/contact/contact_force.h>
#include <deltaform/contact/normal_law.h>
#include <deltaform/contact/point_rows.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <cmath>
#include <memory>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  std::unique_ptr<NormalLaw> make_law(const std::string &name)
  {
    ParameterTree tree = ParameterTree::parse("", "test", {});
    Section section = tree.root();
    return Registry<NormalLaw>::make(name, section);
  }

  /// eps = 20, K_nn = 100, so that c = 1.
  ContactPointState point()
  {
    ContactPointState state;
    state.penalty_factor = 20.;
    state.stiffness = 100.;
    state.delta = 1e-2;
    state.thickness = 1.;
    return state;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(normal_law)

BOOST_AUTO_TEST_CASE(a_face_that_gives_way_is_a_spring_in_series)
{
  const auto law = make_law("penalty");
  const ContactPointState state = point();
  NormalSituation situation;
  situation.gap = -.3;
  situation.compliance = .1;
  // lambda (1/eps + c_h) = p, and what is left of the gap is lambda/eps.
  const NormalResponse response = law->respond(state, situation);
  BOOST_TEST(response.force == .3 / (1. / 20. + .1), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(response.derivative == -1. / (1. / 20. + .1), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(response.gap == -response.force / 20., boost::test_tools::tolerance(1e-14));
  // Continuation: a share of the spring's force.
  situation.share = .25;
  BOOST_TEST(law->respond(state, situation).force == .25 * response.force, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(what_the_iteration_forbids)
{
  const auto law = make_law("penalty");
  ContactPointState state = point();
  NormalSituation situation;
  situation.gap = .3;
  state.multiplier = .2; // less than c g: the point lets go
  BOOST_TEST(!law->respond(state, situation).touching);
  situation.held = true;
  BOOST_TEST(law->respond(state, situation).touching);
  BOOST_TEST(law->respond(state, situation).force == -20. * .3, boost::test_tools::tolerance(1e-14));
  // Without a force there is nothing to hold.
  state.multiplier = 0.;
  BOOST_TEST(!law->respond(state, situation).touching);
}

BOOST_AUTO_TEST_CASE(estimates_follow_the_spring)
{
  const auto law = make_law("penalty");
  ContactPointState state = point();
  state.touching = true;
  state.gap = -.02;
  BOOST_TEST(law->estimate(state, .005, 1.) == 20. * .015, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(law->estimate(state, .005, .1) == 2. * .015, boost::test_tools::tolerance(1e-14));
  state.touching = false;
  BOOST_TEST(law->estimate(state, -1., 1.) == 0.);
}

BOOST_AUTO_TEST_CASE(every_law_knows_its_solutions)
{
  for (const auto &name : Registry<NormalLaw>::names())
    BOOST_TEST_CONTEXT(name)
    {
      const auto law = make_law(name);
      ContactPointState state = point();
      state.force = -1.;
      BOOST_TEST(law->is_solution(state, 0., true)); // apart
      state.touching = true;
      BOOST_TEST(!law->is_solution(state, .9, true)); // tension
      BOOST_TEST(law->is_solution(state, 1.1, true));
      state.gap = -1e-2;
      state.force = 1.;
      // A spring may penetrate, a constraint only while it is still soft.
      BOOST_TEST(law->is_solution(state, 0., true) == !law->has_multiplier());
      BOOST_TEST(law->is_solution(state, 0., false));
    }
}

BOOST_AUTO_TEST_CASE(a_law_owns_its_equation)
{
  // Of a tied point: force times normal on the unknowns, minus gap and compliance in its own row; symmetric.
  const auto law = make_law("active set");
  ContactPoint place;
  place.set_node(0);
  place.n_dofs = 2;
  place.dofs[0] = 0;
  place.dofs[1] = 1;
  place.jacobian[0] = Tensor1({1., 0.});
  place.jacobian[1] = Tensor1({0., 1.});
  Projection closest{};
  closest.normal = Tensor1({.6, .8});
  closest.tangent = Tensor1({.8, -.6});
  Vector q(3);
  q[2] = 5.;
  ContactPointState state = point();
  law->read_unknown(q, 2, state);
  BOOST_TEST(state.multiplier == 5.);
  NormalSituation situation;
  situation.gap = -.01;
  situation.compliance = 1e-3;
  const auto add = [&](DenseTarget &target) {
    const NormalResponse response = law->respond(state, situation);
    BOOST_TEST(law->acts(response));
    state.gap = response.gap;
    const ContactForce force(closest, SlipTransfer(), response, FrictionResponse());
    PointRows rows(place);
    law->join(rows, 2);
    rows.add_force(force.value());
    rows.add_gradient(force.value(), force.gradient(0.));
    law->add_equation(response, state, situation.compliance, force, rows);
    rows.add_to(target, true);
  };
  DenseTarget tied(3);
  add(tied);
  BOOST_TEST(std::abs(tied.residual[0] + 3.) < 1e-14);
  BOOST_TEST(std::abs(tied.residual[1] + 4.) < 1e-14);
  BOOST_TEST(std::abs(tied.residual[2] - (.01 - 1e-3 * 5.)) < 1e-14);
  BOOST_TEST((tied.matrix - tied.matrix.transpose()).norm() == 0.);
  BOOST_TEST(std::abs(tied.matrix(2, 0) + .6) < 1e-14);
  BOOST_TEST(std::abs(tied.matrix(2, 2) + 1e-3) < 1e-14);
  // Apart the row is lambda = 0, and nothing pushes.
  state.multiplier = -1.;
  situation.gap = .5;
  DenseTarget apart(3);
  add(apart);
  BOOST_TEST(apart.residual[2] == -1.);
  BOOST_TEST(apart.matrix(2, 2) == 1.);
  BOOST_TEST(apart.residual.head(2).norm() == 0.);
  BOOST_TEST(apart.matrix.topLeftCorner(2, 2).norm() == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
