#include <deltaform/conditions/conditions.h>
#include <deltaform/parameters/percent.h>
#include <deltaform/reports/accepted_increment.h>
#include <deltaform/reports/mesh_error_sum.h>

namespace deltaform
{
  namespace
  {
    /// Does the mesh of a solid resolve how the metal flows? Where it does not, forces are too large, and all balances
    /// are closed.
    class CoarseMesh : public SavedCondition<CoarseMesh>
    {
    public:
      void observe(const AcceptedIncrement &increment) override
      {
        sum_.add(increment);
      }

      std::vector<std::string> warnings(bool) const override
      {
        // Random bulk processes against finer meshes (doc/measured/mesh_error.csv): work is at most twice, the largest
        // force six times this too large.
        constexpr double largest = .03;
        const double share = sum_.share();
        if (share <= largest)
          return {};
        return {"coarse mesh: stresses and flow differ from smoothed ones by " + text::percent(share) +
                " of the plastic work. The work of the tools may be too large by up to twice that, their largest force "
                "by up to six times. Take shorter elements where the metal flows around an edge (Blank/Elements, "
                "Elements through thickness, Grading), or elements of degree 2 (Blank/Degree)."};
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &sum_;
      }

    private:
      MeshErrorSum sum_;
    };

    const ConditionMakers::Entry
      entry("coarse mesh", "the mesh of a solid is too coarse for the flow of the metal", make_condition<CoarseMesh>);
  } // namespace
} // namespace deltaform
