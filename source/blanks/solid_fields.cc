#include "solid_fields.h"
#include "solid_folds.h"
#include "solid_picture.h"
#include "solid_profile.h"

#include <deltaform/process/ranks.h>

#include <algorithm>
#include <array>

namespace deltaform
{
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


  FoldedCells SolidFields::folded_cells(const Vector &state) const
  {
    Vector storage;
    return find_folded_cells(body_.space(), body_.space().hanging().with_hanging(state, storage));
  }


  double SolidFields::smallest_thickness() const
  {
    return surface_.smallest_thickness();
  }
} // namespace deltaform
