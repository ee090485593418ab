#include <deltaform/model/workspace.h>

namespace deltaform
{
  Workspace::Workspace(const Model &model)
    : model_(model), system_(model.discretization().make_system()), mesh_(model.discretization().n_meshes()),
      contact_(model.actors(), model.contact_set()),
      pressure_(model.actors(), model.contact_set(), model.committed_state().released)
  {
  }


  void Workspace::begin(const double time)
  {
    time_ = time;
    prescribed_ = model_.supports().prescribed(model_.committed_state(), time);
    contact_.begin_increment(model_.committed(), time);
    pressure_.begin_increment(model_.committed(), time);
    follow_mesh();
    system_.discard_factors();
  }


  void Workspace::follow_mesh()
  {
    const Discretization &discretization = model_.discretization();
    if (mesh_ == discretization.n_meshes())
      return;
    n_earlier_factorizations_ += system_.n_factorizations();
    system_ = discretization.make_system();
    mesh_ = discretization.n_meshes();
  }
} // namespace deltaform
