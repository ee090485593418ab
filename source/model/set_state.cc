// The committed state of a model as a value, and going to one.
#include <deltaform/base/byte_stream.h>
#include <deltaform/base/scene_error.h>
#include <deltaform/model/model.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <sstream>

namespace deltaform
{
  ModelState Model::state() const
  {
    ModelState result = state_;
    result.body = actors_.blank->state();
    for (const auto &interface : actors_.interfaces)
    {
      ByteStream bytes;
      {
        boost::archive::binary_oarchive archive(bytes.stream());
        archive << static_cast<const ContactInterface &>(*interface);
      }
      result.interfaces.push_back(bytes.take());
    }
    return result;
  }


  void Model::set_state(const ModelState &state, const Stage &stage)
  {
    const std::size_t n_before = state_.unknowns.size();
    const auto refuse = [&]() {
      throw SceneError("Cannot resume: the saved state has " + std::to_string(state.unknowns.size()) +
                       " unknowns, the scene has " + std::to_string(state_.unknowns.size()) + ".");
    };
    const std::size_t n = state.unknowns.size(), n_tools = actors_.tools.size();
    for (const Vector *const forces : {&state.hold, &state.load_forces, &state.reactions})
      if (forces->size() != n)
        refuse();
    if (state.tool_forces.size() != n_tools || state.travels.size() != n_tools ||
        state.load_resultants.size() != actors_.loads.size())
      refuse();
    // Before anything changes, as far as it can be known.
    if (state.interfaces.size() != actors_.interfaces.size() ||
        (actors_.blank->refinement() == nullptr && state.unknowns.size() != n_before))
      refuse();
    actors_.blank->set_state(state.body);
    if (state.unknowns.size() != n_before)
    {
      for (auto &interface : actors_.interfaces)
        interface->resize();
      renumber();
    }
    if (state.unknowns.size() != state_.unknowns.size())
      refuse();
    state_ = state;
    state_.body = KeyedArrays();
    state_.interfaces.clear();
    for (std::size_t i = 0; i < actors_.interfaces.size(); ++i)
    {
      std::istringstream bytes(state.interfaces[i]);
      boost::archive::binary_iarchive archive(bytes);
      archive >> *actors_.interfaces[i];
    }
    enter_stage(stage);
    discard(state_.time);
  }
} // namespace deltaform
