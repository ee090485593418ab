#include <deltaform/analysis/state.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/deque.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

namespace deltaform
{
  namespace
  {
    template <typename Archive, typename Value>
    void archive_own(Archive &archive, Value &state, StepControl::State &step, bool &has_step)
    {
      archive &state.stage &state.n_increments &state.n_iterations &state.since_refinement &state.predictor
        &has_step &step.increment &step.quiet &step.shortened &step.error &step.failed &step.search &state.pace;
      archive &state.set_limit &state.conditions &state.ends &state.skipped;
    }
  } // namespace


  void State::save(std::ostream &stream) const
  {
    model.save(stream);
    boost::archive::binary_oarchive archive(stream);
    bool has_step = step.has_value();
    StepControl::State control = step.value_or(StepControl::State());
    archive_own(archive, *this, control, has_step);
  }


  void State::load(std::istream &stream)
  {
    model.load(stream);
    boost::archive::binary_iarchive archive(stream);
    bool has_step = false;
    StepControl::State control;
    archive_own(archive, *this, control, has_step);
    step = has_step ? std::make_optional(control) : std::nullopt;
  }
} // namespace deltaform
