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
  check_refused("solid", "Yield surface", "test: anisotropic", "axes of an anisotropic metal");
  check_refused("solid", "Backstress", "test: Chaboche", "backstress_1");
  check_refused("solid", "Rate factor", "test: rate", "how long");
}

BOOST_AUTO_TEST_CASE(shells)
{
  check_refused("shell", "Rate factor", "test: rate", "how long");
  check_refused("shell", "Yield surface", "of a spelling error", "one of");
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
  const Drawing drawing = blank->draw(Vector(blank->n_dofs()), {});
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
