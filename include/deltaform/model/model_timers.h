#pragma once

#include <deltaform/process/timers.h>

namespace deltaform
{
  /// The steps of an assembly and of a commit, as timing.json numbers them.
  struct ModelTimers
  {
    explicit ModelTimers(Timers &timers)
      : all(timers), clear(timers.section("2 clear matrix and residual")),
        body(timers.section("3-6 blank: strains, material, residual, tangent")),
        sum(timers.section("6 sum over processes")),
        contact(timers.section("7-9 contact: projection, forces, tangent")),
        commit(timers.section("12 commit"))
    {
    }

    Timers &all;
    Timers::Index clear, body, sum, contact, commit;
  };
} // namespace deltaform
