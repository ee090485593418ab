#include "outline_file.h"

#include <deltaform/io/point_file.h>
#include <deltaform/parameters/text.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace deltaform
{
  namespace
  {
    /// A DXF file is a sequence of codes and values, a line each.
    using Group = std::pair<int, std::string>;

    /// An entity: its kind and its groups.
    struct Entity
    {
      std::string kind;
      std::vector<Group> groups;

      std::string text(const int code) const
      {
        for (const auto &[own, value] : groups)
          if (own == code)
            return value;
        return "";
      }

      double number(const int code) const
      {
        return std::strtod(text(code).c_str(), nullptr);
      }

      Point2 point(const int code) const
      {
        return {number(code), number(code + 10)};
      }
    };

    std::vector<Entity> read_entities(std::istream &file)
    {
      std::vector<Entity> result;
      bool in_section = false;
      std::string code, value, last_value;
      while (std::getline(file, code) && std::getline(file, value))
      {
        char *end = nullptr;
        const long number = std::strtol(code.c_str(), &end, 10);
        if (!text::trim(end).empty())
          throw std::invalid_argument("it is no ASCII DXF file: '" + text::printable(code.substr(0, 40)) +
                                      "' stands where a group code is expected");
        value = text::trim(value);
        if (number == 2 && last_value == "SECTION")
          in_section = value == "ENTITIES";
        else if (number == 0 && value == "ENDSEC")
          in_section = false;
        else if (number == 0 && in_section)
          result.push_back({value, {}});
        else if (in_section && !result.empty())
          result.back().groups.emplace_back(static_cast<int>(number), value);
        last_value = value;
      }
      return result;
    }

    void add_polyline(const Entity &entity, std::vector<OutlinePiece> &pieces)
    {
      std::vector<Point2> points;
      std::vector<double> bulges;
      for (const auto &[code, value] : entity.groups)
      {
        const double number = std::strtod(value.c_str(), nullptr);
        if (code == 10)
        {
          points.emplace_back(number, 0.);
          bulges.push_back(0.);
        }
        else if (code == 20 && !points.empty())
          points.back()[1] = number;
        else if (code == 42 && !bulges.empty())
          bulges.back() = number;
      }
      const bool closed = (static_cast<int>(entity.number(70)) & 1) != 0;
      for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i)
        pieces.push_back({points[i], points[(i + 1) % points.size()], bulges[i]});
    }

    void add_arc(const Entity &entity, std::vector<OutlinePiece> &pieces)
    {
      const Point2 center = entity.point(10);
      const double radius = entity.number(40), degree = dealii::numbers::PI / 180.;
      const auto at = [&](const double angle) {
        return center + radius * Tensor1({std::cos(angle * degree), std::sin(angle * degree)});
      };
      pieces.push_back(arc_about(center, at(entity.number(50)), at(entity.number(51)), true));
    }
  } // namespace


  std::vector<OutlinePiece> read_points(std::istream &file)
  {
    std::vector<OutlinePiece> result;
    Point2 last;
    bool any = false;
    for (const PointLine &line : point_lines(file))
    {
      std::istringstream words(line.words);
      Point2 point, center;
      std::string sense;
      bool good = static_cast<bool>(words >> point[0] >> point[1]);
      const bool arc = good && !(words >> std::ws).eof();
      if (arc)
        good = (words >> center[0] >> center[1] >> sense) && (sense == "cw" || sense == "ccw") && any;
      if (!good || !(words >> std::ws).eof() || !std::isfinite(point.norm()))
        throw std::invalid_argument("line " + std::to_string(line.number) +
                                    " is neither 'r z' nor, behind a first point, 'r z center_r center_z cw' or ccw");
      if (arc && std::abs(center.distance(last) - center.distance(point)) > 1e-3 * center.distance(point))
        throw std::invalid_argument("line " + std::to_string(line.number) +
                                    ": the center is not as far from the point before as from this one");
      if (any)
        result.push_back(arc ? arc_about(center, last, point, sense == "ccw") : OutlinePiece{last, point, 0.});
      last = point;
      any = true;
    }
    return result;
  }


  std::vector<OutlinePiece> read_dxf(std::istream &file, const std::string &layer)
  {
    std::vector<OutlinePiece> result;
    for (const Entity &entity : read_entities(file))
    {
      if (!layer.empty() && entity.text(8) != layer)
        continue;
      if (entity.kind == "LINE")
        result.push_back({entity.point(10), entity.point(11), 0.});
      else if (entity.kind == "ARC")
        add_arc(entity, result);
      else if (entity.kind == "LWPOLYLINE")
        add_polyline(entity, result);
    }
    if (result.empty())
      throw std::invalid_argument("it has no LINE, ARC or LWPOLYLINE" +
                                  (layer.empty() ? std::string() : " on layer '" + layer + "'"));
    return result;
  }
} // namespace deltaform
