#include <deltaform/base/registry.h>
#include <deltaform/base/text.h>
#include <deltaform/materials/hardening.h>

// Boost 1.74 calls isnan without its namespace: math.h, not cmath, declares it.
#include <math.h> // NOLINT(modernize-deprecated-headers)

#include <boost/math/interpolators/pchip.hpp>

namespace deltaform
{
  namespace
  {
    /**
     * Measured curve: rows (e, s), at least four, e from 0 upwards strictly increasing, s > 0 not decreasing. Between
     * the rows the monotone piecewise cubic through them: continuous slope, no overshoot, exact for points on a line.
     * Beyond the last row s is constant (slope 0), as in Abaqus: what was not measured is not invented. Give a last row
     * beyond the strains expected if hardening is to go on. Strains are logarithmic plastic strains, stresses Kirchhoff
     * stresses (for metals the true stress, up to the elastic change of volume). F.N. Fritsch, J. Butland, A method for
     * constructing local monotone piecewise cubic interpolants, SIAM J. Sci. Stat. Comput. 5 (1984) 300.
     */
    class HardeningTable : public Hardening
    {
      using Curve = boost::math::interpolators::pchip<std::vector<double>>;

    public:
      explicit HardeningTable(Section &section)
        : HardeningTable(read(section))
      {
      }

      FlowStress evaluate(const double e) const override
      {
        if (e < last_strain_)
          return {curve_(e), curve_.prime(e)};
        return {last_stress_, 0.};
      }

    private:
      struct Columns
      {
        std::vector<double> strain, stress;
      };

      explicit HardeningTable(Columns columns)
        : last_strain_(columns.strain.back()), last_stress_(columns.stress.back()),
          curve_(std::move(columns.strain), std::move(columns.stress))
      {
      }

      static Columns read(Section &section)
      {
        const std::string name = "Flow curve";
        Columns columns;
        const auto rows = section.rows(name,
                                       required("0 200; 0.02 262; 0.05 301; 0.1 339; 0.2 379; 0.5 438; 1 489"),
                                       2,
                                       "1, stress",
                                       "Rows of plastic strain and flow stress; constant beyond the last one.");
        if (rows.size() < 4)
          section.fail(name, "must have at least four rows.");
        if (rows.front()[0] != 0.)
          section.fail(name, "must begin at plastic strain 0.");
        for (const auto &row : rows)
        {
          const std::string which = "at plastic strain " + text::format(row[0]) + " ";
          if (!columns.strain.empty() && !(row[0] > columns.strain.back()))
            section.fail(name, which + "the strain does not increase.");
          if (!(row[1] > 0.))
            section.fail(name, which + "the flow stress is not positive.");
          if (!columns.stress.empty() && !(row[1] >= columns.stress.back()))
            section.fail(name, which + "the flow stress decreases: the curve must be monotone.");
          columns.strain.push_back(row[0]);
          columns.stress.push_back(row[1]);
        }
        return columns;
      }

      double last_strain_, last_stress_;
      Curve curve_;
    };

    const Registry<Hardening>::Entry
      entry("table", "Monotone cubic through measured points", make_as<HardeningTable, Hardening>);
  } // namespace
} // namespace deltaform
