// Forming limit of a sheet with a groove (Z. Marciniak, K. Kuczynski, Int. J. Mech. Sci. 9 (1967) 609; turned grooves:
// J.W. Hutchinson, K.W. Neale, in Mechanics of Sheet Metal Forming, Plenum 1978, 127). Along the groove (t) both zones
// strain alike, across it (n) they carry the same forces per length: with the logarithmic strains e and the Kirchhoff
// stress tau of sheet A and groove B, and f the ratio of their thicknesses at the start,
//
//   e_tt equal,   f exp(-e_nn) tau_nn of B = exp(-e_nn) tau_nn of A,   the same with tau_nt.
//
// The strain e_nn of the groove grows in small steps; unknown are those of the sheet, which keep their ratio, and e_nt
// of the groove. The groove turns with the metal: tan(angle) grows as exp(e_major - e_minor).
#include "marciniak_kuczynski.h"

#include "plane_stress_points.h"

#include <deltaform/parameters/section.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace deltaform
{
  namespace
  {
    constexpr double root_2 = 1.41421356237309504880;

    /// Sheet and groove from step to step.
    class Localization
    {
    public:
      Localization(const Material &law, const GroovedSheet &sheet, const double ratio)
        : sheet_(law), groove_(law), f_(sheet.thickness_ratio), tan_0_(std::tan(sheet.angle)), ratio_(ratio)
      {
      }

      /// Strain the groove by @p step more across. @return is there a solution?
      bool advance(const double step)
      {
        turn();
        double major = last_major_, shear = last_shear_;
        for (unsigned int iteration = 0; iteration < 30; ++iteration)
        {
          if (!solve(step, major, shear))
            return false;
          if (iteration > 0 && std::abs(residual_[0]) + std::abs(residual_[1]) < 1e-11 * scale_)
          {
            accept(step, major, shear);
            return true;
          }
          const double det = jacobian_[0] * jacobian_[3] - jacobian_[1] * jacobian_[2];
          major -= (jacobian_[3] * residual_[0] - jacobian_[1] * residual_[1]) / det;
          shear -= (jacobian_[0] * residual_[1] - jacobian_[2] * residual_[0]) / det;
          if (!std::isfinite(major) || !std::isfinite(shear))
            return false;
        }
        return false;
      }

      /// How much faster the groove strained in the last step than the sheet, across the groove.
      double speed_ratio = 1.;

      FormingLimit::Point strains() const
      {
        return {sheet_.accepted_strain()[1], sheet_.accepted_strain()[0]};
      }

    private:
      void turn()
      {
        const double tangent = tan_0_ * std::exp(sheet_.accepted_strain()[0] - sheet_.accepted_strain()[1]);
        c_ = 1. / std::sqrt(1. + tangent * tangent);
        s_ = tangent * c_;
        across_ = c_ * c_ + ratio_ * s_ * s_; // de_nn and de_tt of the sheet over the growth of its major strain
        along_ = s_ * s_ + ratio_ * c_ * c_;
      }

      /// Residual and jacobian with the growth of the sheet's major strain and of e_nt.
      bool solve(const double step, const double major, const double shear)
      {
        Mandel &of_sheet = sheet_.strain(), &of_groove = groove_.strain();
        of_sheet = sheet_.accepted_strain();
        of_groove = groove_.accepted_strain();
        of_sheet[0] += major;
        of_sheet[1] += ratio_ * major;
        of_groove[0] += step;
        of_groove[1] += along_ * major;
        of_groove[3] += root_2 * shear;
        if (!sheet_.update() || !groove_.update())
          return false;
        const auto force = [&](const Mandel &t) {
          return std::array<double, 2>{{c_ * c_ * t[0] + s_ * s_ * t[1], c_ * s_ * (t[1] - t[0])}};
        };
        Mandel rate{};
        for (unsigned int i = 0; i < 2; ++i)
          rate[i] = sheet_.tangent()[4 * i] + ratio_ * sheet_.tangent()[4 * i + 1];
        const double thin_a = std::exp(-(across_strain_ + across_ * major));
        const double thin_b = f_ * std::exp(-(groove_.accepted_strain()[0] + step));
        const auto a = force(sheet_.stress()), a_rate = force(rate);
        const std::array<double, 2> b{{groove_.stress()[0], groove_.stress()[3] / root_2}};
        scale_ = std::abs(a[0]) + std::abs(a[1]);
        for (unsigned int i = 0; i < 2; ++i)
        {
          const double *const moduli = groove_.tangent() + 12 * i; // rows nn and nt
          const double unit = i == 0 ? 1. : 1. / root_2;
          residual_[i] = thin_b * b[i] - thin_a * a[i];
          jacobian_[2 * i] = thin_b * unit * moduli[1] * along_ - thin_a * (a_rate[i] - across_ * a[i]);
          jacobian_[2 * i + 1] = thin_b * unit * moduli[3] * root_2;
        }
        return true;
      }

      void accept(const double step, const double major, const double shear)
      {
        sheet_.accept();
        groove_.accept();
        across_strain_ += across_ * major;
        last_major_ = major;
        last_shear_ = shear;
        speed_ratio = step / (across_ * major);
      }

      PlaneStressPoints sheet_, groove_;
      double f_, tan_0_, ratio_;
      double c_ = 1., s_ = 0., across_ = 1., along_ = 0.;
      double across_strain_ = 0.; ///< e_nn of the sheet
      double last_major_ = 0., last_shear_ = 0.;
      double scale_ = 1.;
      std::array<double, 2> residual_{};
      std::array<double, 4> jacobian_{};
    };
  } // namespace


  std::optional<FormingLimit::Point> GroovedSheet::limit(const Material &law, const double ratio) const
  {
    constexpr double faster = 10., step = 2.5e-4; // to a strain of 5
    Localization process(law, *this, ratio);
    FormingLimit::Point before{0., 0.};
    double speed_before = 1.;
    constexpr unsigned int most_steps = 20000;
    for (unsigned int k = 0; k < most_steps; ++k)
    {
      if (!process.advance(step))
        return std::nullopt;
      const FormingLimit::Point now = process.strains();
      const double speed = process.speed_ratio;
      // Unloading of the sheet is faster than any ratio.
      if (speed >= faster || speed < 0.)
      {
        const double share = speed < 0. ? 0. : (faster - speed_before) / (speed - speed_before);
        return FormingLimit::Point{before.minor + share * (now.minor - before.minor),
                                   before.major + share * (now.major - before.major)};
      }
      before = now;
      speed_before = speed;
    }
    return std::nullopt;
  }


  std::optional<FormingLimit::Point> GroovedSheet::least_limit(const Material &law, const double ratio) const
  {
    // Grooves turned by more than about 27 degrees have branches of the solution that are no necks.
    constexpr double degree = .01745329251994329577, most = 27., first_width = 4.5, last_width = .4;
    const auto at = [&](const double turn) { return GroovedSheet{thickness_ratio, turn * degree}.limit(law, ratio); };
    auto best = at(0.);
    if (ratio >= 0.)
      return best;
    // By thirds around the best one.
    double best_turn = 0., begin = first_width, end = most, width = first_width;
    while (width > last_width)
    {
      double turn = begin;
      while (turn <= end)
      {
        if (const auto point = at(turn); point && (!best || point->major < best->major))
        {
          best = point;
          best_turn = turn;
        }
        turn += width;
      }
      begin = std::max(0., best_turn - width);
      end = std::min(most, best_turn + width);
      width /= 3.;
    }
    return best;
  }


  namespace
  {
    std::unique_ptr<FormingLimit> read(Section &section, const Material &law)
    {
      GroovedSheet sheet;
      sheet.thickness_ratio = section.number("Groove", .99, Range::inside(0., 1.), "1",
                                             "Thickness of the groove over that of the sheet, at the start.");
      if (section.documentation())
        return std::make_unique<FormingLimit>(std::vector<FormingLimit::Point>{{0., .2}});
      const MaterialTraits traits = law.traits();
      const std::string objection = law.history_size() == 0 ? "an elastic sheet does not neck"
                                    : !traits.stress_given  ? "the law of the metal has no plane stress"
                                    : traits.needs_duration ? "the law of the metal must not depend on the rate"
                                    : traits.symmetry == Symmetry::orthotropic
                                      ? "the metal must be the same in all directions of the sheet"
                                      : "";
      if (!objection.empty())
        section.fail("Curve", objection + ": give the curve by points");
      std::vector<FormingLimit::Point> points;
      for (const double ratio : {-.5, -.4, -.3, -.2, -.1, 0., .05, .1, .2, .3, .4, .5, .6, .7, .8, .9, 1.})
        if (const auto point = sheet.least_limit(law, ratio);
            point && (points.empty() || point->minor > points.back().minor))
          points.push_back(*point);
      if (points.empty())
        section.fail("Curve", "a groove of this metal does not strain ahead of the sheet: give the curve by points");
      return std::make_unique<FormingLimit>(points);
    }

    const FormingLimits::Entry
      entry("marciniak-kuczynski", "Computed from the metal of the scene: a sheet with a groove", read);
  } // namespace
} // namespace deltaform
