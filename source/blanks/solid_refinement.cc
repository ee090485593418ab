// Refining the solid during the run: which cells, and what follows from it (doc/theory/solid.md).
#include "solid.h"

#include <deltaform/base/ranks.h>

#include <deal.II/distributed/cell_data_transfer.templates.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/numerics/cell_data_transfer.templates.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

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
    auto &triangulation = space_.triangulation();
    estimated_error_ = std::numeric_limits<double>::quiet_NaN();
    const int highest_level = space_.mesh().first_level() + static_cast<int>(refinement_.levels);
    std::vector<bool> marked(space_.cells().size(), false);
    if (refinement_.by_error)
    {
      const ErrorEstimate estimate = estimate_error();
      estimated_error_ = estimate.relative;
      if (estimate.relative > refinement_.target)
      {
        const double threshold = error_threshold(estimate.squares);
        for (unsigned int c = 0; c < space_.cells().size(); ++c)
          marked[c] = estimate.squares[c] >= threshold;
      }
    }
    for (const unsigned int side : {0, 1})
      for (unsigned int e = 0; e < longest_edges[side].size(); ++e)
      {
        const auto &face = faces_[side];
        const auto [a, b] = face.ends(face.edges()[e]);
        const unsigned int own = boundary_.cell(a, b);
        if (own != invalid_index && space_.nodes()[a].distance(space_.nodes()[b]) > longest_edges[side][e])
          marked[own] = true;
      }
    unsigned int c = 0;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        marked[c] = marked[c] && cell->level() < highest_level;
        ++c;
      }
    return flag_divisible(marked);
  }


  bool Solid::divisible(const unsigned int cell) const
  {
    // What the law is evaluated at in the children, in the parent's unit cell.
    const dealii::FE_Q<2> shapes(space_.degree());
    for (unsigned int child = 0; child < 4; ++child)
      for (const auto &point : points_.unit_points())
      {
        const Point2 xi(.5 * (point[0] + child % 2), .5 * (point[1] + child / 2));
        Tensor2 jacobian;
        for (unsigned int a = 0; a < space_.n_nodes_per_cell(); ++a)
        {
          const Point2 &x = committed_places_[space_.cells()[cell][a]];
          const Tensor1 gradient = shapes.shape_grad(a, xi);
          for (unsigned int i = 0; i < 2; ++i)
            for (unsigned int j = 0; j < 2; ++j)
              jacobian[i][j] += x[i] * gradient[j];
        }
        if (!(dealii::determinant(jacobian) > 0.))
          return false;
      }
    return true;
  }


  bool Solid::flag_divisible(std::vector<bool> &marked)
  {
    auto &triangulation = space_.triangulation();
    for (unsigned int c = 0; c < space_.cells().size(); ++c)
      marked[c] = marked[c] && divisible(c);
    for (bool again = true; again;)
    {
      again = false;
      unsigned int c = 0;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && marked[c++])
          cell->set_refine_flag();
      triangulation.prepare_coarsening_and_refinement();
      if (ranks::count() > 1)
        break;
      // Cells that would have to follow a finer neighbour, and cannot, keep it as it is.
      std::vector<int> level(triangulation.n_vertices(), std::numeric_limits<int>::max());
      for (bool spreads = true; spreads;)
      {
        spreads = false;
        c = 0;
        for (const auto &cell : triangulation.active_cell_iterators())
        {
          if (cell->refine_flag_set())
          {
            int limit = std::numeric_limits<int>::max();
            for (const auto v : cell->vertex_indices())
              limit = std::min(limit, level[cell->vertex_index(v)]);
            if (cell->level() > limit || !divisible(c))
            {
              for (const auto v : cell->vertex_indices())
                level[cell->vertex_index(v)] = std::min(level[cell->vertex_index(v)], cell->level());
              marked[c] = false;
              cell->clear_refine_flag();
              again = spreads = true;
            }
          }
          ++c;
        }
      }
      if (again)
        for (const auto &cell : triangulation.active_cell_iterators())
          cell->clear_refine_flag();
    }
    return ranks::max(std::count(marked.begin(), marked.end(), true) > 0 ? 1. : 0.) > 0.;
  }


  double Solid::error_threshold(const std::vector<double> &squares) const
  {
    // The largest that together hold the share. All processes sort the same numbers, so that a mesh does not depend on
    // how many they are (the bisection of deal.II's distributed marking would).
    auto all = ranks::gather(squares);
    const double total = std::accumulate(all.begin(), all.end(), 0.);
    std::sort(all.begin(), all.end(), std::greater<>());
    double sum = 0.;
    for (const double square : all)
      if ((sum += square) >= refinement_.share * total)
        return square;
    return all.empty() ? 0. : all.back();
  }


  void Solid::refine(std::vector<Vector> &fields)
  {
    auto &triangulation = space_.triangulation();
    passes_.emplace_back();
    triangulation.save_refine_flags(passes_.back());
    const std::array<std::vector<Point2>, 2> old_places{{faces_[0].places(), faces_[1].places()}};
    for (auto &field : fields)
    {
      Vector storage;
      field = Vector(space_.hanging().with_hanging(field, storage));
    }

    std::vector<CellData> old;
    for (unsigned int c = 0; c < space_.cells().size(); ++c)
      old.push_back(pack(c, fields));
    const std::vector<CellData> data = divide_cells(old);

    space_.set_up([&](const unsigned int cell, const std::size_t a) {
      return Point2(data[cell][2 * a], data[cell][2 * a + 1]);
    });
    points_.set_up();
    set_up_state();
    boundary_.set_up();
    for (unsigned int side = 0; side < 2; ++side)
    {
      faces_[side].set_up(boundary_, contact_boundaries_[side]);
      heritage_[side] = faces_[side].parents(old_places[side]);
      faces_[side].set_up_areas(shortest_edge_);
    }
    unpack(data, fields);
  }


  std::vector<std::vector<double>> Solid::divide_cells(const std::vector<std::vector<double>> &own)
  {
    using Cell = dealii::Triangulation<2>::cell_iterator;
    auto &triangulation = space_.triangulation();
    const auto divide = [this](const Cell &, const CellData &parent) {
      std::vector<CellData> children;
      for (unsigned int child = 0; child < 4; ++child)
        children.push_back(inherit(parent, child));
      return children;
    };
    // Nothing is coarsened.
    const auto unite = [](const Cell &, const std::vector<CellData> &children) { return children.front(); };

    if (ranks::count() == 1)
    {
      dealii::CellDataTransfer<2, 2, std::vector<CellData>> transfer(triangulation, divide, unite);
      transfer.prepare_for_coarsening_and_refinement();
      triangulation.execute_coarsening_and_refinement();
      std::vector<CellData> result(triangulation.n_active_cells());
      transfer.unpack(own, result);
      return result;
    }

    // Cells move to other processes, so that each has equally many again.
    std::vector<CellData> old(triangulation.n_active_cells());
    unsigned int c = 0;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        old[cell->active_cell_index()] = own[c++];
    auto &distributed = dynamic_cast<dealii::parallel::distributed::Triangulation<2> &>(triangulation);
    dealii::parallel::distributed::CellDataTransfer<2, 2, std::vector<CellData>> transfer(
      distributed, false, divide, unite);
    transfer.prepare_for_coarsening_and_refinement(old);
    triangulation.execute_coarsening_and_refinement();
    std::vector<CellData> all(triangulation.n_active_cells()), result;
    transfer.unpack(all);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        result.push_back(std::move(all[cell->active_cell_index()]));
    return result;
  }


  const std::vector<std::array<unsigned int, 2>> &Solid::heritage(const Side side) const
  {
    return heritage_[static_cast<unsigned int>(side)];
  }
} // namespace deltaform
