#include <deltaform/scene/recorder.h>
#include <deltaform/scene/simulation.h>

#include <cstdio>
namespace deltaform
{
  struct Recorder::Files
  {
    Scene &s;
    unsigned int iters=0;
  };
  Recorder::Recorder(Scene &scene, const std::string &, Journal &, Timers &)
    : files_(std::make_unique<Files>(Files{scene}))
  {}
  Recorder::~Recorder() = default;
  void
  Recorder::record(const FormingProblem &problem, const Stage &, double time, unsigned int increment, const IncrementCost &cost)
  {
    double pmax = 0;
    ContactEnergy ce;
    unsigned nt = 0;
    for (auto *pair : problem.active_pairs())
      {
        for (auto &s : pair->committed())
          if (s.touching)
            { pmax = std::max(pmax, s.penetration() / s.delta); ++nt; }
        ce += pair->energy();
      }
    const auto be = files_->s.actors.blank->energy();
    const double in = problem.work().tools + problem.work().loads + ce.epsilon + ce.thickness + be.normal;
    const double out = be.elastic + be.plastic + ce.stored + ce.friction;
    std::printf("%4u t %.5f F %.6f it %u r %u cb %u p/d %.4f n %u hmin %.5f  W %.6g el %.4g pl %.6g fr %.4g c %.3g eps %.3g th %.3g nrm %.3g err %.3g\n",
                increment, time, problem.tool_forces().empty() ? 0. : problem.tool_forces()[0][1], cost.iterations, cost.rounds, cost.cutbacks, pmax, nt,
                files_->s.actors.blank->smallest_thickness(), problem.work().tools, be.elastic, be.plastic, ce.friction, ce.stored, ce.epsilon, ce.thickness, be.normal, (in - out) / in);
    files_->iters += cost.iterations;
  }
  void
  Recorder::finish(int status, const FormingProblem &, unsigned int inc, unsigned int it)
  {
    std::printf("status %d increments %u iterations %u\n", status, inc, it);
  }
} // namespace deltaform
