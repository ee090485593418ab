#include <deltaform/stage/contact_solve.h>

#include <boost/functional/hash.hpp>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    constexpr unsigned int depth_of_augmentation = 8; ///< rounds that the acceleration looks back to
  }


  ContactSolve::ContactSolve(const Actors &actors, const ContactSet &contact)
    : actors_(actors), contact_(contact), augmentation_(depth_of_augmentation)
  {
  }


  void ContactSolve::begin_increment(const Vector &committed, const double time)
  {
    for (auto *interface : contact_.interfaces())
      interface->begin_increment(committed, time);
    augmentation_.restart();
    factors_due_ = !contact_.empty();
    cycling_ = false;
    visited_.clear();
  }


  bool ContactSolve::soften()
  {
    for (auto *interface : contact_.interfaces())
      interface->soften(actors_.contact->normal_law->soft_share());
    return !contact_.empty();
  }


  void ContactSolve::read_body(const Vector &q, const System &body, const bool tangent)
  {
    if (!actors_.contact || !(factors_due_ || (actors_.contact->rule->in_every_iteration() && tangent)))
      return;
    if (factors_due_)
      for (auto *interface : contact_.interfaces())
        interface->read_stiffness(q, body);
    Vector coupling;
    if (actors_.contact->normal_law->uses_penalty() && actors_.contact->rule->needs_coupling())
    {
      Vector mismatch(q.size());
      coupling.reinit(q.size());
      for (const auto *interface : contact_.interfaces())
        interface->add_mismatch(q, mismatch);
      body.multiply(mismatch, coupling);
    }
    for (auto *interface : contact_.interfaces())
      interface->predict_factors(q, coupling.size() > 0 ? &coupling : nullptr);
    factors_due_ = false;
  }


  void ContactSolve::remember_set()
  {
    if (!changed())
      return;
    const std::size_t set = signature();
    cycling_ |= std::find(visited_.begin(), visited_.end(), set) != visited_.end();
    visited_.push_back(set);
  }


  unsigned int ContactSolve::correct_early()
  {
    // The digits of an iterate are those of the linear solver, and of the number of processes: so would be the factors.
    if (actors_.blank->may_be_distributed())
      return 0;
    unsigned int changed = 0;
    for (auto *interface : contact_.interfaces())
      changed += interface->correct_factors_early();
    return changed;
  }


  unsigned int ContactSolve::correct(const Vector &q)
  {
    cycling_ = false;
    visited_.clear();
    unsigned int changed = 0;
    for (auto *interface : contact_.interfaces())
      changed += interface->correct_factors(q);
    if (actors_.contact && actors_.contact->normal_law->augmentation_tolerance() > 0)
      changed += augmentation_.update(contact_.interfaces());
    return changed;
  }


  bool ContactSolve::foresee(const Vector &q, const Vector &d)
  {
    unsigned int n_others = 0;
    for (auto *interface : contact_.interfaces())
      n_others += interface->foresee(q, d);
    return n_others > 0;
  }


  void ContactSolve::peel(const unsigned int reach)
  {
    for (auto *interface : contact_.interfaces())
      interface->peel(reach);
  }


  std::size_t ContactSolve::signature() const
  {
    std::size_t result = 0;
    for (const auto *interface : contact_.interfaces())
      boost::hash_combine(result, interface->signature());
    return result;
  }


  void ContactSolve::prepare_step(const Vector &d)
  {
    for (auto *interface : contact_.interfaces())
      interface->prepare_step(d);
  }


  void ContactSolve::advance(const double factor)
  {
    for (auto *interface : contact_.interfaces())
      interface->advance(factor);
  }


  bool ContactSolve::changed() const
  {
    return std::any_of(contact_.interfaces().begin(), contact_.interfaces().end(),
                       [](const ContactInterface *interface) { return interface->status_changed(); });
  }


  unsigned int ContactSolve::patience() const
  {
    // The same set for the second time: the iteration goes round in circles.
    if (cycling_)
      return 0;
    // Penalty springs need the line search, most of all on fine meshes; exact constraints are best left alone.
    return actors_.contact && actors_.contact->normal_law->has_multiplier() ? 1000 : 2;
  }


  bool ContactSolve::consistent(const double allowed_tension) const
  {
    return std::all_of(contact_.interfaces().begin(), contact_.interfaces().end(),
                       [&](const ContactInterface *interface) { return interface->consistent(allowed_tension); });
  }


  void ContactSolve::keep()
  {
    for (auto *interface : contact_.interfaces())
      interface->keep();
  }


  void ContactSolve::go_back()
  {
    for (auto *interface : contact_.interfaces())
      interface->go_back();
    cycling_ = false;
    visited_.clear();
  }
} // namespace deltaform
