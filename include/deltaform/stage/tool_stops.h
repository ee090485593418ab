#pragma once

#include <deltaform/assembly/term.h>
#include <deltaform/stage/actors.h>

#include <vector>

namespace deltaform
{
  /**
   * The stops of force-driven tools: at a travel, and at the tools on the other side of the blank. A stop is a stiff
   * spring F/delta that only pushes, so that the tool goes beyond it by no more than its allowed penetration delta, by
   * all of its force F. A tool that its blank has left rests on it.
   */
  class ToolStops : public Term
  {
  public:
    explicit ToolStops(const Actors &actors)
      : actors_(actors), known_(actors.tools.size())
    {
    }

    void enter_stage(const std::string &stage)
    {
      stage_ = stage;
      known_.assign(known_.size(), Clearance());
    }

    Status assemble(const Vector &q, double time, AssemblyTarget &target) const override;

  private:
    /// Of a tool to the others at a time and travel: no stop is nearer than that.
    struct Clearance
    {
      double time = -1., travel = 0., gap = 0.;
    };

    /// How far tool @p i is beyond its stop (length); 0 if it is not.
    double overrun(unsigned int i, double travel, double time) const;

    /// Gap to the nearest tool on the other side, beyond the least one.
    double clearance(const Tool &tool, double travel, double time, double reach) const;

    const Actors &actors_;
    std::string stage_;
    /// What was found last, of every tool. It spares a search where the tool is certainly clear, and changes no answer.
    mutable std::vector<Clearance> known_;
  };
} // namespace deltaform
