#include <deltaform/model/model.h>

namespace deltaform
{
  Model::Model(Actors &actors, const LinearSolverSettings &linear_solver, Timers &timers)
    : actors_(actors), timers_(timers), body_(actors, contact_), stops_(actors), contact_(actors),
      discretization_(actors, linear_solver, all_terms()), supports_(actors, discretization_.numbering()),
      book_(actors, discretization_.numbering(), supports_, contact_), terms_(body_, contact_),
      formed_start_(actors, body_, supports_, discretization_.numbering(), state_)
  {
    clear_state();
    for (const auto &tool : actors_.tools)
      state_.travels.push_back(tool->travel(0.));
  }


  std::vector<const Term *> Model::all_terms() const
  {
    std::vector<const Term *> result{&body_, &contact_, &stops_};
    for (const auto &load : actors_.loads)
      result.push_back(load.get());
    return result;
  }


  void Model::clear_state()
  {
    const unsigned int n = discretization_.numbering().n();
    state_.unknowns.reinit(n);
    state_.hold.reinit(n);
    book_.clear(state_);
  }
} // namespace deltaform
