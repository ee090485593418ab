#pragma once

#include <deltaform/assembly/side.h>
#include <deltaform/stage/contact_set.h>
#include <deltaform/stage/released_forces.h>

namespace deltaform
{
  /**
   * What presses on the faces of the blank while an increment is solved: contact, and what is left of the pressure of
   * tools that have left with the last stage. It is the transverse stress of a shell, and no part of the tangent: an
   * increment begins with the pressure of the last one, which is corrected in equilibrium (doc/theory/shell.md).
   */
  class FacePressure
  {
  public:
    FacePressure(const Actors &actors, const ContactSet &contact, const ReleasedForces &released);

    /// An increment from the state @p committed to @p time begins; what was tried before is discarded.
    void begin_increment(const Vector &committed, double time);

    /// In equilibrium at @p q: if the pressure has changed by more than may be left to the next increment, give it to
    /// the blank. @return has it?
    bool correct(const Vector &q);

  private:
    /// Are the trial contact forces so close to the accepted ones that no pressure need be found?
    bool is_nearly_accepted() const;

    /// Contact points in the accepted or the trial state.
    using Points = const std::vector<ContactPointState> &(ContactInterface::*) () const;

    /// Of these points, with what is left of released ones.
    FaceValues at(const Vector &q, Points points) const;

    const Actors &actors_;
    const ContactSet &contact_;
    const ReleasedForces &released_;
    bool matters_;
    double time_ = 0.;
    unsigned int n_corrections_ = 0; ///< in this increment
  };
} // namespace deltaform
