// Material/Name: entries from a table of metals.
#include <deltaform/materials/material_table.h>
#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>
#include <deltaform/parameters/unit_system.h>
#include <deltaform/scene/scene.h>

#include <algorithm>
#include <filesystem>

namespace deltaform
{
  namespace
  {
    const std::string name_entry = "Name", table_entry = "Table";

    /// The file of the table, as it is to be opened.
    std::string table_file(const Section &material, const std::string &asked, const std::string &scene)
    {
      if (!asked.empty())
        return (std::filesystem::path(scene).parent_path() / asked).lexically_normal().string();
      std::string shipped = MaterialTable::shipped();
      if (shipped.empty())
        material.fail(name_entry,
                      "the table that comes with the program, share/deltaform/materials.prm, is not where the program "
                      "is: name a table in Material/Table");
      return shipped;
    }
  } // namespace


  void Scene::supply_material(const Section &root)
  {
    Section material = root.sub("Material");
    const std::string metal =
      material.text(name_entry,
                    Default<std::string>(""),
                    "Name of a metal in the table (deltaform --list). Its entries hold where the scene states none.");
    const std::string asked =
      material.text(table_entry,
                    Default<std::string>(""),
                    "File with metals of your own, relative to the scene; empty: the table of the program.");
    if (root.documentation())
      return;
    if (metal.empty())
    {
      if (!asked.empty())
        material.fail(table_entry, "no metal of it is chosen: set Name");
      return;
    }

    const MaterialTable table(table_file(material, asked, tree.file_name()));
    const auto names = table.names();
    if (std::find(names.begin(), names.end(), metal) == names.end())
      material.fail(name_entry,
                    names.empty() ? "the table is empty"
                                  : "is not in the table, which has " + text::join(names, ", ") + "; the nearest is '" +
                                      text::nearest(metal, names) + "'");
    const UnitSystem unit_system(units);
    if (!unit_system.stress)
      material.fail(name_entry,
                    "the table is in MPa, and Units = " + units +
                      " does not say in which unit stresses are: set Units = mm, N, MPa, for example");

    const SectionPath surface{"Material", "Yield surface"};
    const bool rolling_direction = tree.stated({"Blank"}, "Symmetry") == "plane strain";
    const bool own_anisotropy = !tree.stated(surface, "r-bar").empty() || !tree.stated(surface, "r0").empty() ||
                                !tree.stated(surface, "r90").empty();
    std::vector<std::string> own;
    for (const auto &entry : table.entries(metal, *unit_system.stress, rolling_direction))
    {
      const std::string stated = tree.stated(entry.path, entry.name);
      if (!stated.empty() && stated != entry.value)
        own.push_back(to_string(entry.path, entry.name));
      const bool is_anisotropy = entry.name == "r-bar" || entry.name == "r0" || entry.name == "r90";
      if (!(is_anisotropy && own_anisotropy))
        tree.supply(entry);
    }
    if (!own.empty())
      notes.push_back("the scene's own " + text::join(own, ", ") + " count more than those of the table's metal '" +
                      metal + "'");
  }
} // namespace deltaform
