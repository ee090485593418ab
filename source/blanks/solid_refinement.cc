#include "solid_refinement.h"
#include "solid_error.h"

#include <deltaform/process/ranks.h>

#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <functional>
#include <numeric>

namespace deltaform
{
  namespace
  {
    std::string pass_name(const std::size_t pass)
    {
      return "refined cells, pass " + std::to_string(pass + 1);
    }
  } // namespace


  bool SolidRefinement::mark(const std::array<std::vector<double>, 2> &longest_edges)
  {
    const SolidSpace &space = body_.space();
    std::vector<bool> marked = marked_by_error();
    for (const unsigned int side : {0, 1})
      for (unsigned int e = 0; e < longest_edges[side].size(); ++e)
      {
        const SolidFace &face = surface_.face(side);
        const auto [a, b] = face.ends(face.edges()[e]);
        const unsigned int own = body_.boundary().cell(a, b);
        if (own != invalid_index && space.nodes()[a].distance(space.nodes()[b]) > longest_edges[side][e])
          marked[own] = true;
      }
    const int highest_level = space.mesh().first_level() + static_cast<int>(settings_.levels);
    unsigned int c = 0;
    for (const auto &cell : body_.space().triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
      {
        marked[c] = marked[c] && cell->level() < highest_level;
        ++c;
      }
    return flag_divisible(marked);
  }


  std::vector<bool> SolidRefinement::marked_by_error()
  {
    std::vector<bool> marked(body_.space().cells().size(), false);
    estimated_error_ = std::numeric_limits<double>::quiet_NaN();
    if (!settings_.by_error)
      return marked;
    const ErrorEstimate estimate = estimate_error(body_, material_);
    estimated_error_ = estimate.relative;
    if (estimate.relative > settings_.target)
    {
      const double threshold = error_threshold(estimate.squares);
      for (unsigned int c = 0; c < marked.size(); ++c)
        marked[c] = estimate.squares[c] >= threshold;
    }
    return marked;
  }


  double SolidRefinement::error_threshold(const std::vector<double> &squares) const
  {
    // The largest that together hold the share. All processes sort the same numbers, so that a mesh does not depend on
    // how many they are (the bisection of deal.II's distributed marking would).
    auto all = ranks::gather(squares);
    const double total = std::accumulate(all.begin(), all.end(), 0.);
    std::sort(all.begin(), all.end(), std::greater<>());
    double sum = 0.;
    for (const double square : all)
      if ((sum += square) >= settings_.share * total)
        return square;
    return all.empty() ? 0. : all.back();
  }


  bool SolidRefinement::divisible(const unsigned int cell) const
  {
    // What the law is evaluated at in the children, in the parent's unit cell.
    const SolidSpace &space = body_.space();
    const dealii::FE_Q<2> shapes(space.degree());
    for (unsigned int child = 0; child < 4; ++child)
      for (const auto &point : body_.points().unit_points())
      {
        const unsigned int row = child / 2, column = child % 2;
        const Point2 xi(.5 * (point[0] + column), .5 * (point[1] + row));
        Tensor2 jacobian;
        for (unsigned int a = 0; a < space.n_nodes_per_cell(); ++a)
        {
          const Point2 &x = places_[space.cells()[cell][a]];
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


  bool SolidRefinement::flag_divisible(std::vector<bool> &marked)
  {
    auto &triangulation = body_.space().triangulation();
    for (unsigned int c = 0; c < marked.size(); ++c)
      marked[c] = marked[c] && divisible(c);
    for (bool again = true; again;)
    {
      unsigned int c = 0;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && marked[c++])
          cell->set_refine_flag();
      triangulation.prepare_coarsening_and_refinement();
      again = ranks::count() == 1 && withdraw_flags(marked);
      if (again)
        for (const auto &cell : triangulation.active_cell_iterators())
          cell->clear_refine_flag();
    }
    return ranks::max(std::count(marked.begin(), marked.end(), true) > 0 ? 1. : 0.) > 0.;
  }


  bool SolidRefinement::withdraw_flags(std::vector<bool> &marked)
  {
    auto &triangulation = body_.space().triangulation();
    bool any = false;
    std::vector<int> level(triangulation.n_vertices(), std::numeric_limits<int>::max());
    for (bool spreads = true; spreads;)
    {
      spreads = false;
      unsigned int c = 0;
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
            any = spreads = true;
          }
        }
        ++c;
      }
    }
    return any;
  }


  void SolidRefinement::refine(std::vector<Vector> &fields)
  {
    if (passes_.empty())
      first_places_ = body_.space().nodes();
    passes_.emplace_back();
    body_.space().triangulation().save_refine_flags(passes_.back());
    const std::array<FacePoints, 2> old_points{{surface_.points(Side::bottom), surface_.points(Side::top)}};
    transfer_.divide_cells(fields);
    body_.set_up([&](const unsigned int cell, const unsigned int node) { return transfer_.place(cell, node); });
    surface_.set_up();
    for (const unsigned int side : {0, 1})
      point_origins_[side] = deltaform::point_origins(old_points[side], surface_.points(static_cast<Side>(side)));
    transfer_.take_over(fields);
    const Vector q = fields.empty() ? Vector(surface_.n_contact_dofs()) : fields.front();
    surface_.update(q);
    update(q);
  }


  void SolidRefinement::update(const Vector &q)
  {
    if (settings_.active)
      places_ = body_.space().positions(q);
  }


  double SolidRefinement::estimated_error() const
  {
    return estimated_error_;
  }


  unsigned int SolidRefinement::n_cells() const
  {
    return body_.space().mesh().n_cells();
  }


  const std::vector<PointOrigin> &SolidRefinement::point_origins(const Side side) const
  {
    return point_origins_[static_cast<unsigned int>(side)];
  }


  bool SolidRefinement::has_passes(const KeyedArrays &state)
  {
    return state.has(pass_name(0));
  }


  void SolidRefinement::put(KeyedArrays &state) const
  {
    for (std::size_t pass = 0; pass < passes_.size(); ++pass)
      state.put(pass_name(pass), std::vector<double>(passes_[pass].begin(), passes_[pass].end()));
    state.put("estimated error", estimated_error_);
    state.put("places of nodes", places_);
  }


  void SolidRefinement::take(const KeyedArrays &state)
  {
    std::vector<Vector> none;
    for (std::size_t pass = 0; pass < passes_.size() || state.has(pass_name(pass)); ++pass)
    {
      const std::vector<double> *flags = state.has(pass_name(pass)) ? &state.at(pass_name(pass)) : nullptr;
      const std::vector<bool> cells =
        flags != nullptr ? std::vector<bool>(flags->begin(), flags->end()) : std::vector<bool>();
      if (pass < passes_.size() && cells != passes_[pass])
        throw SceneError("The blank has been refined since, or in another way: it cannot go back to this state.");
      if (pass < passes_.size())
        continue;
      if (cells.size() != 2 * body_.space().triangulation().n_active_cells()) // two flags a cell
        throw SceneError("The saved state has another number of cells: it is damaged. Start again.");
      body_.space().triangulation().load_refine_flags(cells);
      refine(none);
    }
    state.take("estimated error", estimated_error_);
    state.take("places of nodes", places_);
  }
} // namespace deltaform
