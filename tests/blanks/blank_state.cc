// What every registered blank has to fulfil from increment to increment: potential, commit, rollback, restart.
#include "any_blank.h"

#include <sstream>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  void reach(Blank &blank, const Vector &q)
  {
    residual(blank, q);
    blank.commit(q);
  }

  /// Displacements that turn the blank by @p angle and stretch it by exp(@p stretch) in its plane.
  Vector placed(const Blank &blank, const double angle, const double stretch)
  {
    const auto role = roles(blank);
    const auto X = blank.positions(Vector(blank.n_dofs()));
    const double c = std::exp(stretch) * std::cos(angle), s = std::exp(stretch) * std::sin(angle);
    Vector q(blank.n_dofs());
    for (unsigned int i = 0; i < q.size(); ++i)
      if (role[i].node == invalid_index)
        q[i] = angle;
      else
      {
        const auto &x = X[role[i].node];
        q[i] = role[i].axis == 0 ? c * x[0] - s * x[1] - x[0] : s * x[0] + c * x[1] - x[1];
      }
    return q;
  }

  IncrementSize increment_size(Blank &blank, const Vector &from, const Vector &to)
  {
    reach(blank, from);
    residual(blank, to);
    Vector dq = to;
    dq -= from;
    return blank.increment_size(dq);
  }

  /// What can be seen of the committed state.
  std::vector<double> visible(const Blank &blank, const Vector &q)
  {
    const BlankEnergy energy = blank.energy();
    std::vector<double> result{energy.elastic, energy.plastic, energy.normal, blank.fields().smallest_thickness()};
    for (const auto &row : blank.fields().profile(q).rows)
      result.insert(result.end(), row.begin(), row.end());
    for (const auto &field : blank.fields().draw(q, {}).fields)
      result.insert(result.end(), field.values.begin(), field.values.end());
    for (const Side side : {Side::bottom, Side::top})
      for (unsigned int i = 0; i < blank.surface().n_contact_points(side); ++i)
      {
        ContactPoint node;
        blank.surface().contact_point(q, side, i, ContactThickness::current, node);
        result.insert(result.end(), {node.x[0], node.x[1], node.offset, node.area, node.thickness});
      }
    return result;
  }

  /// Largest difference relative to the largest value.
  double deviation(const Eigen::VectorXd &a, const Eigen::VectorXd &b)
  {
    return (a - b).lpNorm<Eigen::Infinity>() / a.lpNorm<Eigen::Infinity>();
  }
} // namespace

BOOST_AUTO_TEST_SUITE(blank_state)

BOOST_AUTO_TEST_CASE(elastic_forces_have_a_potential)
{
  std::mt19937 generator(1);
  for_all_blanks(curved(elastic),
                 [&](Blank &blank, const Entries &) {
                   const KeyedArrays start = blank.state();
                   const Vector q = random_state(blank, generator, .02);
                   const auto energy = [&](const Vector &state) {
                     blank.set_state(start);
                     reach(blank, state);
                     return blank.energy().elastic;
                   };
                   blank.set_state(start);
                   const auto forces = residual(blank, q);
                   Eigen::VectorXd gradient(q.size());
                   const double h = 1e-4 * fineness(blank);
                   for (unsigned int i = 0; i < q.size(); ++i)
                   {
                     const auto difference = [&](const double step) {
                       Vector plus = q, minus = q;
                       plus[i] += step;
                       minus[i] -= step;
                       return (energy(plus) - energy(minus)) / (2. * step);
                     };
                     gradient[i] = (4. * difference(.5 * h) - difference(h)) / 3.;
                   }
                   BOOST_TEST(deviation(forces, gradient) < 1e-8);
                   BOOST_TEST(blank.energy().plastic == 0.);
                 });
}

BOOST_AUTO_TEST_CASE(work_is_stored_or_dissipated)
{
  // Along a path of many increments with plastic flow the work of the internal forces is what the energies say. The
  // layers of a shell are moved between the increments: their work is in energy().normal.
  std::mt19937 generator(2);
  for_all_blanks(curved(plastic),
                 [&](Blank &blank, const Entries &) {
                   const Vector goal = random_state(blank, generator, .02);
                   double error[2];
                   const auto initial = blank.state();
                   unsigned int run = 0;
                   for (const unsigned int n : {40, 80})
                   {
                     blank.set_state(initial);
                     Vector q(blank.n_dofs());
                     double work = 0.;
                     Eigen::VectorXd before = Eigen::VectorXd::Zero(q.size());
                     for (unsigned int k = 1; k <= n; ++k)
                     {
                       // out and half way back, so that some points unload
                       const double share = 1. - std::abs(4. * k / (3. * n) - 1.);
                       Vector next = goal;
                       next *= share;
                       blank.begin_increment(1. / n, 1.);
                       const auto forces = residual(blank, next);
                       for (unsigned int i = 0; i < q.size(); ++i)
                         work += .5 * (forces[i] + before[i]) * (next[i] - q[i]);
                       blank.commit(next);
                       before = forces;
                       q = next;
                     }
                     const BlankEnergy energy = blank.energy();
                     BOOST_TEST(energy.plastic > 0.);
                     error[run++] = std::abs(work + energy.normal - energy.elastic - energy.plastic) / work;
                   }
                   BOOST_TEST(error[0] < 5e-3);
                   BOOST_TEST(error[1] < .6 * error[0]);
                 });
}

BOOST_AUTO_TEST_CASE(an_increment_that_is_given_up_leaves_nothing)
{
  std::mt19937 generator(3);
  for_all_blanks(curved(plastic),
                 [&](Blank &blank, const Entries &) {
                   const Vector q = random_state(blank, generator, .01);
                   reach(blank, q);
                   const auto before = visible(blank, q);
                   const auto forces = residual(blank, q);
                   // Of the layers that follow the new thickness
                   const Vector none(q.size());
                   const double strain = blank.increment_size(none).strain;
                   Vector other = q;
                   for (unsigned int k = 0; k < 3; ++k)
                   {
                     other += random_state(blank, generator, 4e-3);
                     residual(blank, other);
                   }
                   BOOST_TEST(blank.increment_size(none).strain > 1e-3);
                   BOOST_TEST(visible(blank, q) == before);
                   BOOST_TEST(deviation(forces, residual(blank, q)) < 1e-10);
                   BOOST_TEST(blank.increment_size(none).strain == strain);
                 });
}

BOOST_AUTO_TEST_CASE(commit_updates_the_thickness)
{
  for_all_blanks({"Blank/Points=.3 0; 1.1 0",
                  "Blank/Thickness=.01",
                  "Material/Model=linear elastic",
                  "Blank/Elements=4",
                  "Material/Poisson's ratio=.25"},
                 [](Blank &blank, const Entries &) {
                   // Stretched by the factor a along the radius (and, axisymmetric, around it).
                   const auto role = roles(blank);
                   const auto X = blank.positions(Vector(blank.n_dofs()));
                   const double strain = -.25 / .75 * (blank.axisymmetric() ? 2. : 1.) * std::log(1.02);
                   Vector q(blank.n_dofs());
                   for (unsigned int i = 0; i < q.size(); ++i)
                     if (role[i].node != invalid_index)
                       q[i] = (role[i].axis == 0 ? .02 : std::exp(strain) - 1.) * X[role[i].node][role[i].axis];
                   BOOST_TEST(std::abs(blank.fields().smallest_thickness() - .01) < 1e-16);
                   reach(blank, q);
                   BOOST_TEST(std::abs(std::log(blank.fields().smallest_thickness() / .01) - strain) < 1e-13);
                 });
}

BOOST_AUTO_TEST_CASE(the_size_of_an_increment_is_counted_from_the_last_commit)
{
  for_all_blanks(
    {"Blank/Points=.3 0; 1.1 0", "Blank/Thickness=.01", "Material/Model=linear elastic", "Blank/Elements=4"},
    [](Blank &blank, const Entries &) {
      if (blank.axisymmetric())
        return; // does not turn without strain
      const IncrementSize turned = increment_size(blank, placed(blank, .2, .05), placed(blank, .3, .05));
      BOOST_TEST(std::abs(turned.rotation - .1) < 1e-12);
      BOOST_TEST(turned.strain < 1e-10);
      const IncrementSize longer = increment_size(blank, placed(blank, .3, .05), placed(blank, .3, .07));
      BOOST_TEST(longer.rotation < 1e-12);
      BOOST_TEST(std::abs(longer.strain - .02) < 1e-10);
    });
}

BOOST_AUTO_TEST_CASE(the_size_of_an_increment_says_where)
{
  for (const double end : {.3, 1.1})
    for_all_blanks(
      {"Blank/Points=.3 0; 1.1 0", "Blank/Thickness=.01", "Material/Model=linear elastic", "Blank/Elements=4"},
      [end](Blank &blank, const Entries &) {
        const auto role = roles(blank);
        const auto X = blank.positions(Vector(blank.n_dofs()));
        const auto shifted = [&](const unsigned int axis) {
          Vector q(blank.n_dofs());
          for (unsigned int i = 0; i < q.size(); ++i)
            if (role[i].node != invalid_index && role[i].axis == axis && std::abs(X[role[i].node][0] - end) < 1e-9)
              q[i] = .001;
          return q;
        };
        const Vector start(blank.n_dofs());
        const IncrementSize longer = increment_size(blank, start, shifted(0));
        BOOST_TEST(std::abs(longer.strained[0] - end) < .2);
        BOOST_TEST(std::abs(longer.strained[1]) < .01);
        if (const IncrementSize turned = increment_size(blank, start, shifted(1)); turned.rotation > 0.)
          BOOST_TEST(std::abs(turned.turned[0] - end) < .2);
      });
}

BOOST_AUTO_TEST_CASE(the_size_of_an_increment_with_small_strain)
{
  // A linear law does not visit its points; a plastic one does. No strain is too large for the linear one.
  for (const std::string model : {"linear elastic", "elastoplastic"})
    BOOST_TEST_CONTEXT(model)
    {
      const auto blank = make_blank("solid",
                                    {"Blank/Points=.3 0; 1.1 0",
                                     "Blank/Thickness=.01",
                                     "Blank/Elements=4",
                                     "Blank/Symmetry=plane strain",
                                     "Blank/Kinematics=small",
                                     "Material/Model=" + model});
      const Vector start(blank->n_dofs());
      const IncrementSize turned = increment_size(*blank, start, placed(*blank, 1e-3, 0.));
      BOOST_TEST(std::abs(turned.rotation - 1e-3) < 1e-9);
      const IncrementSize longer = increment_size(*blank, start, placed(*blank, 0., 1e-6));
      BOOST_TEST(longer.rotation < 1e-12);
      BOOST_TEST(std::abs(longer.strain - (model == "elastoplastic" ? 1e-6 : 0.)) < 1e-11);
    }
}

BOOST_AUTO_TEST_CASE(restart_goes_on_where_it_stopped)
{
  std::mt19937 generator(4);
  for_all_blanks(curved(plastic),
                 [&](Blank &blank, const Entries &entries) {
                   const Vector q = random_state(blank, generator, .02);
                   const unsigned int n_nodes = blank.surface().n_nodes();
                   blank.set_pressure({{std::vector<double>(n_nodes, 0.), std::vector<double>(n_nodes, .7)}});
                   reach(blank, q);
                   for (const auto &name : Registry<Blank>::names())
                   {
                     std::unique_ptr<Blank> copy;
                     try
                     {
                       copy = make_blank(name, entries);
                     }
                     catch (const SceneError &)
                     {
                       continue; // another kind of blank, which these entries do not suit
                     }
                     if (copy->n_dofs() != blank.n_dofs())
                       continue;
                     copy->set_state(blank.state());
                     BOOST_TEST(visible(*copy, q) == visible(blank, q));
                     Vector further = q;
                     further += random_state(blank, generator, 3e-3);
                     DenseTarget a(q.size()), b(q.size());
                     assemble(blank, further, a);
                     assemble(*copy, further, b);
                     BOOST_TEST(deviation(a.residual, b.residual) < 1e-10);
                     BOOST_TEST((a.matrix - b.matrix).norm() < 1e-9 * a.matrix.norm());
                     BOOST_TEST(copy->increment_size(q).strain == blank.increment_size(q).strain,
                                boost::test_tools::tolerance(1e-12));
                     copy->commit(further);
                     BOOST_TEST(copy->energy().plastic > blank.energy().plastic);
                   }
                 });
}

BOOST_AUTO_TEST_CASE(impossible_states_ask_for_a_shorter_step)
{
  std::mt19937 generator(5);
  for_all_blanks(curved(plastic),
                 [&](Blank &blank, const Entries &) {
                   unsigned int refused = 0;
                   for (unsigned int k = 0; k < 20; ++k)
                   {
                     const Vector wild = random_state(blank, generator, 3.);
                     DenseTarget target(blank.n_dofs(), false);
                     const Status status = blank.assemble(wild, target);
                     if (status.good())
                       BOOST_TEST(target.residual.allFinite());
                     else
                       BOOST_TEST(std::string(status.cause).size() > 0);
                     refused += !status.good();

                     const Vector zero(blank.n_dofs());
                     const double factor = blank.admissible_step(zero, wild);
                     BOOST_TEST((factor > 0. && factor < 1.));
                     Vector small = wild;
                     small *= 1e-6;
                     BOOST_TEST(blank.admissible_step(zero, small) == 1.);
                   }
                   BOOST_TEST((refused > 0 || !blank.axisymmetric()));
                 });
}

BOOST_AUTO_TEST_SUITE_END()
