// Refining the solid during the run: which cells, and what follows from it (doc/theory/solid.md).
#include <deltaform/blanks/solid.h>

#include <deal.II/grid/grid_refinement.h>
#include <deal.II/numerics/cell_data_transfer.templates.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    /// All that a cell knows, see Solid::pack().
    using CellData = std::vector<double>;
  } // namespace


  const RefinementSettings *Solid::refinement() const
  {
    return refinement_.active ? &refinement_ : nullptr;
  }


  bool Solid::mark(const std::array<std::vector<double>, 2> &longest_edges)
  {
    auto &triangulation     = mesh_.triangulation();
    estimated_error_        = std::numeric_limits<double>::quiet_NaN();
    const int highest_level = mesh_.first_level() + static_cast<int>(refinement_.levels);
    if (refinement_.by_error)
    {
      const ErrorEstimate estimate = estimate_error();
      estimated_error_             = estimate.relative;
      if (estimate.relative > refinement_.target)
      {
        dealii::Vector<double> squares(estimate.squares.begin(), estimate.squares.end());
        dealii::GridRefinement::refine_and_coarsen_fixed_fraction(triangulation, squares, refinement_.share, 0.);
      }
    }
    std::vector<bool> too_long(cells_.size(), false);
    for (const unsigned int side : {0, 1})
      for (unsigned int e = 0; e < longest_edges[side].size(); ++e)
      {
        const auto &face = faces_[side];
        const Point2 &A = nodes_[face.nodes[face.edges[e][0]]], &B = nodes_[face.nodes[face.edges[e][1]]];
        if (A.distance(B) > longest_edges[side][e])
          too_long[edge_cells_.at(std::minmax(face.nodes[face.edges[e][0]], face.nodes[face.edges[e][1]]))] = true;
      }
    bool any = false;
    for (const auto &cell : triangulation.active_cell_iterators())
    {
      if (too_long[cell->active_cell_index()])
        cell->set_refine_flag();
      if (cell->level() >= highest_level)
        cell->clear_refine_flag();
      any |= cell->refine_flag_set();
    }
    triangulation.prepare_coarsening_and_refinement();
    return any;
  }


  void Solid::refine(std::vector<Vector> &fields)
  {
    auto &triangulation = mesh_.triangulation();
    passes_.emplace_back();
    triangulation.save_refine_flags(passes_.back());
    std::array<std::vector<Point2>, 2> old_places;
    for (const unsigned int side : {0, 1})
      for (const auto node : faces_[side].nodes)
        old_places[side].push_back(nodes_[node]);
    for (auto &field : fields)
    {
      Vector storage;
      field = Vector(with_hanging(field, storage));
    }

    std::vector<CellData> old(cells_.size());
    for (unsigned int c = 0; c < cells_.size(); ++c)
      old[c] = pack(c, fields);
    dealii::CellDataTransfer<2, 2, std::vector<CellData>> transfer(
      triangulation,
      [this](const dealii::Triangulation<2>::cell_iterator &, const CellData &parent)
      {
        std::vector<CellData> children;
        for (unsigned int child = 0; child < 4; ++child)
          children.push_back(inherit(parent, child));
        return children;
      },
      [](const dealii::Triangulation<2>::cell_iterator &, const std::vector<CellData> &children)
      { return children.front(); }); // nothing is coarsened
    transfer.prepare_for_coarsening_and_refinement();
    triangulation.execute_coarsening_and_refinement();
    std::vector<CellData> data(triangulation.n_active_cells());
    transfer.unpack(old, data);

    set_up_dofs([&](const unsigned int cell, const unsigned int a)
                { return Point2(data[cell][2 * a], data[cell][2 * a + 1]); });
    set_up_points();
    set_up_boundary();
    for (unsigned int side = 0; side < 2; ++side)
    {
      set_up_face(faces_[side], contact_boundaries_[side]);
      set_up_heritage(static_cast<Side>(side), old_places[side]);
    }
    set_up_weightless();
    unpack(data, fields);
  }


  void Solid::set_up_heritage(const Side side, const std::vector<Point2> &old_places)
  {
    // A new node lies half way between two neighbours of the old line of nodes, all others were there.
    auto &heritage = heritage_[static_cast<unsigned int>(side)];
    heritage.clear();
    for (const auto node : faces_[static_cast<unsigned int>(side)].nodes)
    {
      std::array<unsigned int, 2> best{{0, 0}};
      double nearest      = std::numeric_limits<double>::infinity();
      const auto consider = [&](const unsigned int a, const unsigned int b)
      {
        const double distance = nodes_[node].distance(old_places[a] + .5 * (old_places[b] - old_places[a]));
        if (distance < nearest)
        {
          nearest = distance;
          best    = {{a, b}};
        }
      };
      for (unsigned int i = 0; i < old_places.size(); ++i)
      {
        consider(i, i);
        if (i + 1 < old_places.size())
          consider(i, i + 1);
      }
      heritage.push_back(best);
    }
  }


  const std::vector<std::array<unsigned int, 2>> &Solid::heritage(const Side side) const
  {
    return heritage_[static_cast<unsigned int>(side)];
  }
} // namespace deltaform
