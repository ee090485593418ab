#include <deltaform/parameters/text.h>
#include <deltaform/parameters/unit_system.h>

#include <cmath>
#include <map>

namespace deltaform
{
  namespace
  {
    using Table = std::map<std::string, double>;

    constexpr double inch = .0254, pound = 4.4482216152605, long_ton = 2240. * pound;

    const Table lengths = {{"m", 1.}, {"cm", .01}, {"mm", 1e-3}, {"um", 1e-6}, {"in", inch}, {"ft", 12. * inch}};
    const Table forces = {
      {"N", 1.},
      {"kN", 1e3},
      {"MN", 1e6},
      {"lbf", pound},
      {"kip", 1e3 * pound},
      {"tonf", long_ton}};
    const Table stresses = {{"Pa", 1.},
                            {"kPa", 1e3},
                            {"MPa", 1e6},
                            {"GPa", 1e9},
                            {"psi", pound / (inch * inch)},
                            {"ksi", 1e3 * pound / (inch * inch)}};

    std::optional<double> find(const Table &table, const std::string &name)
    {
      const auto found = table.find(name);
      return found == table.end() ? std::nullopt : std::optional<double>(found->second);
    }

    /// A name, or "tonf/in^2" and "N/mm2".
    std::optional<double> find_stress(const std::string &name)
    {
      if (const auto known = find(stresses, name))
        return known;
      const auto pieces = text::split(name, '/');
      if (pieces.size() != 2)
        return std::nullopt;
      std::string area = pieces[1];
      if (area.empty() || area.back() != '2')
        return std::nullopt;
      area.erase(area.find_last_not_of("^2") + 1);
      const auto force = find(forces, pieces[0]), length = find(lengths, area);
      return force && length ? std::optional<double>(*force / (*length * *length)) : std::nullopt;
    }
  } // namespace


  std::string UnitSystem::misspelt() const
  {
    for (const auto &piece : text::split(label_, ','))
    {
      if (find(lengths, piece) || find(forces, piece) || find_stress(piece))
        continue;
      for (const auto *const table : {&lengths, &forces, &stresses})
        for (const auto &known : *table)
          if (text::edit_distance(piece, known.first) == 0)
            return "'" + piece + "' is not known; '" + known.first + "' is";
    }
    return "";
  }


  UnitSystem::UnitSystem(const std::string &label)
    : label_(label)
  {
    const auto pieces = text::split(label, ',');
    if (pieces.size() != 3 && pieces.size() != 4) // the fourth is the time
      return;
    length = find(lengths, pieces[0]);
    force = find(forces, pieces[1]);
    stress = find_stress(pieces[2]);
  }


  std::string UnitSystem::objection() const
  {
    if (!length || !force || !stress)
      return "";
    const double ratio = *force / (*length * *length * *stress);
    if (std::abs(ratio - 1.) < 1e-6)
      return "";
    const auto pieces = text::split(label_, ',');
    return "a force of 1 " + pieces[1] + " on an area of 1 " + pieces[0] + "^2 is a stress of " + text::rounded(ratio) +
           " " + pieces[2] + ", not of 1: the three units must go together, such as mm, N, MPa or m, N, Pa";
  }
} // namespace deltaform
