#pragma once

#include <deltaform/assembly/side.h>
#include <deltaform/assembly/term.h>
#include <deltaform/stage/stage.h>

#include <vector>

namespace deltaform
{
  /**
   * Forces of the tools, supports and loads that ended with the last stage, or of the operation before, as they were in
   * its last equilibrium. They fade out linearly over the stage,
   * F(t) = F (t_end - t)/(t_end - t_begin), or are gone at once (Steps/Release).
   */
  struct ReleasedForces : public Term
  {
    /// No forces, for @p n unknowns and so many tools, supports and loads.
    void reset(unsigned int n, unsigned int n_tools, unsigned int n_supports, unsigned int n_loads);

    /// A stage begins: from when to when the forces fade.
    void begin_stage(const Stage &stage);

    /// Share of the forces that still acts at @p time.
    double share(double time) const;

    /// Add what acts at @p time to the residual.
    void add(double time, AssemblyTarget &target) const;

    Status assemble(const Vector & /*q*/, const double time, AssemblyTarget &target) const override
    {
      add(time, target);
      return {};
    }

    /// Is there anything to release?
    bool any = false;

    Vector on_blank; ///< force on each unknown
    std::vector<Tensor1> of_tools; ///< of the blank on each tool
    std::vector<double> of_supports;
    std::vector<Tensor1> of_loads;
    Tensor1 of_earlier_operation; ///< resultant of what held the blank in it
    FaceValues pressure; ///< of the tools on the nodes, empty if none has left

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive &any &on_blank &of_tools &of_supports &of_loads &of_earlier_operation &pressure[0] & pressure[1];
    }

  private:
    double begin_ = 0., end_ = 1.;
    bool at_once_ = false;
  };
} // namespace deltaform
