// Any outline of lines and arcs, in the scene or from a file.
#include "../outline_file.h"
#include "../outline_of_corners.h"

#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace deltaform
{
  namespace
  {
    class Outline : public OutlineOfCorners
    {
    public:
      explicit Outline(Section &section)
      {
        const std::string path =
          section.text("Path", Default<std::string>("0 0; 1 0; 1.5 -.5 1 -.5 cw; 1.5 -1"),
                       "Points, separated by semicolons and walked with the blank to the left, as of a profile: 'r z' "
                       "by a straight line, 'r z center_r center_z cw' (ccw) by an arc about a center. Not with File.");
        const std::string file =
          section.text("File", Default<std::string>(""),
                       "File with the same points, one per line, or a DXF file (LINE, ARC, LWPOLYLINE; x is r, y is "
                       "z). Its path starts from the folder in which the program runs.");
        const std::string layer = section.text("Layer", Default<std::string>(""),
                                               "Layer of the DXF file; empty: all layers.");
        const bool reversed = section.flag("Reversed", false,
                                           "Walk the outline the other way: the blank must lie to its left.");
        const double tolerance = section.number("Joint tolerance", 1e-6, Range::positive(), "length",
                                                "Ends of lines and arcs nearer to each other than this are joined.");
        read_ends(section);
        if (file.empty() && !section.given("Path") && !section.documentation())
          section.fail("Path", "give the outline as Path or in a File");
        try
        {
          std::istringstream lines(std::regex_replace(path, std::regex(";"), "\n"));
          set_corners(corners_of(walked(file.empty() ? read_points(lines) : read(file, layer, tolerance), reversed),
                                 tolerance));
        }
        catch (const std::invalid_argument &error)
        {
          section.fail(file.empty() ? "Path" : "File", (file.empty() ? "" : "'" + file + "': ") + error.what());
        }
      }

    private:
      static std::vector<OutlinePiece> read(const std::string &name, const std::string &layer, const double tolerance)
      {
        std::error_code code;
        if (std::filesystem::is_directory(name, code))
          throw std::invalid_argument("it is a folder");
        std::ifstream file(name);
        if (!file)
          throw std::invalid_argument(std::string("the file cannot be read: ") + std::strerror(errno));
        const auto dot = name.rfind('.');
        const std::string ending = dot == std::string::npos ? "" : name.substr(dot);
        return ending == ".dxf" || ending == ".DXF" ? join(read_dxf(file, layer), tolerance) : read_points(file);
      }

      static std::vector<OutlinePiece> walked(const std::vector<OutlinePiece> &path, const bool reversed)
      {
        if (path.empty())
          throw std::invalid_argument("there are fewer than two points");
        if (!reversed)
          return path;
        std::vector<OutlinePiece> other;
        for (auto piece = path.rbegin(); piece != path.rend(); ++piece)
          other.push_back(piece->reversed());
        return other;
      }
    };

    const Registry<Shape>::Entry
      entry("outline",
            "Lines and arcs, also from a file of points or DXF, in the scene's frame",
            make_as<Outline, Shape>);
  } // namespace
} // namespace deltaform
