#include <deltaform/app/forming_limit_diagram.h>
#include <deltaform/io/atomic_file.h>
#include <deltaform/materials/forming_limit.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>
#include <deltaform/scene/scene.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

namespace deltaform
{
  namespace
  {
    constexpr double width = 800., height = 640., left = 80., right = 30., top = 60., bottom = 70.; // pixels

    /// Strains to pixels, with a grid of tenths.
    class Diagram
    {
    public:
      explicit Diagram(const std::vector<FormingLimit::Point> &points)
      {
        for (const auto &point : points)
        {
          least_ = std::min(least_, std::floor(10. * point.minor) / 10.);
          most_ = std::max(most_, std::ceil(10. * point.minor) / 10.);
          highest_ = std::max(highest_, std::ceil(10.5 * point.major) / 10.);
        }
      }

      double x(const double minor) const
      {
        return left + (width - left - right) * (minor - least_) / (most_ - least_);
      }

      double y(const double major) const
      {
        return height - bottom - (height - top - bottom) * major / highest_;
      }

      void draw_grid(std::ostream &out) const
      {
        const auto line = [&](const double minor_a, const double major_a, const double minor_b, const double major_b) {
          out << fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#cccccc\"/>\n",
                             x(minor_a), y(major_a), x(minor_b), y(major_b));
        };
        const auto tenths = [](const double strain) { return static_cast<int>(std::lround(10. * strain)); };
        for (int i = tenths(least_); i <= tenths(most_); ++i)
        {
          const double minor = .1 * i;
          line(minor, 0., minor, highest_);
          out << fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{:.1f}</text>\n", x(minor),
                             height - bottom + 20., minor);
        }
        for (int i = 0; i <= tenths(highest_); ++i)
        {
          const double major = .1 * i;
          line(least_, major, most_, major);
          out << fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{:.1f}</text>\n", left - 8.,
                             y(major) + 5., major);
        }
        out << fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">minor strain</text>\n",
                           .5 * (left + width - right), height - 20.)
            << fmt::format("<text x=\"25\" y=\"{0:.1f}\" text-anchor=\"middle\" transform=\"rotate(-90 25 {0:.1f})\">"
                           "major strain</text>\n",
                           .5 * (top + height - bottom));
      }

    private:
      double least_ = -.1, most_ = .1, highest_ = .1;
    };

    /// What --set says, with the forming limit among the criteria.
    std::vector<std::string> with_forming_limit(const CommandLine &command)
    {
      const auto tree = ParameterTree::read(command.scene, command.sets);
      auto criteria = text::split(tree.stated({"Limits"}, "Criteria"), ',');
      if (std::find(criteria.begin(), criteria.end(), "forming limit") == criteria.end())
        criteria.emplace_back("forming limit");
      auto sets = command.sets;
      sets.push_back("Limits/Criteria=" + text::join(criteria, ", "));
      return sets;
    }
  } // namespace


  void draw_forming_limit(const FormingLimit &limit, std::ostream &out)
  {
    const Diagram diagram(limit.points());
    out << fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" viewBox=\"0 0 {0:g} "
                       "{1:g}\" font-family=\"sans-serif\" font-size=\"15\">\n"
                       "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
                       width, height);
    diagram.draw_grid(out);
    out << "<polyline fill=\"none\" stroke=\"#b00020\" stroke-width=\"2.5\" points=\"";
    for (const auto &point : limit.points())
      out << fmt::format("{:.2f},{:.2f} ", diagram.x(point.minor), diagram.y(point.major));
    out << "\"/>\n";
    for (const auto &point : limit.points())
      out << fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"3.5\" fill=\"#b00020\"/>\n", diagram.x(point.minor),
                         diagram.y(point.major));
    out << "<text x=\"" << left << "\" y=\"30\">Forming limit, logarithmic strains</text>\n</svg>\n";
  }


  int write_forming_limit(const CommandLine &command)
  {
    auto tree = ParameterTree::read(command.scene, with_forming_limit(command));
    const Scene scene(tree); // which checks all of it, and knows what a metal's name stands for
    Section root = tree.root(), material = root.sub("Material");
    const auto law = Registry<Material>::choose(material, "Model", "elastoplastic", "Stress-strain law.");
    const auto limit = read_forming_limit(root, *law);

    const std::string folder =
      command.output.empty() ? "output/" + std::filesystem::path(command.scene).stem().string() : command.output;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
      throw SceneError("Cannot make the folder '" + folder + "': " + error.message() + ".");
    write_file_atomically(folder + "/fld.csv", [&](std::ostream &out) {
      out << "# forming limit of " << command.scene << ", logarithmic strains\nminor_strain,major_strain\n";
      for (const auto &point : limit->points())
        out << text::format(point.minor) << ',' << text::format(point.major) << '\n';
    });
    write_file_atomically(folder + "/fld.svg",
                          [&](std::ostream &out) { draw_forming_limit(*limit, out); });
    std::cout << "the forming limit, " << text::rounded(limit->major(0.)) << " in plane strain, is in " << folder
              << "/fld.csv and fld.svg\n";
    return exit_status::done;
  }
} // namespace deltaform
