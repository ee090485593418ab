#include <deltaform/limits/limit.h>
#include <deltaform/parameters/section.h>

namespace deltaform
{
  std::vector<Limit> read_limits(const Section &scene, const std::vector<std::string> &criteria)
  {
    std::vector<Limit> limits;
    for (const auto &criterion : criteria)
    {
      Section own = scene.sub("Limits").sub(criterion);
      const std::string then =
        own.choice("When reached", "warn", {"warn", "end stage", "end run"},
                   "What happens at the Limit. end stage: the next stage begins at its own time; tools that go on in "
                   "it must not move in the time that is skipped. end run: exit status 2.");
      if (!own.given("Limit") && !own.documentation())
      {
        if (own.given("When reached"))
          own.fail("When reached", "there is no Limit: state the value at which this happens");
        continue;
      }
      Limit limit;
      limit.criterion = criterion;
      limit.most = own.number("Limit", required(1.), Range::positive(), "unit of the criterion",
                              "Largest allowed value. Without it the criterion is only reported.");
      limit.then = then == "warn" ? Limit::Then::warn : then == "end run" ? Limit::Then::end_run
                                                                          : Limit::Then::end_stage;
      limits.push_back(limit);
    }
    return limits;
  }
} // namespace deltaform
