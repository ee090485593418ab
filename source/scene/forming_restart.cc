// The committed state of a problem on a stream, and going on from it.
#include <deltaform/base/scene_error.h>
#include <deltaform/scene/forming_problem.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

namespace deltaform
{
  void FormingProblem::save(std::ostream &stream) const
  {
    actors_.blank->save(stream);
    boost::archive::binary_oarchive archive(stream);
    archive << committed_ << hold_ << released_ << load_forces_ << reactions_ << load_resultants_ << time_
            << tool_forces_ << travels_ << work_.tools << work_.loads << largest_force_ << largest_resultant_
            << at_once_;
    for (const auto &pair : actors_.pairs)
      archive << static_cast<const ContactInterface &>(*pair);
  }


  void FormingProblem::load(std::istream &stream)
  {
    actors_.blank->load(stream);
    if (actors_.blank->refinement() != nullptr)
    {
      for (auto &pair : actors_.pairs)
        pair->resize();
      renumber();
    }
    const auto n_unknowns = committed_.size();
    {
      boost::archive::binary_iarchive archive(stream);
      archive >> committed_ >> hold_ >> released_ >> load_forces_ >> reactions_ >> load_resultants_ >> time_ >>
        tool_forces_ >> travels_ >> work_.tools >> work_.loads >> largest_force_ >> largest_resultant_ >> at_once_;
      if (committed_.size() != n_unknowns || travels_.size() != actors_.tools.size())
        throw SceneError("Cannot resume: the saved state has " + std::to_string(committed_.size()) +
                         " unknowns, the scene has " + std::to_string(n_unknowns) + ".");
      for (auto &pair : actors_.pairs)
        archive >> *pair;
    }
    for (unsigned int i = 0; i < actors_.tools.size(); ++i)
      if (actors_.tools[i]->force_driven())
        actors_.tools[i]->set_travel(travels_[i]);
  }


  void FormingProblem::resume_stage(const Stage &stage)
  {
    enter_stage(stage);
  }
} // namespace deltaform
