#include "shell_refinement.h"
#include "face_points.h"

#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/section.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    constexpr const char *key = "elements of the first mesh", *key_of_left = "elements left alone",
                         *key_of_bent = "elements that were bent";

    std::vector<ShellMesh::Part> whole(const ShellMesh &mesh)
    {
      std::vector<ShellMesh::Part> result;
      for (unsigned int c = 0; c < mesh.cells().size(); ++c)
        result.push_back({c, 0., 1.});
      return result;
    }

    /// @throws SceneError if the parts do not make up a mesh of so many elements
    std::vector<ShellMesh::Part> parts_of(const std::vector<double> &numbers, const std::size_t n_first)
    {
      std::vector<ShellMesh::Part> result;
      bool good = numbers.size() % 3 == 0;
      unsigned int cell = 0;
      double end = 0.;
      for (std::size_t i = 0; good && i < numbers.size(); i += 3)
      {
        if (end == 1.)
        {
          ++cell;
          end = 0.;
        }
        good = cell < n_first && numbers[i] == cell && numbers[i + 1] == end && numbers[i + 2] > end &&
               numbers[i + 2] <= 1.;
        end = numbers[i + 2];
        result.push_back({cell, numbers[i + 1], end});
      }
      if (!good || end != 1. || cell + 1 != n_first)
        throw SceneError("The saved state has no whole mesh: it is damaged, or that of another scene. Start again.");
      return result;
    }

    FacePoints face_points(const ShellSpace &space, const ShellSurface &surface)
    {
      FacePoints result;
      result.places = space.mesh().nodes();
      result.edges = surface.contact_edges(Side::top);
      for (unsigned int e = 0; e < result.edges.size() && !surface.at_nodes(); ++e)
      {
        result.inside.emplace_back();
        for (const auto &point : surface.points_of_edge(Side::top, e))
          result.inside.back().push_back(point[0]);
      }
      return result;
    }

    BendLimit bend_limit(Section &section, const ShellParts &parts)
    {
      const double largest =
        dealii::numbers::PI / 180. *
        section.number("Largest bend",
                       15.,
                       Range::between(0., 60.),
                       "degree",
                       "An element that bends by more while tools form the sheet is halved, and so is one "
                       "that would on the round part of a tool that it comes to; less where the sheet "
                       "hardly yields; 0: none is.");
      return {largest,
              2. * parts.material().initial_flow_stress() /
                (parts.material().law().young_modulus() * parts.points().thickness())};
    }
  } // namespace


  ShellRefinement::ShellRefinement(Section section, const ShellParts &parts)
    : limit_(bend_limit(section, parts)), parts_(parts), first_(parts.space().mesh()), elements_(whole(first_))
  {
    shortest_ = parts.points().thickness() *
                section.number("Shortest element",
                               .25,
                               Range::positive(),
                               "thickness",
                               "None becomes shorter than this.");
    joins_ = section.flag("Join halves",
                          true,
                          "Join the halves of an element again where the sheet is straight, as behind a radius.");
    settings_.active = active();
    settings_.passes = 30;
    settings_.edge_share = 1.5 * limit_.largest();
    settings_.smooth = true;
    settings_.from_the_start = true;
    settings_.asked_for = false;
    bends_.assign(elements_.size(), 0.);
    were_bent_.assign(elements_.size(), false);
  }


  bool ShellRefinement::mark(const std::array<std::vector<double>, 2> &longest_edges)
  {
    // A sheet may touch a round part and not bend around it, as the edge of a holder: wait until it begins to bend
    // towards it, if the element can follow that far.
    constexpr double begins = .3, flat = 2.;
    constexpr unsigned int most = 20000; // whatever a scene asks for
    const unsigned int n = elements_.size();
    if (n > most)
      return false;
    std::vector<double> lengths;
    for (unsigned int c = 0; c < n; ++c)
      lengths.push_back(length(c));
    marked_.assign(n, false);
    for (unsigned int c = 0; c < n; ++c)
      marked_[c] = std::abs(bends_[c]) > limit_.at(std::abs(bends_[c]) / lengths[c]) && !left_alone(c, false);
    for (const unsigned int side : {0, 1})
    {
      const std::vector<double> &longest = longest_edges[side];
      for (std::size_t e = 0; e < longest.size(); ++e)
      {
        const std::size_t c = e * n / longest.size(); // the halves of one of degree 2 are edges
        const double edge = lengths[c] * n / longest.size();
        const double towards = static_cast<Side>(side) == Side::top ? bends_[c] : -bends_[c];
        const double allowed = (towards > begins * limit_.largest() ? 1. : flat) * longest[e] *
                               limit_.share(settings_.edge_share / longest[e]);
        if (edge > allowed && !marked_[c])
          marked_[c] = !left_alone(c, true);
      }
    }
    for (unsigned int c = 0; c < n; ++c)
      if (!marked_[c] && will_bend(c, lengths))
        marked_[c] = !left_alone(c, true);
    bool any = false;
    for (unsigned int c = 0; c < n; ++c)
    {
      marked_[c] = marked_[c] && .5 * lengths[c] >= shortest_;
      if (marked_[c])
        lengths[c] *= .5;
      any = any || marked_[c];
    }
    if (any)
      mark_neighbours(lengths);
    return mark_to_join(lengths, longest_edges) || any;
  }


  double ShellRefinement::length(const unsigned int element) const
  {
    const ShellMesh &mesh = parts_.space().mesh();
    const auto &nodes = mesh.cells()[element].nodes;
    return mesh.arc_length()[nodes[1]] - mesh.arc_length()[nodes[0]];
  }


  bool ShellRefinement::will_bend(const unsigned int element, const std::vector<double> &lengths) const
  {
    constexpr unsigned int reach = 3;
    constexpr double much_longer = 1.5, nearly = .75;
    const unsigned int end = std::min<unsigned int>(element + reach + 1, lengths.size());
    for (unsigned int k = std::max(element, reach) - reach; k < end; ++k)
    {
      const double curvature = std::abs(bends_[k]) / lengths[k];
      if (lengths[element] > much_longer * lengths[k] &&
          curvature * lengths[element] > nearly * limit_.at(curvature))
        return true;
    }
    return false;
  }


  bool ShellRefinement::mark_to_join(const std::vector<double> &lengths,
                                     const std::array<std::vector<double>, 2> &longest_edges)
  {
    joined_.assign(elements_.size(), false);
    if (!joins_ || elements_.size() == first_.cells().size())
      return false;
    std::vector<ShellMesh::Part> left;
    for (const Left &one : left_)
      left.push_back(one.part);
    joined_ = ShellJoining(parts_, limit_)
                .choose({elements_, bends_, were_bent_, lengths, marked_, short_for_tools(longest_edges), left});
    return std::find(joined_.begin(), joined_.end(), true) != joined_.end();
  }


  std::vector<bool> ShellRefinement::short_for_tools(const std::array<std::vector<double>, 2> &longest_edges) const
  {
    constexpr double share = .5; // of what a tool allows: none is halved again at once
    const unsigned int n = elements_.size();
    std::vector<bool> result(n, false);
    for (const auto &longest : longest_edges)
      for (std::size_t e = 0; e < longest.size(); ++e)
      {
        const std::size_t c = e * n / longest.size();
        const double edge = length(c) * n / longest.size();
        if (2. * edge > share * longest[e])
          result[c] = true;
      }
    return result;
  }


  bool ShellRefinement::left_alone(const unsigned int element, const bool by_contact) const
  {
    constexpr double much_more = 1.25;
    const ShellMesh::Part &part = elements_[element];
    const double bend = std::abs(bends_[element]);
    return std::any_of(left_.begin(), left_.end(), [&](const Left &left) {
      return left.part == part && (by_contact || bend < much_more * std::max(left.bend, limit_.largest()));
    });
  }


  void ShellRefinement::leave_marked()
  {
    for (const Left &tried : tried_)
    {
      const auto same = std::find_if(left_.begin(), left_.end(), [&](const Left &l) { return l.part == tried.part; });
      if (same == left_.end())
        left_.push_back(tried);
      else
        same->bend = tried.bend;
    }
  }


  void ShellRefinement::mark_neighbours(std::vector<double> &lengths)
  {
    const unsigned int n = marked_.size();
    const auto mark = [&](const unsigned int c) {
      marked_[c] = true;
      lengths[c] *= .5;
    };
    // What will come to the tool next, so that not every element is an event of its own.
    const std::vector<bool> first = marked_;
    const std::vector<double> before = lengths;
    for (unsigned int c = 0; c < n; ++c)
      for (unsigned int k = std::max(c, 3U) - 3; first[c] && k < std::min(c + 4, n); ++k)
        if (!marked_[k] && lengths[k] > 1.5 * before[c])
          mark(k);
    // A little more than twice as long: the elements of a graded mesh differ as well.
    const auto spread = [&](const unsigned int from, const unsigned int to) {
      if (marked_[from] && !marked_[to] && lengths[to] > 2.5 * lengths[from])
        mark(to);
    };
    for (unsigned int c = 0; c + 1 < n; ++c)
      spread(c, c + 1);
    for (unsigned int c = n - 1; c > 0; --c)
      spread(c, c - 1);
  }


  void ShellRefinement::set_mesh(const std::vector<ShellMesh::Part> &elements)
  {
    elements_ = elements;
    parts_.set_mesh(first_.divided(elements_));
    bends_.assign(elements_.size(), 0.);
    were_bent_.assign(elements_.size(), false);
    edge_lengths_.clear(); // not known before the next update()
  }


  void ShellRefinement::refine(std::vector<Vector> &fields)
  {
    std::vector<ShellMesh::Part> elements;
    std::vector<bool> were_bent;
    tried_.clear();
    for (unsigned int c = 0; c < elements_.size(); ++c)
    {
      const auto [cell, begin, end] = elements_[c];
      const double middle = .5 * (begin + end);
      if (joined_[c])
        elements.push_back({cell, begin, elements_[c + 1].end});
      else if (marked_[c])
        elements.insert(elements.end(), {{cell, begin, middle}, {cell, middle, end}});
      else
        elements.push_back(elements_[c]);
      were_bent.resize(elements.size(), were_bent_[c]);
      if (joined_[c] || marked_[c])
        tried_.push_back({joined_[c] ? elements.back() : elements_[c], std::abs(bends_[c])});
      if (joined_[c])
        ++c;
    }
    const ShellTransfer transfer(
      parts_.space(), parts_.points(), parts_.material(), ShellTransfer::Correspondence::arc_length);
    const FacePoints old_points = face_points(parts_.space(), parts_.surface());
    KeyedArrays formed = parts_.state_of_metal();
    transfer.describe(fields.front(), formed);
    // A new node lies on a curve through the others, and moves with it: so does it with the steps.
    std::vector<KeyedArrays> formed_before(fields.size());
    for (std::size_t i = 1; i < fields.size(); ++i)
    {
      Vector before = fields.front();
      before -= fields[i];
      transfer.describe(before, formed_before[i]);
    }
    set_mesh(elements);
    were_bent_ = were_bent;
    point_origins_.fill(deltaform::point_origins(old_points, face_points(parts_.space(), parts_.surface())));
    fields.front() = parts_.come_over(transfer, formed);
    for (std::size_t i = 1; i < fields.size(); ++i)
    {
      Vector before(parts_.space().n_dofs());
      transfer.set_unknowns(formed_before[i], before);
      fields[i] = fields.front();
      fields[i] -= before;
    }
    update(fields.front());
  }


  void ShellRefinement::update(const Vector &q)
  {
    const ShellSpace &space = parts_.space();
    if (!active())
      return;
    const ShellJoining joining(parts_, limit_);
    for (unsigned int c = 0; c < elements_.size(); ++c)
    {
      bends_[c] = space.bend(q, c);
      were_bent_[c] = were_bent_[c] || joining.bends(bends_[c], length(c));
    }
    edge_lengths_.clear();
    for (const auto &[a, b, middle] : parts_.surface().contact_edges(Side::top))
      edge_lengths_.push_back(space.position(q, a).distance(space.position(q, b)));
  }


  std::vector<double> ShellRefinement::edge_lengths() const
  {
    std::vector<double> result = edge_lengths_;
    // Tools have to look at halves as well, to say whether these may be joined.
    constexpr double twice_and_with_room = 4.;
    if (joins_ && elements_.size() > first_.cells().size())
      for (std::size_t e = 0; e < result.size(); ++e)
        if (!elements_[e * elements_.size() / result.size()].whole())
          result[e] *= twice_and_with_room;
    return result;
  }


  double ShellRefinement::estimated_error() const
  {
    return std::numeric_limits<double>::quiet_NaN();
  }


  unsigned int ShellRefinement::n_cells() const
  {
    return elements_.size();
  }


  const std::vector<PointOrigin> &ShellRefinement::point_origins(const Side side) const
  {
    return point_origins_[static_cast<unsigned int>(side)];
  }


  bool ShellRefinement::is_refined(const KeyedArrays &state)
  {
    return state.has(key);
  }


  void ShellRefinement::put(KeyedArrays &state) const
  {
    std::vector<double> left;
    for (const auto &[part, bend] : left_)
      left.insert(left.end(), {static_cast<double>(part.cell), part.begin, part.end, bend});
    if (!left.empty())
      state.put(key_of_left, left);
    if (elements_.size() == first_.cells().size())
      return;
    std::vector<double> numbers;
    for (const auto &[cell, begin, end] : elements_)
      numbers.insert(numbers.end(), {static_cast<double>(cell), begin, end});
    state.put(key, numbers);
    state.put(key_of_bent, std::vector<double>(were_bent_.begin(), were_bent_.end()));
  }


  void ShellRefinement::take(const KeyedArrays &state)
  {
    const auto elements = is_refined(state) ? parts_of(state.at(key), first_.cells().size()) : whole(first_);
    const bool same = std::equal(elements.begin(), elements.end(), elements_.begin(), elements_.end());
    if (!same)
      set_mesh(elements);
    were_bent_.assign(elements_.size(), false);
    if (state.has(key_of_bent) && state.at(key_of_bent).size() == elements_.size())
      were_bent_.assign(state.at(key_of_bent).begin(), state.at(key_of_bent).end());
    left_.clear();
    if (!state.has(key_of_left))
      return;
    const std::vector<double> &numbers = state.at(key_of_left);
    for (std::size_t i = 0; i + 4 <= numbers.size() && numbers[i] >= 0. && numbers[i] < first_.cells().size(); i += 4)
      left_.push_back({{static_cast<unsigned int>(numbers[i]), numbers[i + 1], numbers[i + 2]}, numbers[i + 3]});
  }
} // namespace deltaform
