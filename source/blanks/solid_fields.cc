#include "solid_fields.h"
#include "solid_picture.h"
#include "solid_profile.h"

#include <deltaform/process/ranks.h>

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


  double SolidFields::smallest_thickness() const
  {
    return surface_.smallest_thickness();
  }
} // namespace deltaform
