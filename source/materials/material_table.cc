#include <deltaform/io/shipped_file.h>
#include <deltaform/materials/material_table.h>
#include <deltaform/parameters/expression.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/text.h>

#include <algorithm>
#include <stdexcept>

namespace deltaform
{
  namespace
  {
    constexpr const char *section = "Material";

    double number(const SceneFile::Entry &entry, const std::string &text)
    {
      try
      {
        return evaluate_number(text);
      }
      catch (const std::invalid_argument &error)
      {
        throw SceneError(entry.origin.to_string() + ": " + entry.name + " = " + entry.value + ": " + error.what() +
                         ".");
      }
    }

    /// "206e3 MPa" in units of @p unit_of_stress Pa; what is no stress stays as it is.
    std::string converted(const SceneFile::Entry &entry, const double unit_of_stress)
    {
      const std::string unit = " MPa";
      const std::string &value = entry.value;
      if (value.size() < unit.size() || value.compare(value.size() - unit.size(), unit.size(), unit) != 0)
        return value;
      const double stress = number(entry, value.substr(0, value.size() - unit.size()));
      return text::format(unit_of_stress == 1e6 ? stress : stress * 1e6 / unit_of_stress);
    }

    bool is_direction(const SceneFile::Entry &entry)
    {
      return entry.name == "r0" || entry.name == "r45" || entry.name == "r90";
    }

    /// A sheet without rolling direction has the mean of its r values; one with it does without r45.
    void choose_anisotropy(std::vector<SceneFile::Entry> &entries, const bool rolling_direction)
    {
      std::vector<SceneFile::Entry> rest;
      double sum = 0., weights = 0.;
      const SceneFile::Entry *first = nullptr;
      for (const auto &entry : entries)
        if (!is_direction(entry) || (rolling_direction && entry.name != "r45"))
          rest.push_back(entry);
        else if (!rolling_direction)
        {
          const double weight = entry.name == "r45" ? 2. : 1.;
          sum += weight * number(entry, entry.value);
          weights += weight;
          first = first == nullptr ? &entry : first;
        }
      if (first != nullptr)
      {
        rest.push_back(*first);
        rest.back().name = "r-bar";
        rest.back().value = text::format(sum / weights);
      }
      entries = std::move(rest);
    }
  } // namespace


  MaterialTable::MaterialTable(const std::string &file_name)
    : file_(SceneFile::read(file_name))
  {
  }


  std::string MaterialTable::shipped()
  {
    return shipped_file("materials.prm");
  }


  std::vector<std::string> MaterialTable::names() const
  {
    std::vector<std::string> result;
    for (const auto &subsection : file_.subsections)
      if (subsection.path.size() == 1)
        result.push_back(subsection.path.front());
    std::sort(result.begin(), result.end());
    return result;
  }


  std::string MaterialTable::source(const std::string &metal) const
  {
    const auto *const entry = file_.find({metal}, "Source");
    return entry == nullptr ? "" : entry->value;
  }


  std::vector<SceneFile::Entry> MaterialTable::entries(const std::string &metal,
                                                       const double unit_of_stress,
                                                       const bool rolling_direction) const
  {
    std::vector<SceneFile::Entry> result;
    for (const auto &entry : file_.entries)
    {
      if (entry.path.empty() || entry.path.front() != metal || (entry.path.size() == 1 && entry.name == "Source"))
        continue;
      SceneFile::Entry own = entry;
      own.path.front() = section;
      own.value = converted(entry, unit_of_stress);
      result.push_back(std::move(own));
    }
    choose_anisotropy(result, rolling_direction);
    return result;
  }
} // namespace deltaform
