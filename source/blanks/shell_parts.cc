#include "shell_parts.h"

#include <utility>

namespace deltaform
{
  KeyedArrays ShellParts::state_of_metal() const
  {
    KeyedArrays state;
    material_.put(state);
    ShellState::each_array(state_, PutInto(state));
    ElasticCore::each_array(core_, PutInto(state));
    return state;
  }


  KeyedArrays ShellParts::whole_state() const
  {
    KeyedArrays state = state_of_metal();
    ShellSurface::each_array(surface_, PutInto(state));
    return state;
  }


  void ShellParts::set_state(const KeyedArrays &state)
  {
    material_.take(state);
    ShellState::each_array(state_, TakeFrom(state));
    ElasticCore::each_array(core_, TakeFrom(state));
    state_.renew();
    ShellSurface::each_array(surface_, TakeFrom(state));
    surface_.renew();
    for (unsigned int i = 0; i < material_.size(); ++i)
      material_.strain(i) = state_.strain(i);
  }


  void ShellParts::set_mesh(ShellMesh mesh)
  {
    space_.set_mesh(std::move(mesh));
    points_.set_up();
    state_.set_up();
    material_.reset(static_cast<std::size_t>(points_.size()) * points_.n_layers());
    surface_.set_up();
    core_.set_up();
  }


  Vector ShellParts::come_over(const ShellTransfer &transfer, const KeyedArrays &formed)
  {
    KeyedArrays own = state_of_metal();
    Vector q(space_.n_dofs());
    transfer.set_unknowns(formed, q);
    transfer.set_state(formed, q, own);
    ShellSurface::each_array(surface_, PutInto(own));
    set_state(own);
    surface_.update(q);
    return q;
  }
} // namespace deltaform
