#include <deltaform/io/archive.h>
#include <deltaform/io/byte_stream.h>
#include <deltaform/model/model_state.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/process/ranks.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <sstream>

namespace deltaform
{
  namespace
  {
    /// All but the body.
    template <typename Archive, typename State>
    void archive_common(Archive &archive, State &state)
    {
      archive &state.time &state.stage &state.unknowns &state.hold &state.released &state.releases_at_once;
      archive &state.tool_forces &state.travels &state.load_resultants &state.load_forces &state.reactions;
      archive &state.load_histories;
      archive &state.work.tools &state.work.loads &state.work.dissipated_before;
      archive &state.largest_force &state.largest_resultant &state.interfaces;
    }
  } // namespace


  void ModelState::save(std::ostream &stream) const
  {
    // The cells of every process are its own.
    ByteStream own;
    {
      boost::archive::binary_oarchive archive(own.stream());
      archive << body;
    }
    const std::vector<std::string> bodies = ranks::gather(own.take());
    boost::archive::binary_oarchive archive(stream);
    archive << bodies;
    archive_common(archive, *this);
  }


  void ModelState::load(std::istream &stream)
  {
    boost::archive::binary_iarchive archive(stream);
    std::vector<std::string> bodies;
    archive >> bodies;
    if (bodies.size() != ranks::count())
      throw SceneError("Cannot resume: the run was saved by " + std::to_string(bodies.size()) +
                       " processes and goes on with as many only (mpirun -np " + std::to_string(bodies.size()) +
                       "); these are " + std::to_string(ranks::count()) + ".");
    std::istringstream own(bodies[ranks::mine()]);
    boost::archive::binary_iarchive(own) >> body;
    archive_common(archive, *this);
  }
} // namespace deltaform
