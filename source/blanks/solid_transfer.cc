#include "solid_transfer.h"

#include <deltaform/kinematics/logarithmic_strain.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/text.h>
#include <deltaform/process/ranks.h>

#include <deal.II/distributed/cell_data_transfer.templates.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/numerics/cell_data_transfer.templates.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    using CellData = SolidTransfer::CellData;

    /// Numbers of a point after its history: ln C_p^-1 / 2, elastic strain, volume offset.
    constexpr std::size_t n_tensors = 9;

    /// A place of the unit cell of a child in its parent's.
    Point2 in_parent(const Point2 &xi, const unsigned int child)
    {
      const unsigned int right = child % 2, upper = child / 2;
      return {.5 * (xi[0] + right), .5 * (xi[1] + upper)};
    }
  } // namespace


  CellData SolidTransfer::pack(const unsigned int cell, const std::vector<Vector> &fields) const
  {
    const SolidSpace &space = body_.space();
    const unsigned int per_cell = body_.points().per_cell();
    CellData data;
    for (unsigned int a = 0; a < space.n_nodes_per_cell(); ++a)
      for (unsigned int k = 0; k < 2; ++k)
        data.push_back(space.nodes()[space.cells()[cell][a]][k]);
    for (const auto &field : fields)
      for (unsigned int a = 0; a < space.n_nodes_per_cell(); ++a)
        for (const auto dof : space.dofs()[space.cells()[cell][a]])
          data.push_back(field[dof]);
    for (unsigned int i = cell * per_cell; i < (cell + 1) * per_cell; ++i)
    {
      const double *const history = material_.history(i);
      data.insert(data.end(), history, history + material_.law().history_size());
      const auto &cp = motion_.plastic_metric(i);
      const Mandel metric = LogarithmicStrain::strain({cp[0], cp[1], cp[2], cp[3]});
      data.insert(data.end(), metric.begin(), metric.end());
      const Mandel elastic = material_.law().elastic_strain(material_.committed_stress(i));
      data.insert(data.end(), elastic.begin(), elastic.end());
      data.push_back(motion_.volume_offset(i));
      for (unsigned int k = 0; k < material_.criteria().n_fields(); ++k)
        data.push_back(material_.criteria().value(i, k));
    }
    return data;
  }


  std::vector<CellData> SolidTransfer::pack_all(const std::vector<Vector> &fields) const
  {
    const SolidSpace &space = body_.space();
    std::vector<Vector> all_nodes;
    for (const auto &field : fields)
    {
      Vector storage;
      all_nodes.push_back(space.hanging().with_hanging(field, storage));
    }
    std::vector<CellData> own;
    for (unsigned int c = 0; c < space.cells().size(); ++c)
      own.push_back(pack(c, all_nodes));
    return own;
  }


  void SolidTransfer::divide_cells(const std::vector<Vector> &fields)
  {
    const std::vector<CellData> own = pack_all(fields);
    const CellCut cutter(body_.space().degree(), n_state(), material_.law());
    using Cell = dealii::Triangulation<2>::cell_iterator;
    auto &triangulation = body_.space().triangulation();
    const auto divide = [&](const Cell &, const CellData &parent) {
      std::vector<CellData> children;
      for (unsigned int child = 0; child < 4; ++child)
        children.push_back(child_of(cutter, parent, child));
      return children;
    };
    // Nothing is coarsened.
    const auto unite = [](const Cell &, const std::vector<CellData> &children) { return children.front(); };

    if (ranks::count() == 1)
    {
      dealii::CellDataTransfer<2, 2, std::vector<CellData>> transfer(triangulation, divide, unite);
      transfer.prepare_for_coarsening_and_refinement();
      triangulation.execute_coarsening_and_refinement();
      cells_.resize(triangulation.n_active_cells());
      transfer.unpack(own, cells_);
      return;
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
    std::vector<CellData> all(triangulation.n_active_cells());
    transfer.unpack(all);
    cells_.clear();
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        cells_.push_back(std::move(all[cell->active_cell_index()]));
  }


  CellData SolidTransfer::child_of(const CellCut &cutter, const CellData &parent, const unsigned int child) const
  {
    // Displacements and places come over exactly: the parent's shape functions are among those of the children.
    const auto &unit_points = body_.points().unit_points();
    std::vector<CellPlace> nodes, points;
    for (const auto &xi : cutter.unit_nodes())
      nodes.push_back({&parent, in_parent(xi, child)});
    for (const auto &xi : unit_points)
      points.push_back({&parent, in_parent(xi, child)});
    return cutter.cut(nodes, points, .5 * unit_points.front()[0]);
  }


  CellData SolidTransfer::part_of(const CellSearch &old, const CellCut &cutter, const unsigned int cell) const
  {
    const SolidSpace &space = body_.space();
    const unsigned int per_cell = body_.points().per_cell();
    const auto find = [&](const Point2 &X) {
      double distance = 0.;
      const CellPlace place = old.find(X, distance);
      if (distance > .1 * space.mesh().thickness())
        throw SceneError("the blank is no part of the one that was formed: it has a point at R0 = " +
                         text::rounded(X[0]) + ", Z0 = " + text::rounded(X[1]) +
                         ". Its mesh is that of the undeformed blank, or of what is left of it by trimming");
      return place;
    };
    std::vector<CellPlace> nodes, points;
    for (unsigned int a = 0; a < space.n_nodes_per_cell(); ++a)
      nodes.push_back(find(space.nodes()[space.cells()[cell][a]]));
    for (unsigned int p = 0; p < per_cell; ++p)
      points.push_back(find(body_.points().place(cell * per_cell + p)));
    return cutter.cut(nodes, points, 0.);
  }


  void SolidTransfer::describe(const Vector &q, KeyedArrays &formed) const
  {
    std::vector<double> all;
    for (const CellData &cell : pack_all({q}))
      all.insert(all.end(), cell.begin(), cell.end());
    formed.put("cells", ranks::gather(all));
    formed.put("kind of cells", std::vector<double>{double(body_.space().degree()), double(n_state())});
  }


  bool SolidTransfer::same_kind(const KeyedArrays &formed) const
  {
    return formed.at("kind of cells") == std::vector<double>{double(body_.space().degree()), double(n_state())};
  }


  void SolidTransfer::cut_cells(const KeyedArrays &formed)
  {
    const auto &all = formed.at("cells"), &kind = formed.at("kind of cells");
    if (kind[1] != double(n_state()))
      throw SceneError("the points of the earlier operation knew other numbers: sections Material and Limits/Criteria "
                       "must be those of the earlier scene");
    const auto degree = static_cast<unsigned int>(kind[0]);
    // As many nodes as points; place and displacement have two components each.
    const std::size_t n = (degree + 1) * (degree + 1) * (4 + n_state());
    std::vector<CellData> cells;
    for (std::size_t first = 0; first < all.size(); first += n)
      cells.emplace_back(&all[first], &all[first] + n);
    const CellSearch old(degree, std::move(cells));
    const CellCut cutter(degree, n_state(), material_.law());
    cells_.clear();
    for (unsigned int c = 0; c < body_.space().cells().size(); ++c)
      cells_.push_back(part_of(old, cutter, c));
  }


  Vector SolidTransfer::unpack_field(const unsigned int field) const
  {
    const SolidSpace &space = body_.space();
    const std::size_t n = space.n_nodes_per_cell();
    const DofIndex n_unknowns = space.hanging().n_unknowns();
    Vector values(n_unknowns);
    for (unsigned int c = 0; c < space.cells().size(); ++c)
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int k = 0; k < 2; ++k)
          if (const DofIndex dof = space.dofs()[space.cells()[c][a]][k];
              dof < n_unknowns && space.hanging().owned().is_element(dof))
            values[dof] = cells_[c][2 * ((field + 1) * n + a) + k];
    ranks::sum(values.begin(), values.size());
    return values;
  }


  const double *SolidTransfer::state_of(const unsigned int point, const std::size_t n_fields) const
  {
    const unsigned int per_cell = body_.points().per_cell();
    return &cells_[point / per_cell][2 * (n_fields + 1) * body_.space().n_nodes_per_cell() +
                                     point % per_cell * n_state()];
  }


  std::size_t SolidTransfer::n_state() const
  {
    return material_.law().history_size() + n_tensors + material_.criteria().n_fields();
  }


  void SolidTransfer::unpack_points(const std::size_t n_fields)
  {
    const std::size_t n_history = material_.law().history_size();
    std::vector<double> history, criteria;
    for (unsigned int i = 0; i < body_.points().size(); ++i)
    {
      const double *state = state_of(i, n_fields);
      history.insert(history.end(), state, state + n_history);
      state += n_history;
      motion_.volume_offset(i) = state[8];
      const auto b = LogarithmicStrain::inverse({{state[0], state[1], state[2], state[3]}});
      motion_.set_plastic_metric(i, {{b.xx, b.yy, b.zz, b.xy}});
      // Polynomials may overshoot what only grows from zero.
      for (unsigned int k = 0; k < material_.criteria().n_fields(); ++k)
        criteria.push_back(std::max(0., state[n_tensors + k]));
    }
    material_.set_history(history);
    material_.criteria().set_values(std::move(criteria));
  }


  void SolidTransfer::take_over(std::vector<Vector> &fields)
  {
    kernel_.reset();
    for (unsigned int v = 0; v < fields.size(); ++v)
      fields[v] = unpack_field(v);
    unpack_points(fields.size());

    // Stresses of the law at the displacements as they came over, the scale of energies and the start of the next flow.
    const SolidPoints &points = body_.points();
    const Vector q = fields.empty() ? Vector(body_.space().hanging().n_unknowns()) : fields.front();
    kernel_.update_stress(q);
    if (const std::size_t n_history = material_.law().history_size(); n_history > 0 && !fields.empty())
    {
      std::vector<Mandel> elastic;
      for (unsigned int i = 0; i < points.size(); ++i)
      {
        const double *const state = state_of(i, fields.size()) + n_history + 4;
        elastic.push_back({{state[0], state[1], state[2], state[3]}});
      }
      keep_elastic_strain(elastic);
      kernel_.update_stress(q);
    }
    kernel_.discard_matrices();
    material_.keep_stress();
    motion_.keep();
    if (material_.account().counts())
    {
      double elastic = 0.;
      for (unsigned int i = 0; i < points.size(); ++i)
        elastic += points[i].weight * material_.law().elastic_energy(material_.stress(i));
      material_.account().add(ranks::sum(elastic), 0.);
    }
    cells_.clear();
  }


  void SolidTransfer::keep_elastic_strain(const std::vector<Mandel> &wanted)
  {
    // At displacements that did not change, children strain otherwise than their parent's points did: the less, the
    // less it was distorted. Where metal has flowed, that difference belongs to the flow and not to the elasticity,
    // whose strains are a thousand times smaller; where it has not, it is what the finer mesh knows better.
    const unsigned int per_cell = body_.points().per_cell();
    const auto share = [&](const double plastic, const double flow_stress) {
      return plastic / (flow_stress / material_.law().young_modulus() + plastic);
    };
    for (unsigned int c = 0; c < body_.space().cells().size(); ++c)
    {
      double plastic = 0., flow_stress = 0.;
      for (unsigned int i = c * per_cell; i < (c + 1) * per_cell; ++i)
      {
        plastic += material_.equivalent_plastic_strain(i) / per_cell;
        flow_stress += material_.flow_stress(i) / per_cell;
      }
      const double volume_share = share(plastic, flow_stress);
      for (unsigned int i = c * per_cell; i < (c + 1) * per_cell; ++i)
      {
        // The law got the sum of the elastic strain and the plastic one of its history.
        Mandel trial = material_.strain(i);
        const Mandel old = material_.plastic_strain(i);
        for (unsigned int k = 0; k < 4; ++k)
          trial[k] -= old[k];
        const double mean = (trial[0] + trial[1] + trial[2]) / 3.;
        const double wanted_mean = (wanted[i][0] + wanted[i][1] + wanted[i][2]) / 3.;
        motion_.volume_offset(i) += 3. * volume_share * (mean - wanted_mean);
        // Small strains are as linear in the cell as what is interpolated.
        if (!motion_.finite())
          continue;
        const double own = share(material_.equivalent_plastic_strain(i), material_.flow_stress(i));
        Mandel kept;
        for (unsigned int k = 0; k < 4; ++k)
          kept[k] = (1. - own) * (trial[k] - (k < 3 ? mean : 0.)) + own * (wanted[i][k] - (k < 3 ? wanted_mean : 0.));
        motion_.flow_to(i, kept);
      }
    }
  }
} // namespace deltaform
