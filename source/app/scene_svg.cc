#include <deltaform/app/scene_svg.h>
#include <deltaform/blanks/boundary.h>
#include <deltaform/blanks/fields.h>
#include <deltaform/parameters/text.h>
#include <deltaform/scene/scene.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace deltaform
{
  namespace
  {
    constexpr double width = 1000., margin = 60., head = 50.; // pixels
    const char *const colours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};

    struct Box
    {
      Point2 low = Point2(1e300, 1e300), high = Point2(-1e300, -1e300);

      void add(const Point2 &x)
      {
        for (unsigned int d = 0; d < 2; ++d)
        {
          low[d] = std::min(low[d], x[d]);
          high[d] = std::max(high[d], x[d]);
        }
      }
    };

    /// From the scene to pixels; z points up.
    class View
    {
    public:
      explicit View(Box box)
      {
        const double size = std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
        for (unsigned int d = 0; d < 2; ++d)
        {
          box.low[d] -= .08 * size;
          box.high[d] += .08 * size;
        }
        box_ = box;
        scale_ = (width - 2 * margin) / (box.high[0] - box.low[0]);
      }

      double height() const
      {
        return head + margin + scale_ * (box_.high[1] - box_.low[1]);
      }

      double x(const double r) const
      {
        return margin + scale_ * (r - box_.low[0]);
      }

      double y(const double z) const
      {
        return head + scale_ * (box_.high[1] - z);
      }

      std::string points(const std::vector<Point2> &line) const
      {
        std::string result;
        for (const auto &p : line)
          result += fmt::format("{:.2f},{:.2f} ", x(p[0]), y(p[1]));
        return result;
      }

    private:
      Box box_;
      double scale_;
    };

    /// Between tags or quotes; XML has no place for control characters.
    std::string escaped(const std::string &raw)
    {
      std::string result;
      for (const char c : text::printable(raw))
        result += c == '<' ? "&lt;" : c == '&' ? "&amp;"
                                    : c == '>' ? "&gt;"
                                    : c == '"' ? "&quot;"
                                               : std::string(1, c);
      return result;
    }

    void draw_blank(const Drawing &drawing, const View &view, std::ostream &out)
    {
      out << "<g id=\"blank\" fill=\"#b9c6d3\" stroke=\"#5b6875\" stroke-width=\".5\">\n";
      for (std::size_t c = 0; c < drawing.cells.size(); c += drawing.points_per_cell)
      {
        std::vector<Point2> corners;
        for (unsigned int i = 0; i < drawing.points_per_cell; ++i)
          corners.push_back(drawing.points[drawing.cells[c + i]]);
        out << "<polygon points=\"" << view.points(corners) << "\"/>\n";
      }
      out << "</g>\n";
    }

    void draw_tool(const Tool &tool, const char *const colour, const double end, const double reach, const View &view,
                   std::ostream &out)
    {
      const auto line = [&](const double travel, const char *const style) {
        out << "<polyline fill=\"none\" stroke=\"" << colour << "\" " << style << " points=\""
            << view.points(tool.polyline(travel, reach)) << "\"/>\n";
      };
      out << "<g id=\"" << escaped(tool.name()) << "\">\n";
      line(tool.travel(0.), "stroke-width=\"2.5\"");
      if (!tool.force_driven() && tool.travel(end) != tool.travel(0.))
        line(tool.travel(end), "stroke-width=\"1.2\" stroke-dasharray=\"6 5\"");
      out << "</g>\n";
    }

    /// A triangle that points along the direction that is held, a ring for a rotation.
    void draw_support(const Support &support, const Blank &blank, const View &view, std::ostream &out)
    {
      const auto points = blank.boundary().points(support.boundary);
      const std::size_t stride = points.size() / 9 + 1; // a few marks tell enough
      out << "<g class=\"support\" fill=\"none\" stroke=\"#b00020\" stroke-width=\"1.5\"><title>"
          << escaped(support.name) << "</title>\n";
      for (std::size_t i = 0; i < points.size(); i += stride)
      {
        const double x = view.x(points[i][0]), y = view.y(points[i][1]);
        if (support.component == Component::rotation)
          out << fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"7\"/>\n", x, y);
        else if (support.component == Component::r)
          out << fmt::format("<path d=\"M{:.2f} {:.2f} l-12 -6 v12 z\"/>\n", x, y);
        else
          out << fmt::format("<path d=\"M{:.2f} {:.2f} l-6 12 h12 z\"/>\n", x, y);
      }
      out << "</g>\n";
    }
  } // namespace


  void draw_svg(const Scene &scene, std::ostream &out)
  {
    const Actors &actors = scene.actors;
    const Drawing drawing = actors.blank->fields().draw(Vector(actors.blank->n_dofs()), {});
    Box box;
    double reach = 0.;
    for (const auto &x : drawing.points)
    {
      box.add(x);
      reach = std::max(reach, x.norm());
    }
    const double end = actors.stages.back().end;
    const double size = std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
    const Box blank = box;
    // Tools count where they are near: walls may be endless.
    const auto is_near = [&](const Point2 &x) {
      return x[0] > blank.low[0] - .15 * size && x[0] < blank.high[0] + .15 * size &&
             x[1] > blank.low[1] - .45 * size && x[1] < blank.high[1] + .45 * size;
    };
    for (const auto &tool : actors.tools)
    {
      const double first = tool->travel(0.), last = tool->force_driven() ? first : tool->travel(end);
      for (const double travel : {first, last})
        for (const auto &x : tool->polyline(travel, reach))
          if (is_near(x))
            box.add(x);
      // Where a face that begins at the blank ends: a punch may go deeper than the blank is long.
      if (std::abs(last - first) < 2. * size)
        for (const auto &x : tool->polyline(first, reach))
          if (is_near(x))
            box.add(x + (last - first) * tool->direction());
    }
    const View view(box);
    out << fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" "
                       "height=\"{1:g}\" font-family=\"sans-serif\" font-size=\"14\">\n",
                       width, view.height())
        << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    if (actors.blank->axisymmetric())
      out << fmt::format("<line x1=\"{0:.2f}\" x2=\"{0:.2f}\" y1=\"{1:g}\" y2=\"{2:g}\" stroke=\"#999999\" "
                         "stroke-dasharray=\"12 4 2 4\"/>\n",
                         view.x(0.), head, view.height());
    draw_blank(drawing, view, out);
    for (std::size_t i = 0; i < actors.tools.size(); ++i)
    {
      const char *const colour = colours[i % std::size(colours)];
      draw_tool(*actors.tools[i], colour, end, reach, view, out);
    }
    for (const auto &support : actors.supports)
      draw_support(support, *actors.blank, view, out);
    // Above what is drawn: walls may go on for ever.
    out << "<rect width=\"100%\" height=\"" << head << "\" fill=\"white\"/>\n<text x=\"" << margin << "\" y=\"22\">"
        << escaped(scene.title) << "</text>\n";
    for (std::size_t i = 0; i < actors.tools.size(); ++i)
      out << "<text x=\"" << margin + 110. * static_cast<double>(i) << "\" y=\"42\" fill=\""
          << colours[i % std::size(colours)] << "\">" << escaped(actors.tools[i]->name()) << "</text>\n";
    out << "</svg>\n";
  }
} // namespace deltaform
