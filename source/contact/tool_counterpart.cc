// Tools as contact meets them: with a given motion, or pressed by a given force.
#include <deltaform/contact/counterpart.h>
#include <deltaform/contact/point_rows.h>
#include <deltaform/tools/tool.h>

namespace deltaform
{
  namespace
  {
    /// Motion given: no unknown.
    class MovedTool : public Counterpart
    {
    public:
      explicit MovedTool(const Tool &tool)
        : tool_(tool)
      {
      }

      const Curve &profile() const override
      {
        return tool_.shape();
      }

      Projection project(const Point2 &x, const unsigned int hint) const override
      {
        return tool_.project(x, 0., hint);
      }

      Tensor1 way(const Vector & /*q*/, const double time) const override
      {
        return tool_.travel(time) * tool_.direction();
      }

    protected:
      const Tool &tool_;
    };


    /// Force F given: the travel w along the direction is unknown. Its equation is the sum of contact forces along the
    /// direction - F = 0.
    class PressedTool : public MovedTool
    {
    public:
      using MovedTool::MovedTool;

      Tensor1 way(const Vector &q, const double /*time*/) const override
      {
        return motion(q);
      }

      unsigned int n_unknowns() const override
      {
        return 1;
      }

      Tensor1 motion(const Vector &d) const override
      {
        return d[first_unknown()] * tool_.direction();
      }

      void add_columns(PointRows &rows) const override
      {
        rows.add_column(first_unknown(), tool_.direction());
      }

      void add_load(const Vector & /*q*/, const double time, AssemblyTarget &target) const override
      {
        const DofIndex travel = first_unknown();
        const double residual = -tool_.force(time), zero = 0.;
        target.add(&travel, 1, target.wants_tangent() ? &zero : nullptr, &residual);
      }
    };
  } // namespace


  std::unique_ptr<Counterpart> make_counterpart(const Tool &tool)
  {
    if (tool.force_driven())
      return std::make_unique<PressedTool>(tool);
    return std::make_unique<MovedTool>(tool);
  }
} // namespace deltaform
