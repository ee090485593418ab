// Forces of a draw bead from the way of the sheet, against its law written out for a strip that is pulled as a whole.
#include "../blanks/any_blank.h"

#include <deltaform/loads/load.h>
#include <deltaform/parameters/section.h>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  const Entries strip = {"Blank/Points=0 0; 2 0", "Blank/Thickness=.01", "Blank/Elements=8",
                         "Blank/Symmetry=plane strain", "Material/Model=linear elastic"};

  std::unique_ptr<Load> make_bead(const Blank &blank, const Entries &more = {})
  {
    Entries entries{"bead/Value=60", "bead/Place=1.1", "bead/Length=.2", "bead/Elastic slip=.004"};
    entries.insert(entries.end(), more.begin(), more.end());
    ParameterTree tree = ParameterTree::parse("", "test", entries);
    Section section = tree.root().sub("bead");
    return LoadRegistry::make("draw bead", section, blank);
  }

  /// The strip moved along r.
  Vector moved(const Blank &blank, const double way)
  {
    Vector q(blank.n_dofs());
    blank.rigid_motion(q, Tensor1({way, 0.}), 0., [&](const DofIndex dof, const double value) { q[dof] = value; });
    return q;
  }

  /// Force on the blank along r, all nodes.
  double force(Load &bead, const Blank &blank, const double way)
  {
    const Vector q = moved(blank, way);
    DenseTarget target(q.size(), false);
    BOOST_TEST(bead.assemble(q, 1., target).good());
    const Vector unit = moved(blank, 1.);
    double sum = 0.;
    for (DofIndex i = 0; i < q.size(); ++i)
      sum -= unit[i] * target.residual[i];
    return sum;
  }

  void go_to(Load &bead, const Blank &blank, const double way)
  {
    force(bead, blank, way);
    bead.accept(moved(blank, way), 1., 1.);
  }

  void for_shell_and_solid(const std::function<void(Blank &)> &body)
  {
    for (const std::string kind : {"shell", "solid"})
      for (const std::string degree : {"1", "2"})
        BOOST_TEST_CONTEXT(kind << " of degree " << degree)
        {
          Entries entries = strip;
          entries.push_back("Blank/Degree=" + degree);
          body(*make_blank(kind, entries));
        }
  }
} // namespace

BOOST_AUTO_TEST_SUITE(draw_bead)

BOOST_AUTO_TEST_CASE(a_strip_that_is_pulled_past_it)
{
  for_shell_and_solid([](Blank &blank) {
    const auto bead = make_bead(blank);
    const auto close = [](const double a, const double b) { return std::abs(a - b) <= 1e-10; };
    // Half of the length of the bead, twice that, and on.
    BOOST_TEST(close(force(*bead, blank, -.1), 30.));
    BOOST_TEST(close(force(*bead, blank, -.4), 60.));
    go_to(*bead, blank, -.1);
    BOOST_TEST(close(force(*bead, blank, -.16), 48.));
    go_to(*bead, blank, -.4);
    BOOST_TEST(close(bead->restraint()->force, 60.));
    BOOST_TEST(close(bead->restraint()->path, .4));
    // By the trapezoidal rule of two increments.
    BOOST_TEST(close(bead->restraint()->work, .5 * 30. * .1 + .5 * (30. + 60.) * .3));
    // It turns back: a quarter of the elastic slip, then the other way.
    BOOST_TEST(close(force(*bead, blank, -.399), 45.));
    BOOST_TEST(close(force(*bead, blank, -.392), -60.));
    // The last of the sheet runs in: the end is at 2, .1 beyond the bead, then .02, then it has passed.
    BOOST_TEST(close(force(*bead, blank, -.8), 30.));
    BOOST_TEST(close(force(*bead, blank, -.88), 6.));
    BOOST_TEST(force(*bead, blank, -.95) == 0.);
  });
}

BOOST_AUTO_TEST_CASE(a_bead_around_the_axis_is_as_long_as_its_circle)
{
  Entries entries = strip;
  entries.back() = "Material/Model=linear elastic";
  entries[3] = "Blank/Symmetry=axisymmetric";
  entries[0] = "Blank/Points=.5 0; 2.5 0";
  const auto blank = make_blank("shell", entries);
  const auto bead = make_bead(*blank);
  // Every part of the ring moves inwards by .4.
  Vector q(blank->n_dofs());
  for (const auto &[dof, weight] : blank->boundary().volume_weights(Component::r))
    q[dof] = -.4;
  DenseTarget target(q.size(), false);
  BOOST_TEST(bead->assemble(q, 1., target).good());
  BOOST_TEST(std::abs(target.residual.sum() + 60. * 2. * dealii::numbers::PI * 1.1) <= 1e-9);
}

BOOST_AUTO_TEST_CASE(the_tangent_with_a_history)
{
  std::mt19937 generator(21);
  for_shell_and_solid([&](Blank &blank) {
    for (const double way : {-.1, -.399, -.41, -.8})
      BOOST_TEST_CONTEXT("moved by " << way)
      {
        const auto bead = make_bead(blank);
        go_to(*bead, blank, -.05);
        go_to(*bead, blank, way > -.38 ? -.08 : -.4);
        Vector q = random_state(blank, generator, 1e-4);
        q += moved(blank, way);
        const Assembly beside_springs = [&](const Vector &state, AssemblyTarget &target) {
          bead->add(state, 7., target);
          for (DofIndex i = 0; i < state.size(); ++i)
          {
            const double one = 1., force = state[i];
            target.add(&i, 1, target.wants_tangent() ? &one : nullptr, &force);
          }
        };
        BOOST_TEST(tangent_error(beside_springs, q, std::vector<double>(q.size(), 1.), 1e-6) < 1e-6);
      }
  });
}

BOOST_AUTO_TEST_CASE(its_history_is_a_state)
{
  for_shell_and_solid([](Blank &blank) {
    const auto bead = make_bead(blank), other = make_bead(blank);
    go_to(*bead, blank, -.1);
    go_to(*bead, blank, -.13);
    other->set_history(bead->history());
    BOOST_TEST(other->history() == bead->history());
    BOOST_TEST(force(*other, blank, -.15) == force(*bead, blank, -.15));
    BOOST_TEST(std::abs(force(*other, blank, -.15) - 45.) < 1e-10);
    // It closes anew on a sheet that lies elsewhere.
    bead->begin(moved(blank, -.3));
    BOOST_TEST(std::abs(force(*bead, blank, -.3)) < 1e-10);
    BOOST_TEST(std::abs(force(*bead, blank, -.35) - 15.) < 1e-10);
  });
}

BOOST_AUTO_TEST_CASE(what_is_no_bead_is_refused)
{
  for_shell_and_solid([](Blank &blank) {
    BOOST_CHECK_THROW(make_bead(blank, {"bead/Place=3"}), SceneError);
    BOOST_CHECK_THROW(make_bead(blank, {"bead/Length=0"}), SceneError);
    BOOST_CHECK_THROW(make_bead(blank, {"bead/Elastic slip=1"}), SceneError);
    BOOST_CHECK_THROW(make_bead(blank, {"bead/Bend radii=.004"}), SceneError);
  });
}

BOOST_AUTO_TEST_SUITE_END()
