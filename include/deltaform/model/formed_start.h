#pragma once

#include <deltaform/blanks/blank.h>
#include <deltaform/model/force_book.h>
#include <deltaform/model/model_state.h>
#include <deltaform/model/numbering.h>
#include <deltaform/stage/stage.h>

#include <optional>
#include <string>

namespace deltaform
{
  /// Begins a run with a blank that an earlier operation has formed. Forces that held it fade out. On another mesh the
  /// error of the transfer is dropped, and equilibrium is found before the first increment.
  class FormedStart
  {
  public:
    FormedStart(const Actors &actors,
                Body &body,
                const SupportSet &supports,
                const Numbering &numbering,
                ModelState &state)
      : actors_(actors), body_(body), supports_(supports), numbering_(numbering), state_(state)
    {
    }

    /// The blank, whose unknowns are numbered, has come over.
    void begin(const TakenOver &taken);

    /// A stage begins; if it is the first since begin(), the forces that miss equilibrium become released ones.
    void enter(const Stage &stage, const ForceBook &book);

    /**
     * Of these forces keep those that held the blank on its earlier mesh; the rest is the error of the transfer. Then
     * find equilibrium at the same time, and end().
     * @return has anything been dropped?
     */
    bool drop_transfer_error();

    /// What is out of balance where these forces are not known: a sentence; empty if there is nothing to tell.
    std::string left_over() const;

    /// There is equilibrium without what was dropped, and it is accepted; if not, @p why, and all of it fades out.
    /// @return what has happened, a sentence
    std::string end(const std::string &why);

  private:
    /// What the blank stores counts as put in by the earlier operation; what that dissipated does not count.
    void begin_accounts();

    /// Of forces on the blank, over its unknowns; moments over the length that is typical of them.
    double norm(const Vector &forces) const;

    /// So much of the forces that hold the blank fades out.
    void fade(const Vector &forces);

    const Actors &actors_;
    Body &body_;
    const SupportSet &supports_;
    const Numbering &numbering_;
    ModelState &state_;
    bool due_ = false;
    std::optional<Vector> held_; ///< see TakenOver
    Vector missing_; ///< to equilibrium, at the begin of the first stage
    double in_cells_ = 0.; ///< norm of the forces in the cells, without regard to their signs
    double share_ = 0.; ///< of these that was dropped, or is out of balance
  };
} // namespace deltaform
