#include <deltaform/materials/hardening_laws.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>

// Boost 1.74 calls isnan without its namespace: math.h, not cmath, declares it.
#include <math.h> // NOLINT(modernize-deprecated-headers)

#include <boost/math/interpolators/pchip.hpp>

#include <stdexcept>

namespace deltaform
{
  struct FlowCurve::Interpolant
  {
    boost::math::interpolators::pchip<std::vector<double>> curve;
  };


  FlowCurve::FlowCurve(const std::vector<std::vector<double>> &rows)
  {
    if (rows.size() < 4)
      throw std::invalid_argument("must have at least four rows.");
    if (rows.front()[0] != 0.)
      throw std::invalid_argument("must begin at plastic strain 0.");
    std::vector<double> strain, stress;
    for (const auto &row : rows)
    {
      const std::string which = "at plastic strain " + text::format(row[0]) + " ";
      if (!strain.empty() && !(row[0] > strain.back()))
        throw std::invalid_argument(which + "the strain does not increase.");
      if (!(row[1] > 0.))
        throw std::invalid_argument(which + "the flow stress is not positive.");
      if (!stress.empty() && !(row[1] >= stress.back()))
        throw std::invalid_argument(which + "the flow stress decreases: the curve must be monotone.");
      strain.push_back(row[0]);
      stress.push_back(row[1]);
    }
    last_strain_ = strain.back();
    last_stress_ = stress.back();
    interpolant_ =
      std::make_shared<Interpolant>(Interpolant{{std::move(strain), std::move(stress)}});
  }


  FlowStress FlowCurve::operator()(const double e) const
  {
    if (e < last_strain_)
      return {interpolant_->curve(e), interpolant_->curve.prime(e)};
    return {last_stress_, 0.};
  }


  namespace
  {
    std::unique_ptr<Hardening> read(Section &section)
    {
      const std::string name = "Flow curve";
      const auto rows = section.rows(name,
                                     required("0 200; 0.02 262; 0.05 301; 0.1 339; 0.2 379; 0.5 438; 1 489"),
                                     2,
                                     "1, stress",
                                     "Rows of plastic strain and flow stress; constant beyond the last one.");
      try
      {
        return hardening_of(FlowCurve(rows));
      }
      catch (const std::invalid_argument &error)
      {
        section.fail(name, error.what());
      }
    }

    const Registry<Hardening>::Entry entry("table", "Monotone cubic through measured points", read);
  } // namespace
} // namespace deltaform
