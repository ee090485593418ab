#include <deltaform/increment/step_control.h>
#include <deltaform/parameters/ceilings.h>
#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>
#include <deltaform/stage/stage.h>

#include <limits>

namespace deltaform
{
  std::vector<Stage> read_stages(Section &section)
  {
    const auto names =
      section.section_names("Stages", "form", "The stages in their order, for example 'form, hold, release'.");
    if (names.empty())
      section.fail("Stages", "at least one stage is needed");
    std::vector<Stage> stages;
    double begin = 0.;
    for (const auto &name : names)
    {
      Section own = section.sub(name);
      Stage stage;
      stage.name = name;
      stage.begin = begin;
      stage.end = own.number("End time", begin + 1., Range::any(), "time", "Time at which the stage ends.");
      if (!(stage.end > begin))
        own.fail("End time", "must be later than the end of the stage before (of the first stage: than 0)");
      if (stage.end - begin < ceilings::smallest_size)
        own.fail("End time", "the stage must last at least " + text::format(ceilings::smallest_size));
      const double length = stage.end - begin;
      stage.first_increment =
        own.number("First increment", length / 100, Range::positive(), "time", "Size of the first increment.");
      stage.largest_increment =
        own.number("Largest increment",
                   StepControl::usual_share * length,
                   Range::positive(),
                   "time",
                   "Largest increment.");
      stage.smallest_increment = own.number("Smallest increment",
                                            1e-7 * length,
                                            Range::positive(),
                                            "time",
                                            "Smallest increment; the run ends with status 2 where an increment of this "
                                            "size fails.");
      // Four digits more than the time has: increments of this size add up to a time that moves.
      if (const double digit = std::numeric_limits<double>::epsilon() * stage.end;
          stage.smallest_increment < 1e4 * digit)
        own.fail("Smallest increment",
                 "is lost in the round-off of the time: at t = " + text::format(stage.end) + " it must be at least " +
                   text::rounded(1e4 * digit));
      if (stage.smallest_increment > stage.largest_increment)
        own.fail("Smallest increment", "must not be larger than the largest");
      stage.release_at_once = own.choice("Release",
                                         "gradual",
                                         {"gradual", "at once"},
                                         "How the tools, supports and loads of the stage before leave: their forces "
                                         "fade out linearly over this stage (gradual), or are gone in its first "
                                         "increment (at once).") == "at once";
      stage.ends_when =
        own.text("Ends when", Default<std::string>(""),
                 "Conditions, separated by semicolons, of which the first that holds ends the stage before its end "
                 "time: 'punch_force_z > 20e3', 'thinning > .3', 'holder_to_die_gap < 1', 'die_touching < 1', or "
                 "'punch_force_z falls to .9' of its largest size in the stage.");
      stage.continue_after_necking =
        own.flag("Continue after necking", false, "Go on, with a warning, when the sheet necks; else the run ends.");
      begin = stage.end;
      stages.push_back(stage);
    }
    return stages;
  }
} // namespace deltaform
