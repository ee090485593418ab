// The equation of a path's length: its derivative, its direction, what is remembered.
#include "../blanks/any_blank.h"

#include <deltaform/loads/load.h>
#include <deltaform/parameters/section.h>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  /// A strip of a shell that is pulled at its end, with the size of the load as last unknown.
  struct PulledStrip
  {
    PulledStrip()
      : blank(make_blank("shell", {"Blank/Symmetry=plane strain", "Blank/Points=0 0; 4 0", "Blank/Thickness=.5",
                                   "Blank/Elements=4", "Material/Young's modulus=1e3",
                                   "Material/Model=linear elastic"})),
        n(blank->n_dofs())
    {
      ParameterTree tree = ParameterTree::parse(
        "", "test",
        {"load/Kind=edge", "load/Boundary=end", "load/Component=r", "load/Value=t", "load/Control=arc length"});
      Section section = tree.root().sub("load");
      load = LoadRegistry::make("edge", section, *blank);
      load->set_unknown(n);
      load->begin(Vector(n + 1));
    }

    /// Residual of the length's own equation at @p time.
    double missing(const Vector &q, const double time) const
    {
      DenseTarget target(n + 1, false);
      BOOST_TEST_REQUIRE(load->assemble(q, time, target).good());
      return target.residual[n];
    }

    /// All nodes go by @p way along r.
    Vector moved(const double way) const
    {
      Vector q(n + 1);
      blank->rigid_motion(Vector(n), Tensor1({1., 0.}), 0.,
                          [&](const DofIndex dof, const double value) { q[dof] = way * value; });
      q[n] = 2.;
      return q;
    }

    std::unique_ptr<Blank> blank;
    unsigned int n;
    std::unique_ptr<Load> load;
  };
} // namespace

BOOST_AUTO_TEST_SUITE(arc_length)

BOOST_AUTO_TEST_CASE(the_tangent_is_the_derivative)
{
  std::mt19937 generator(5);
  PulledStrip strip;
  std::uniform_real_distribution<double> any(-.1, .1);
  const auto random = [&]() {
    Vector q(strip.n + 1);
    for (auto &value : q)
      value = any(generator);
    return q;
  };
  for (const bool first : {true, false})
  {
    if (!first)
    {
      const Vector q = random();
      strip.missing(q, .3);
      strip.load->accept(q, .3, .1);
    }
    const Assembly assembly = [&](const Vector &state, AssemblyTarget &target) {
      strip.load->assemble(state, .5, target);
      for (DofIndex i = 0; i < state.size(); ++i) // beside it a unit stiffness
      {
        const double one = 1., force = state[i];
        target.add(&i, 1, target.wants_tangent() ? &one : nullptr, &force);
      }
    };
    BOOST_TEST(tangent_error(assembly, random(), std::vector<double>(strip.n + 1, 1.), 1e-5) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(lengths_are_root_mean_squares_of_what_the_nodes_go)
{
  PulledStrip strip;
  // At first the way of what is loaded, then that of all nodes: of a rigid motion they are the same.
  BOOST_TEST(std::abs(strip.missing(strip.moved(.2), .2)) < 1e-14);
  strip.load->accept(strip.moved(.2), .2, .1);
  BOOST_TEST(std::abs(strip.missing(strip.moved(.5), .5)) < 1e-14);
  BOOST_TEST(std::abs(strip.missing(strip.moved(.5), .6)) > .05);
  // Back where the length shrinks.
  BOOST_TEST(std::abs(strip.missing(strip.moved(.1), .1)) < 1e-14);
  strip.load->accept(strip.moved(.1), .1, .1);
  BOOST_TEST(std::abs(strip.missing(strip.moved(.3), .3)) < 1e-14);
}

BOOST_AUTO_TEST_CASE(the_path_is_remembered)
{
  PulledStrip strip, other;
  strip.missing(strip.moved(.2), .2);
  strip.load->accept(strip.moved(.2), .2, .1);
  BOOST_TEST(strip.load->history().size() == other.load->history().size());
  other.load->set_history(strip.load->history());
  BOOST_TEST(std::abs(other.missing(strip.moved(.5), .5)) < 1e-14);
}

BOOST_AUTO_TEST_SUITE_END()
