#pragma once

#include <deltaform/model/support_set.h>
#include <deltaform/solver/system.h>
#include <deltaform/stage/actors.h>
#include <deltaform/stage/body.h>
#include <deltaform/stage/contact_set.h>

#include <string>

namespace deltaform
{
  /// Forces of tools, loads and supports on the blank in accepted equilibria: resultants, reactions, the work that
  /// they have done, and their balance. All of it lies in the state.
  class ForceBook
  {
  public:
    ForceBook(const Actors &actors, const Numbering &numbering, const SupportSet &supports, const ContactSet &contact);

    /// No forces yet, of a state with the present unknowns.
    void clear(ModelState &state) const;

    /// The end of an increment is accepted: @p state, whose unknowns are still those at its start, has its time;
    /// @p system holds its residual.
    void accept(const Vector &q, const System &system, ModelState &state) const;

    /// Work that tools under a force would do in the increment that is about to be accepted if their force grew along
    /// all of their way, of those that had not touched: most of it they fall. At least 0.
    double work_of_landing(const Vector &q, const ModelState &state) const;

    /// The blank was refined: forces of the loads, of which the next increment takes the work; the supports do not move
    /// until then.
    void renew_loads(ModelState &state) const;

    /// What ends with the stage of @p state becomes forces that fade out; contact of tools that leave is discarded.
    /// Loads that act in the next stage for the first time begin.
    void release(const std::string &next_stage, ModelState &state) const;

    /// What loads remember, into a state and back.
    void save_histories(ModelState &state) const;
    void load_histories(const ModelState &state) const;

    /// The first stage begins with a blank that an earlier operation has formed: what would hold it in its shape fades
    /// out, but for what the supports of this stage hold.
    void release_formed(Body &body, const Stage &stage, ModelState &state) const;

    /// Resultant on the blank of what is left of the forces that held it in the operation before.
    Tensor1 earlier_force(const ModelState &state) const;

    /**
     * How far the forces on the blank are from balance: sum of the forces of tools, supports and loads as they are
     * reported over the largest of them, along z and, in plane strain, along x (the larger counts).
     */
    double balance_error(const ModelState &state) const;

    /// The same of the state that was assembled last, into @p system, with its tools; @p state is committed, and its
    /// loads count.
    double imbalance(const System &system, const ModelState &state) const;

  private:
    /// What is left of much larger forces is round-off; so is what there is before any tool has touched.
    double least_force(const ModelState &state) const;
    void begin_loads(const std::string &next_stage, const ModelState &state) const;
    void add_loads(const Vector &q, const ModelState &state, AssemblyTarget &target) const;
    void accept_loads(const Vector &q, ModelState &state) const;
    void accept_tools(const Vector &q, ModelState &state) const;
    void remember_largest(const System &system, ModelState &state) const;

    const Actors &actors_;
    const Numbering &numbering_;
    const SupportSet &supports_;
    const ContactSet &contact_;
  };
} // namespace deltaform
