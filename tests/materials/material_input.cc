// What a scene may not say about a material.
#include "material_point.h"

#include <deltaform/parameters/scene_error.h>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  /// @p entry with a value out of range stops every material, by a message that names it.
  void check_refused(const std::string &entry, const std::string &value)
  {
    for (const auto &name : Registry<Material>::names())
      BOOST_TEST_CONTEXT(name << ", " << entry << " = " << value)
    BOOST_CHECK_EXCEPTION(make_material(name, "perfectly plastic", {"Material/" + entry + "=" + value}),
                          SceneError,
                          [&](const SceneError &error) {
                            return std::string(error.what()).find(entry) != std::string::npos;
                          });
  }
} // namespace

BOOST_AUTO_TEST_SUITE(material_input)

BOOST_AUTO_TEST_CASE(elastic_constants)
{
  for (const std::string value : {"0.5", "0.6", "-1", "nan", "a"})
    check_refused("Poisson's ratio", value);
  for (const std::string value : {"0", "-210e3", "nan", "inf"})
    check_refused("Young's modulus", value);
  for (const std::string value : {"-0.999", "0", "0.4999999"})
    BOOST_CHECK_NO_THROW(make_material("elastoplastic", "swift", {"Material/Poisson's ratio=" + value}));
}

BOOST_AUTO_TEST_CASE(unknown_law)
{
  BOOST_CHECK_EXCEPTION(make_material("elastoplastic", "swift", {"Material/Hardening/Law=swfit"}),
                        SceneError,
                        [](const SceneError &error) {
                          return std::string(error.what()).find("nearest: swift") != std::string::npos;
                        });
}

BOOST_AUTO_TEST_CASE(negative_saturation)
{
  const auto refused = [](const std::string &hardening, const std::vector<std::string> &entries,
                          const std::string &entry) {
    BOOST_CHECK_EXCEPTION(make_material("elastoplastic", hardening, entries), SceneError, [&](const SceneError &error) {
      return std::string(error.what()).find(entry) != std::string::npos;
    });
  };
  refused("voce", {"Material/Hardening/Saturation stress=-715"}, "Saturation stress");
  refused("voce", {"Material/Hardening/Saturation rate=-5"}, "Saturation rate");
  refused("hockett-sherby", {"Material/Hardening/Saturation stress=-380"}, "Saturation stress");
  refused("swift", {"Material/Backstress/Law=chaboche", "Material/Backstress/Terms=20000 -100"}, "Terms");
  for (const std::string entry : {"Bounding backstress", "Saturation stress", "Bounding surface rate", "Stagnation"})
    refused("perfectly plastic",
            {"Material/Backstress/Law=yoshida-uemori",
             "Material/Hardening/Flow stress=337",
             "Material/Backstress/Yield stress=337",
             "Material/Backstress/Bounding stress=620",
             "Material/Backstress/Yield surface rate=500",
             "Material/Backstress/Bounding surface rate=34",
             "Material/Backstress/Bounding backstress=202",
             "Material/Backstress/Stagnation=.772",
             "Material/Backstress/Saturation stress=190",
             "Material/Backstress/" + entry + "=-1"},
            entry);
}

BOOST_AUTO_TEST_SUITE_END()
