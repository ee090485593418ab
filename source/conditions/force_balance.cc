#include <deltaform/conditions/conditions.h>
#include <deltaform/conditions/worst_imbalance.h>
#include <deltaform/parameters/percent.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    /// Of a tool, a load or a support, in any direction.
    double largest_force(const Model &model)
    {
      double result = 0.;
      const auto count = [&result](const Tensor1 &force) {
        result = std::max({result, std::abs(force[0]), std::abs(force[1])});
      };
      for (const auto &force : model.tool_forces())
        count(force);
      for (unsigned int i = 0; i < model.actors().loads.size(); ++i)
        count(model.load_force(i));
      for (unsigned int i = 0; i < model.actors().supports.size(); ++i)
        if (model.actors().supports[i].component != Component::rotation)
          result = std::max(result, std::abs(model.reaction(i)));
      return result;
    }


    /// Do the forces of tools, supports and loads balance in every increment?
    class ForceBalance : public SavedCondition<ForceBalance>
    {
    public:
      void observe(const AcceptedIncrement &increment) override
      {
        imbalance_.tell(increment.balance_error(), largest_force(increment.model), increment.time);
      }

      std::vector<std::string> warnings(bool) const override
      {
        const WorstImbalance::Entry *const worst = imbalance_.worst();
        if (worst == nullptr)
          return {};
        return {"force balance: the forces of tools, supports and loads leave " + text::percent(worst->error) +
                " of the largest of them unbalanced at time " + text::rounded(worst->time) +
                ". Set smaller Solver/Force tolerance and Relaxed force tolerance."};
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &imbalance_;
      }

    private:
      WorstImbalance imbalance_;
    };

    const ConditionMakers::Entry
      entry("force balance", "forces of tools, supports and loads do not balance", make_condition<ForceBalance>);
  } // namespace
} // namespace deltaform
