// A force per initial volume, in a direction that stays.
#include "nodal_forces.h"

#include <deltaform/loads/boundary_entries.h>
#include <deltaform/parameters/section.h>

namespace deltaform
{
  namespace
  {
    class BodyLoad : public Load
    {
    public:
      BodyLoad(Section &section, const Blank &blank)
        : Load(section, blank,
               {"force/volume", "Force per initial volume as a function of time t.", "displacement"}),
          body_(blank.boundary()), component_(read_component(section))
      {
        BodyLoad::renumber();
        if (dofs_.empty())
          section.fail("Component", "a body load is a force, along r or z");
      }

      void add(const Vector &, const double value, AssemblyTarget &target) const override
      {
        add_nodal_forces(dofs_, weights_, value, target);
      }

      void renumber() override
      {
        dofs_.clear();
        weights_.clear();
        for (const auto &[dof, weight] : body_.volume_weights(component_))
        {
          dofs_.push_back(dof);
          weights_.push_back(weight);
        }
      }

    private:
      const Boundary &body_;
      Component component_;
      std::vector<DofIndex> dofs_;
      std::vector<double> weights_; ///< initial volume that belongs to each unknown
    };

    const LoadRegistry::Entry entry("body", "force per initial volume", make_as<BodyLoad, Load>);
  } // namespace
} // namespace deltaform
