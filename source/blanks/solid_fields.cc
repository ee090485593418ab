#include "solid_fields.h"
#include "solid_error.h"
#include "solid_folds.h"
#include "solid_picture.h"
#include "solid_profile.h"

#include <deltaform/process/ranks.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace deltaform
{
  namespace
  {
    /// Half way between bottom and top of a strip, from element to element.
    class MiddleLine
    {
    public:
      MiddleLine(const SolidDiscretization &body, const Vector &q)
      {
        const SolidSpace &space = body.space();
        const auto &columns = body.boundary().columns();
        for (unsigned int i = 0; i < columns.size(); i += space.degree())
        {
          const auto [bottom, top] = columns[i];
          const Point2 from = space.position(q, bottom);
          places_.push_back(from + .5 * (space.position(q, top) - from));
        }
      }

      unsigned int size() const
      {
        return places_.size();
      }

      const Point2 &operator[](const unsigned int i) const
      {
        return places_[i];
      }

      double length() const
      {
        double sum = 0.;
        for (unsigned int i = 1; i < places_.size(); ++i)
          sum += places_[i].distance(places_[i - 1]);
        return sum;
      }

      /// Between the elements before and behind a place (rad).
      double turn(const unsigned int i) const
      {
        const Tensor1 before = places_[i] - places_[i - 1], behind = places_[i + 1] - places_[i];
        return std::atan2(before[0] * behind[1] - before[1] * behind[0], before * behind);
      }

    private:
      std::vector<Point2> places_;
    };


    /// Is it a sheet, by its undeformed middle line?
    bool is_slender(const MiddleLine &undeformed, const double thickness)
    {
      constexpr double thicknesses = 10.;
      return undeformed.length() >= thicknesses * thickness;
    }
  } // namespace


  Table SolidFields::profile(const Vector &state) const
  {
    Vector storage;
    return SolidProfile(body_, surface_, material_, body_.space().hanging().with_hanging(state, storage)).table();
  }


  Drawing SolidFields::draw(const Vector &state, const std::vector<DrawnField> &nodal) const
  {
    const SolidSpace &space = body_.space();
    Vector storage;
    const Vector &q = space.hanging().with_hanging(state, storage);
    Drawing drawing;
    for (unsigned int i = 0; i < space.nodes().size(); ++i)
      drawing.points.push_back(space.position(q, i));
    drawing.fields.push_back({"displacement", "length", true, 2, {}});
    for (const auto &dofs : space.dofs())
    {
      drawing.fields.back().values.push_back(q[dofs[0]]);
      drawing.fields.back().values.push_back(q[dofs[1]]);
    }
    drawing.fields.insert(drawing.fields.end(), nodal.begin(), nodal.end());
    SolidPicture(body_, material_, motion_, drawing).draw_cells(q);
    drawing.cells = ranks::gather(drawing.cells);
    for (auto &field : drawing.fields)
      if (!field.per_point)
        field.values = ranks::gather(field.values);
    return drawing;
  }


  std::vector<LargestCriterion> SolidFields::largest_criteria() const
  {
    const PointCriteria &criteria = material_.criteria();
    std::vector<LargestCriterion> result;
    for (unsigned int k = 0; k < criteria.n_fields(); ++k)
    {
      // Value and place; of equal values that of the least place, so that the number of processes does not matter.
      const auto precedes = [](const double *a, const double *b) {
        return a[0] != b[0] ? a[0] > b[0] : std::lexicographical_compare(a + 1, a + 3, b + 1, b + 3);
      };
      std::vector<double> own{-1., 0., 0.}; // of a process without cells
      for (unsigned int i = 0; i < material_.size(); ++i)
      {
        const Point2 place = body_.points().place(i);
        const std::array<double, 3> here{{criteria.value(i, k), place[0], place[1]}};
        if (precedes(here.data(), own.data()))
          own.assign(here.begin(), here.end());
      }
      const auto all = ranks::gather(own);
      std::size_t best = 0;
      for (std::size_t i = 0; i < all.size(); i += own.size())
        if (precedes(&all[i], &all[best]))
          best = i;
      result.push_back({criteria.names()[k], criteria.column(k), criteria.field(k).unit(), all[best],
                        Point2(all[best + 1], all[best + 2])});
    }
    return result;
  }


  SharpestBend SolidFields::sharpest_bend(const Vector &q) const
  {
    const SolidSpace &space = body_.space();
    const Vector undeformed(q.size());
    const MiddleLine before(body_, undeformed), now(body_, q);
    SharpestBend result;
    if (!is_slender(before, space.mesh().thickness()))
      return result;
    for (unsigned int i = 1; i + 1 < now.size(); ++i)
    {
      double angle = std::abs(now.turn(i) - before.turn(i));
      angle = std::min(angle, 2. * dealii::numbers::PI - angle);
      if (angle > result.angle)
        result = {angle, before[i][0]};
    }
    return result;
  }


  InnermostPlace SolidFields::innermost_place(const Vector &q) const
  {
    InnermostPlace result;
    const auto &nodes = body_.space().nodes();
    const std::vector<Point2> now = body_.space().positions(q);
    for (unsigned int i = 0; i < nodes.size(); ++i)
      if (nodes[i][0] > 0. && now[i][0] < result.r)
        result = {now[i][0], i, nodes[i][0]};
    return result;
  }


  FoldedCells SolidFields::folded_cells(const Vector &state) const
  {
    Vector storage;
    return find_folded_cells(body_.space(), body_.space().hanging().with_hanging(state, storage));
  }


  MeshError SolidFields::mesh_error(const Vector &q) const
  {
    const bool unknown = ranks::max(flow_.size() == material_.size() ? 0. : 1.) > 0.;
    if (unknown || is_slender(MiddleLine(body_, Vector(q.size())), body_.space().mesh().thickness()))
      return {};
    return error_of_flow(body_, material_, flow_);
  }


  double SolidFields::smallest_thickness() const
  {
    return surface_.smallest_thickness();
  }
} // namespace deltaform
