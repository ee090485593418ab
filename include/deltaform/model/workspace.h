#pragma once

#include <deltaform/model/model.h>
#include <deltaform/solver/system.h>
#include <deltaform/stage/contact_solve.h>
#include <deltaform/stage/face_pressure.h>

#include <functional>
#include <utility>

namespace deltaform
{
  /**
   * What is computed on the way from one state of a model to the next and then forgotten: matrix and factors, the
   * prescribed values, what contact remembers of a solve. A model may have several, but the trial states of blank and
   * contact points exist once: whoever goes over to another workspace begins there anew.
   */
  class Workspace
  {
  public:
    explicit Workspace(const Model &model);

    /// Look for the state at @p time; what was tried before is discarded.
    void begin(double time);

    /// If the blank has got another mesh: an empty system for it, in the same object, to which Newton's method keeps.
    void follow_mesh();

    /// Of the state that is looked for.
    double time() const
    {
      return time_;
    }

    /// Of the last assembly.
    System &system()
    {
      return system_;
    }

    const System &system() const
    {
      return system_;
    }

    /// On all meshes of this run.
    unsigned int n_factorizations() const
    {
      return n_earlier_factorizations_ + system_.n_factorizations();
    }

    ContactSolve &contact()
    {
      return contact_;
    }

    FacePressure &pressure()
    {
      return pressure_;
    }

    /// Values of the prescribed unknowns at the end of the increment; of others the committed ones.
    const Vector &prescribed() const
    {
      return prescribed_;
    }

    /// Call @p action in every assembly of a tangent that holds all terms but those of contact; empty: no more.
    void before_contact(std::function<void(const System &)> action)
    {
      before_contact_ = std::move(action);
    }

    /// There is that tangent.
    void tell_before_contact() const
    {
      if (before_contact_)
        before_contact_(system_);
    }

  private:
    const Model &model_;
    System system_;
    unsigned int mesh_; ///< for which the system is made, by its number
    unsigned int n_earlier_factorizations_ = 0; ///< of the systems before
    ContactSolve contact_;
    FacePressure pressure_;
    Vector prescribed_;
    double time_ = 0.;
    std::function<void(const System &)> before_contact_; ///< mostly empty
  };
} // namespace deltaform
