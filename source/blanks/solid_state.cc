// The state of a solid.
#include "solid.h"

#include <deltaform/base/ranks.h>

namespace deltaform
{
  namespace
  {
    std::string pass_name(const std::size_t pass)
    {
      return "refined cells, pass " + std::to_string(pass + 1);
    }
  } // namespace


  KeyedArrays Solid::state() const
  {
    KeyedArrays state;
    for (std::size_t pass = 0; pass < passes_.size(); ++pass)
      state.put(pass_name(pass), std::vector<double>(passes_[pass].begin(), passes_[pass].end()));
    state.put("estimated error", estimated_error_);
    material_.put(state);
    state.put("area of nodes, bottom", faces_[0].areas());
    state.put("area of nodes, top", faces_[1].areas());
    state.put("smallest thickness", smallest_thickness_);
    state.put("rotation of the last increment", spin_);
    state.put("deformation", committed_deformation_);
    state.put("plastic metric", plastic_metric_);
    state.put("volumetric strain without stress", volume_offset_);
    state.put("places of nodes", committed_places_);
    return state;
  }


  void Solid::set_state(const KeyedArrays &state)
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
      if (cells.size() != space_.triangulation().n_active_cells())
        throw SceneError("The saved state has another number of cells: it is damaged. Start again.");
      space_.triangulation().load_refine_flags(cells);
      refine(none);
    }
    state.take("estimated error", estimated_error_);
    material_.take(state);
    state.take("area of nodes, bottom", faces_[0].areas());
    state.take("area of nodes, top", faces_[1].areas());
    state.take("smallest thickness", smallest_thickness_);
    state.take("rotation of the last increment", spin_);
    state.take("deformation", committed_deformation_);
    state.take("plastic metric", plastic_metric_);
    state.take("volumetric strain without stress", volume_offset_);
    state.take("places of nodes", committed_places_);
    deformation_ = committed_deformation_;
  }
} // namespace deltaform
