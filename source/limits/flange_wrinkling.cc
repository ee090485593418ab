#include <deltaform/limits/flange_wrinkling.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace deltaform
{
  namespace
  {
    std::size_t column(const Table &table, const std::string &name)
    {
      const auto found = std::find(table.names.begin(), table.names.end(), name);
      Assert(found != table.names.end(), dealii::ExcInternalError());
      return found - table.names.begin();
    }
  } // namespace


  std::unique_ptr<FlangeWrinkling> FlangeWrinkling::read(const Section &scene, const Blank &blank)
  {
    Section limits = scene.sub("Limits");
    const std::string then =
      limits.choice("Flange wrinkling", "no", {"no", "warn", "end stage", "end run"},
                    "What happens where the flange of an axisymmetric shell would wrinkle and no holder keeps the "
                    "waves down. no: the flange is not looked at.");
    std::unique_ptr<FlangeWrinkling> result(new FlangeWrinkling());
    result->height_ = limits.function("Wrinkle height", "thickness", "length",
                                      "Height of the waves, from trough to crest, that the holder has to keep down "
                                      "('Flange wrinkling').",
                                      {{"thickness", blank.initial_thickness()}})(0.);
    if (then == "no")
      return nullptr;
    if (!(result->height_ > 0.) || !std::isfinite(result->height_))
      limits.fail("Wrinkle height", "must be positive");
    if (!blank.axisymmetric() || blank.fields().sections().empty())
      limits.fail("Flange wrinkling", "is for axisymmetric shells: waves run around the axis");
    result->then_ = then == "warn"        ? Limit::Then::warn
                    : then == "end stage" ? Limit::Then::end_stage
                                          : Limit::Then::end_run;
    Section material = scene.sub("Material");
    const auto law = Registry<Material>::choose(material, "Model", "elastoplastic", "Stress-strain law.");
    result->young_modulus_ = law->young_modulus();
    result->poisson_ratio_ = law->poisson_ratio();
    if (law->history_size() > 0)
      result->curve_ = uniaxial_curve(*law);
    return result;
  }


  std::vector<RingPoint> FlangeWrinkling::flange(const Table &profile) const
  {
    constexpr double largest_slope = .1;
    const std::size_t r = column(profile, "r"), z = column(profile, "z"), h = column(profile, "thickness"),
                      strain = column(profile, "equivalent_plastic_strain"),
                      radial = column(profile, "stress_meridional_bottom"),
                      hoop = column(profile, "stress_hoop_bottom");
    // Three layers, by Simpson's rule.
    const auto mean = [](const std::vector<double> &row, const std::size_t first) {
      return (row[first] + 4. * row[first + 1] + row[first + 2]) / 6.;
    };
    std::vector<RingPoint> result;
    for (std::size_t i = profile.rows.size(); i-- > 0;)
    {
      const auto &row = profile.rows[i];
      if (i + 1 < profile.rows.size())
      {
        const auto &outer = profile.rows[i + 1];
        if (!(std::abs(outer[z] - row[z]) <= largest_slope * (outer[r] - row[r])))
          break;
      }
      const double e = young_modulus_;
      const double tangent = curve_.empty() ? e : std::max(tangent_modulus(curve_, row[strain]), 0.);
      const double reduced = 4. * e * tangent / std::pow(std::sqrt(e) + std::sqrt(tangent), 2);
      // A perfectly plastic metal has no stiffness of its own; what is left keeps the numbers finite.
      const double modulus = std::max(reduced, 1e-6 * e);
      result.push_back({row[r], row[h] * mean(row, radial), row[h] * mean(row, hoop),
                        modulus * std::pow(row[h], 3) / (12. * (1. - poisson_ratio_ * poisson_ratio_))});
    }
    std::reverse(result.begin(), result.end());
    // On the axis there is no inner edge: a sheet that is flat as a whole has not begun.
    constexpr std::size_t fewest = 4;
    return result.size() < fewest || !(result.front().r > 0.) ? std::vector<RingPoint>() : result;
  }


  FlangeWrinkling::Result FlangeWrinkling::judge(const Table &profile,
                                                 const std::vector<ContactInterface *> &interfaces) const
  {
    const auto ring = flange(profile);
    Result result;
    if (ring.empty())
      return result;
    result.wrinkles = wrinkle(ring, poisson_ratio_, height_);
    double force = 0.;
    for (const ContactInterface *const interface : interfaces)
      if (interface->tool().side() == Side::top)
        for (const ContactPointState &point : interface->committed())
          if (point.touching && point.position[0] >= ring.front().r)
            force += point.force;
    const double area = ring.back().r * ring.back().r - ring.front().r * ring.front().r;
    result.holder_pressure = force / (dealii::numbers::PI * area);
    return result;
  }
} // namespace deltaform
