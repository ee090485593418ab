// Coulomb by tables: |t| <= mu(p) f(u) lambda. p = lambda/A is the contact pressure, mu(p) is linear between the rows
// of a table and constant outside; f, a table likewise, is a share of it over the path u that the point has slid
// until the last accepted increment: lubricant is squeezed out where the pressure is high, and used up where the blank
// slides far.
// Units: p stress, u length, t and lambda forces.
#include <deltaform/contact/friction_law.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>

#include <algorithm>
#include <vector>

namespace deltaform
{
  namespace
  {
    /// Linear between rows, constant outside.
    class PiecewiseLinear
    {
    public:
      struct Value
      {
        double value, slope;
      };

      /// @throws SceneError if the rows do not begin at 0 and increase, or have negative values
      PiecewiseLinear(Section &section, const std::string &name, std::vector<std::vector<double>> rows)
        : rows_(std::move(rows))
      {
        if (rows_.empty() || rows_.front()[0] != 0.)
          section.fail(name, "the first row must begin with 0");
        for (std::size_t i = 0; i < rows_.size(); ++i)
        {
          if (i > 0 && !(rows_[i][0] > rows_[i - 1][0]))
            section.fail(name, "the first column must increase from row to row; " + text::format(rows_[i][0]) +
                                 " does not");
          if (!(rows_[i][1] >= 0.))
            section.fail(name, "at " + text::format(rows_[i][0]) + " the second column is negative");
        }
      }

      Value operator()(const double x) const
      {
        const auto right =
          std::find_if(rows_.begin(), rows_.end(), [&](const std::vector<double> &row) { return row[0] > x; });
        if (right == rows_.end())
          return {rows_.back()[1], 0.};
        const auto &b = *right, &a = *(right - 1);
        const double slope = (b[1] - a[1]) / (b[0] - a[0]);
        return {a[1] + slope * (x - a[0]), slope};
      }

      const std::vector<std::vector<double>> &rows() const
      {
        return rows_;
      }

    private:
      std::vector<std::vector<double>> rows_;
    };

    class CoulombByTable : public FrictionLaw
    {
    public:
      explicit CoulombByTable(Section &section)
        : coefficient_(section, over_pressure,
                       section.rows(over_pressure, required("0 0.12; 20 0.08; 100 0.05"), 2, "stress, 1",
                                    "Rows of contact pressure and Coulomb's coefficient, the first at 0; linear "
                                    "between them, constant beyond.")),
          share_(section, over_slip,
                 section.rows(over_slip, "0 1", 2, "length, 1",
                              "Rows of the path that a point has slid and the factor of mu, the first at 0; "
                              "linear between them, constant beyond."))
      {
        // mu p is a parabola between two rows: where mu falls, its slope is least at the second one.
        const auto &rows = coefficient_.rows();
        for (std::size_t i = 1; i < rows.size(); ++i)
          if (const double slope = (rows[i][1] - rows[i - 1][1]) / (rows[i][0] - rows[i - 1][0]);
              rows[i][1] + slope * rows[i][0] < 0.)
            section.fail(over_pressure, "just below the pressure " + text::format(rows[i][0]) +
                                          " the coefficient falls so fast that the friction force falls while the "
                                          "pressure grows");
      }

      FrictionLimit limit(const FrictionInput &input) const override
      {
        const double pressure = input.area > 0. ? std::max(input.normal_force, 0.) / input.area : 0.;
        const auto mu = coefficient_(pressure);
        const double share = share_(input.slip).value;
        return {share * mu.value * input.normal_force, share * (mu.value + mu.slope * pressure)};
      }

      bool depends_on_pressure() const override
      {
        return true;
      }

      bool acts() const override
      {
        const auto positive = [](const std::vector<double> &row) { return row[1] > 0.; };
        const auto &mu = coefficient_.rows(), &share = share_.rows();
        return std::any_of(mu.begin(), mu.end(), positive) && std::any_of(share.begin(), share.end(), positive);
      }

    private:
      static constexpr const char *over_pressure = "Coefficient over pressure";
      static constexpr const char *over_slip = "Factor over slip";

      PiecewiseLinear coefficient_, share_;
    };

    const Registry<FrictionLaw>::Entry entry("coulomb by table",
                                             "|t| <= mu lambda, mu by tables over the pressure and the path of sliding",
                                             &make_as<CoulombByTable, FrictionLaw>);
  } // namespace
} // namespace deltaform
