// A force or moment on an edge, on its initial length (solid: area), in a direction that stays.
#include "nodal_forces.h"

#include <deltaform/loads/boundary_entries.h>
#include <deltaform/parameters/section.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    class EdgeLoad : public Load
    {
    public:
      EdgeLoad(Section &section, const Blank &blank)
        : Load(section,
               blank,
               {"force/length of the initial edge, moment/length (solid: stress)",
                "Line load (solid: traction on the initial area) as a function of time t.", "displacement"}),
          boundary_(blank.boundary()), part_(read_boundary(section, boundary_)), component_(read_component(section))
      {
        EdgeLoad::renumber();
        check_dofs(section, part_, dofs_);
        if (!section.documentation() && !(*std::max_element(weights_.begin(), weights_.end()) > 0))
          section.fail("Boundary", "this edge has no length (it lies on the axis): a line load on it is no load");
      }

      void add(const Vector &, const double value, AssemblyTarget &target) const override
      {
        add_nodal_forces(dofs_, weights_, value, target);
      }

      void renumber() override
      {
        dofs_ = boundary_.dofs(part_, component_);
        weights_ = boundary_.weights(part_);
      }

    private:
      const Boundary &boundary_;
      std::string part_;
      Component component_;
      std::vector<DofIndex> dofs_;
      std::vector<double> weights_; ///< what a unit load is to each unknown
    };

    const LoadRegistry::Entry entry("edge", "force or moment on an edge", make_as<EdgeLoad, Load>);
  } // namespace
} // namespace deltaform
