// What blanks say to materials that they cannot serve yet, and that they serve the others.
#include "../materials/other_laws.h"
#include "any_blank.h"

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  // Registered for this program of tests only.
  const Registry<YieldSurface>::Entry hill("test: anisotropic", "Hill 1948", [](Section &) {
    return std::unique_ptr<YieldSurface>(std::make_unique<Hill48>(.6, .6, .6));
  });
  const Registry<YieldSurface>::Entry plane("test: plane stress", "Hill 1948 for shells", [](Section &) {
    return std::unique_ptr<YieldSurface>(std::make_unique<PlaneStressOnly>(std::make_unique<Hill48>(.6, .6, .6)));
  });
  const Registry<BackStress>::Entry chaboche("test: Chaboche", "Two parts", [](Section &) {
    return std::unique_ptr<BackStress>(std::make_unique<Chaboche>(std::vector<Chaboche::Part>{{200., 20.}, {30., 0.}}));
  });
  const Registry<RateFactor>::Entry rate("test: rate", "Cowper and Symonds", [](Section &) {
    return std::unique_ptr<RateFactor>(std::make_unique<CowperSymondsWithHeat>(40., 5., 0., 0.));
  });

  std::unique_ptr<Blank> make(const std::string &kind, const std::string &law, const std::string &name)
  {
    Entries entries = curved(plastic);
    entries.push_back("Units=mm, N, MPa, s");
    entries.push_back("Material/" + law + "/Law=" + name);
    return make_blank(kind, entries);
  }

  void check_refused(const std::string &kind, const std::string &law, const std::string &name,
                     const std::string &reason)
  {
    BOOST_CHECK_EXCEPTION(make(kind, law, name), SceneError, [&](const SceneError &error) {
      BOOST_TEST_MESSAGE(error.what());
      return std::string(error.what()).find(reason) != std::string::npos;
    });
  }
} // namespace

BOOST_AUTO_TEST_SUITE(usable_material)

BOOST_AUTO_TEST_CASE(solids)
{
  check_refused("solid", "Yield surface", "test: plane stress", "shells only");
  check_refused("solid", "Yield surface", "test: anisotropic", "not defined across the thickness");
}

BOOST_AUTO_TEST_CASE(rates_want_a_unit_of_time)
{
  for (const std::string kind : {"shell", "solid"})
  {
    Entries entries = curved(plastic);
    entries.push_back("Material/Rate factor/Law=test: rate");
    BOOST_CHECK_EXCEPTION(make_blank(kind, entries), SceneError, [](const SceneError &error) {
      return std::string(error.what()).find("Units = mm, N, MPa, s") != std::string::npos;
    });
  }
}

BOOST_AUTO_TEST_CASE(shells)
{
  check_refused("shell", "Yield surface", "of a spelling error", "one of");
}

BOOST_AUTO_TEST_CASE(a_law_hears_how_long_an_increment_takes)
{
  // Stretched evenly, so that cells of solids have one stress. Linear hardening and the factor of Cowper and Symonds:
  // sigma = (4 + 20 p) (1 + (p/(t D))^(1/5)), D = 40.
  for (const std::string kind : {"shell", "solid"})
    for (const double duration : {1e-4, .3, 20.})
      for (const bool once_more : {false, true})
      {
        auto blank = make(kind, "Rate factor", "test: rate");
        const auto role = roles(*blank);
        const auto X = blank->positions(Vector(blank->n_dofs()));
        Vector q(blank->n_dofs());
        for (unsigned int i = 0; i < q.size(); ++i)
          if (role[i].node != invalid_index)
            q[i] = (role[i].axis == 0 ? .03 : -.01) * X[role[i].node][role[i].axis];
        blank->begin_increment(duration, 0.);
        if (once_more)
        {
          // At the same time: a millionth of the last one, also where the state has come from another blank.
          const KeyedArrays state = blank->state();
          blank = make(kind, "Rate factor", "test: rate");
          blank->set_state(state);
          blank->begin_increment(0., 0.);
        }
        residual(*blank, q);
        blank->commit(q);
        const Drawing drawing = blank->fields().draw(q, {});
        const auto values = [&](const std::string &name) {
          for (const auto &field : drawing.fields)
            if (field.name == name)
              return field.values;
          return std::vector<double>();
        };
        const auto p = values("equivalent_plastic_strain"), stress = values("stress_von_mises");
        unsigned int n_flowed = 0;
        BOOST_TEST_CONTEXT(kind << ", " << duration << ", once more: " << once_more)
        {
          for (unsigned int i = 0; i < p.size(); ++i)
            if (p[i] > 0.)
            {
              ++n_flowed;
              const double time = once_more ? 1e-6 * duration : duration;
              const double expected = (4. + 20. * p[i]) * (1. + std::pow(p[i] / time / 40., .2));
              BOOST_TEST(stress[i] == expected, boost::test_tools::tolerance(1e-9));
            }
          BOOST_TEST(2u * n_flowed > p.size());
        }
      }
}

BOOST_AUTO_TEST_CASE(laws_that_do_not_go_together)
{
  Entries entries = curved(plastic);
  entries.push_back("Material/Yield surface/Law=test: plane stress");
  entries.push_back("Material/Backstress/Law=test: Chaboche");
  BOOST_CHECK_EXCEPTION(make_blank("shell", entries), SceneError, [](const SceneError &error) {
    return std::string(error.what()).find("not with a surface for plane stress") != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(a_shell_draws_what_its_law_remembers)
{
  const auto blank = make("shell", "Backstress", "test: Chaboche");
  const Drawing drawing = blank->fields().draw(Vector(blank->n_dofs()), {});
  unsigned int n_found = 0;
  for (const auto &field : drawing.fields)
    if (field.name == "backstress_1" || field.name == "backstress_2")
    {
      ++n_found;
      BOOST_TEST(field.n_components == 4u);
      BOOST_TEST(field.unit == "stress");
    }
  BOOST_TEST(n_found == 2u);
}

BOOST_AUTO_TEST_SUITE_END()
