// Shells and solids of metals drawn from all registered laws: tangents, objectivity, and what a refined mesh inherits.
#include "../materials/drawn_metals.h"
#include "any_blank.h"

#include <map>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  using Body = std::function<void(Blank &)>;

  /// Blanks in plane strain, where nothing forbids r0 and r90 that differ.
  void for_all_metals(const unsigned int seed, const std::string &kind, const Entries &entries, const Body &body)
  {
    unsigned int n_made = 0;
    for (const auto &metal : drawn_metals(seed))
    {
      if (kind == "solid" && metal.sheet_only)
        continue;
      Entries all = entries;
      all.insert(all.end(), metal.entries.begin(), metal.entries.end());
      all.insert(all.end(), {"Blank/Symmetry=plane strain", "Units=mm, N, MPa, s"});
      BOOST_TEST_CONTEXT(kind << " of " << metal.name)
      body(*make_blank(kind, all));
      ++n_made;
    }
    BOOST_TEST(n_made >= 3 * names_of<BackStress>().size());
  }

  const Entries small = {"Blank/Points=0 .2; .6 .35; 1 -.1",
                         "Blank/Fillet radii=0, .2, 0",
                         "Blank/Thickness=.04",
                         "Blank/Elements=3",
                         "Blank/Layers=3"};

  /// The state of @p q is accepted at the end of an increment of @p duration, @p ratio times as long as the last.
  void accept(Blank &blank, const Vector &q, const double duration, const double ratio)
  {
    blank.begin_increment(duration, ratio);
    residual(blank, q);
    blank.commit(q);
  }

  /// Forces at the nodes turned by @p angle; moments stay.
  Eigen::VectorXd turned_forces(const std::vector<DofRole> &role, const Eigen::VectorXd &force, const double angle)
  {
    std::map<unsigned int, std::array<double, 2>> nodes;
    for (unsigned int i = 0; i < role.size(); ++i)
      if (role[i].node != invalid_index)
        nodes[role[i].node][role[i].axis] = force[i];
    const double c = std::cos(angle), s = std::sin(angle);
    Eigen::VectorXd result = force;
    for (unsigned int i = 0; i < role.size(); ++i)
      if (role[i].node != invalid_index)
      {
        const auto &f = nodes[role[i].node];
        result[i] = role[i].axis == 0 ? c * f[0] - s * f[1] : s * f[0] + c * f[1];
      }
    return result;
  }

  /// Formed and formed back in unequal increments, while the whole turns at a constant rate; the forces of each
  /// increment, turned back.
  std::vector<Eigen::VectorXd> forces_of_a_path(Blank &blank, const Vector &direction, const double rate)
  {
    const auto role = roles(blank);
    std::vector<Eigen::VectorXd> result;
    double time = 0., last = 1.;
    for (const auto &[length, amount] : {std::pair(1., 1.), {1., 1.5}, {1.5, 2.2}, {.8, 2.6}, {.8, 1.6}, {1., .8}})
    {
      time += length;
      Vector q = direction;
      q *= amount;
      const Vector state = moved_rigidly(blank, q, rate * time);
      blank.begin_increment(length, length / last);
      last = length;
      result.push_back(turned_forces(role, residual(blank, state), -rate * time));
      blank.commit(state);
    }
    return result;
  }

  /// Displacements (F - 1) X.
  Vector uniform(const Blank &blank, const std::array<double, 4> &F)
  {
    const auto X = blank.positions(Vector(blank.n_dofs()));
    // Which node an unknown moves by itself: hanging nodes follow others.
    Vector q(blank.n_dofs());
    for (unsigned int i = 0; i < q.size(); ++i)
    {
      Vector alone(q.size());
      alone[i] = 1.;
      const auto moved = blank.positions(alone);
      for (unsigned int n = 0; n < moved.size(); ++n)
        for (unsigned int axis = 0; axis < 2; ++axis)
          if (std::abs(moved[n][axis] - X[n][axis] - 1.) < 1e-12)
            q[i] = F[2 * axis] * X[n][0] + F[2 * axis + 1] * X[n][1] - X[n][axis];
    }
    return q;
  }

  /// Halve the cells at some edges of the top; @p q has been accepted.
  void refine(Blank &blank, const Vector &q)
  {
    std::array<std::vector<double>, 2> longest;
    longest[1].assign(blank.surface().contact_edges(Side::top).size(), 1e300);
    longest[1][1] = longest[1][2] = 0.;
    std::vector<Vector> fields{q};
    const unsigned int before = blank.adaptive()->n_cells();
    BOOST_TEST_REQUIRE(blank.adaptive()->mark(longest));
    blank.adaptive()->refine(fields);
    BOOST_TEST_REQUIRE(blank.adaptive()->n_cells() > before);
  }

  /// Every value of a cell in @p fine is that of the first cell of @p coarse.
  void check_same_cells(const Drawing &coarse, const Drawing &fine)
  {
    BOOST_TEST_REQUIRE(coarse.fields.size() == fine.fields.size());
    unsigned int n_compared = 0;
    for (std::size_t f = 0; f < fine.fields.size(); ++f)
    {
      const DrawnField &one = coarse.fields[f], &other = fine.fields[f];
      if (one.per_point || one.name == "level")
        continue;
      double size = 1e-6;
      for (const double value : one.values)
        size = std::max(size, std::abs(value));
      double error = 0.;
      for (std::size_t i = 0; i < other.values.size(); ++i)
        error = std::max(error, std::abs(other.values[i] - one.values[i % one.n_components]));
      BOOST_TEST(error <= 1e-8 * size, one.name << ": " << error << " of " << size);
      ++n_compared;
    }
    BOOST_TEST(n_compared >= 3u);
  }
} // namespace

BOOST_AUTO_TEST_SUITE(every_metal)

// The steps of the differences are so short that no point passes its yield limit within one.
BOOST_AUTO_TEST_CASE(tangents)
{
  std::mt19937 generator(31);
  for (const std::string kind : {"shell", "solid"})
    for_all_metals(
      1, kind, small,
      [&](Blank &blank) {
        const double h = 2e-8 * fineness(blank);
        const Vector first = random_state(blank, generator, .02);
        blank.begin_increment(1., 0.);
        BOOST_TEST(tangent_error(internal_forces(blank), first, scales(blank), h) < 1e-5);
        accept(blank, first, 1., 0.);
        BOOST_TEST(blank.energy().plastic > 0.);
        Vector second = first;
        second *= 1.2;
        accept(blank, second, .7, .7); // goes on: two steps
        Vector third = second;
        third += random_state(blank, generator, 5e-3);
        blank.begin_increment(.5, .5 / .7);
        BOOST_TEST(tangent_error(internal_forces(blank), third, scales(blank), h) < 1e-5);
      });
}

BOOST_AUTO_TEST_CASE(forces_turn_with_a_blank_that_flows)
{
  std::mt19937 generator(32);
  for (const std::string kind : {"shell", "solid"})
    for_all_metals(2, kind, small, [&](Blank &blank) {
      const KeyedArrays fresh = blank.state();
      const Vector direction = random_state(blank, generator, .01);
      const auto still = forces_of_a_path(blank, direction, 0.);
      const double plastic = blank.energy().plastic;
      blank.set_state(fresh);
      const auto turning = forces_of_a_path(blank, direction, .4); // by 140 degrees in all
      BOOST_TEST(plastic > 0.);
      BOOST_TEST(blank.energy().plastic == plastic, boost::test_tools::tolerance(1e-9));
      for (std::size_t k = 0; k < still.size(); ++k)
        BOOST_TEST((turning[k] - still[k]).norm() <= 1e-8 * still[k].norm(), "increment " << k);
    });
}

// Stretched, sheared and turned alike everywhere, a refined body goes on as one that is not refined, with all that its
// points remember.
BOOST_AUTO_TEST_CASE(refined_cells_go_on_alike)
{
  constexpr std::array<std::array<double, 4>, 4> path = {
    {{{1.03, .05, .02, .98}}, {{1.05, .12, .06, .96}}, {{1.06, .14, .02, .96}}, {{1.03, .05, 0., .98}}}};
  const Entries straight = {"Blank/Points=.5 0; 2 .3",
                            "Blank/Thickness=.6",
                            "Blank/Thickness variation=0: 1, .5: .7, 1: 1.3",
                            "Blank/Elements=4",
                            "Blank/Elements through thickness=2",
                            "Blank/Refinement/Criterion=contact",
                            "Blank/Refinement/Maximal level=2",
                            "Limits/Criteria=rice-tracey, cockcroft-latham"};
  for_all_metals(3, "solid", straight, [&](Blank &blank) {
    const auto at = [&](const unsigned int k) { return uniform(blank, path[k]); };
    const auto go_on = [&]() {
      accept(blank, at(1), 0., 0.); // equilibrium at the same time; what follows has no last increment
      accept(blank, at(2), 1., 0.);
      accept(blank, at(3), 1., 1.);
      return blank.fields().draw(at(3), {});
    };
    accept(blank, at(0), 1., 0.);
    accept(blank, at(1), 1., 1.);
    const KeyedArrays before = blank.state();
    const Drawing coarse = go_on();
    blank.set_state(before);
    refine(blank, at(1));
    check_same_cells(coarse, go_on());
  });
}

BOOST_AUTO_TEST_SUITE_END()
