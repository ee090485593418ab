#include "bounded_motion.h"

#include <deltaform/materials/back_stress.h>
#include <deltaform/materials/hardening.h>
#include <deltaform/materials/read_law.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace deltaform
{
  namespace
  {
    struct Constants
    {
      double Y, B, C, m, b, h, Rsat;

      static const ParameterTable<Constants> &parameters()
      {
        static const ParameterTable<Constants> table{
          {{"Yield stress", &Constants::Y, Range::positive(), "stress", "Y: size of the yield surface.", 337.},
           {"Bounding stress", &Constants::B, Range::positive(), "stress",
            "B > Y: initial size of the bounding surface.", 620.},
           {"Yield surface rate", &Constants::C, Range::positive(), "1",
            "C: how fast the yield surface moves towards the bounding surface.",
            500.},
           {"Bounding surface rate", &Constants::m, Range::not_negative(), "1",
            "m: how fast the bounding surface moves and hardens.", 34.},
           {"Bounding backstress", &Constants::b, Range::not_negative(), "stress",
            "b: saturation value of the backstress of the bounding surface.", 202.},
           {"Stagnation", &Constants::h, Range::between(0., 1.), "1",
            "h: share by which the stagnation surface grows; the rest moves it.", .772},
           {"Saturation stress", &Constants::Rsat, Range::not_negative(), "stress",
            "Rsat: final isotropic hardening of the bounding surface.", 190.}},
          {{"Bounding stress", "must be larger than the yield stress.",
            [](const Constants &law) { return law.B > law.Y; }}}};
        return table;
      }
    };

    /// <a, b> = 3/2 a : b, of deviators: <a, a> is the square of the Mises stress.
    double product(const Mandel &a, const Mandel &b)
    {
      return 1.5 * (a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]);
    }

    Mandel sum(const Mandel &a, const double factor, const Mandel &b)
    {
      return {{a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2], a[3] + factor * b[3]}};
    }

    Mandel tensor(const double *values)
    {
      return {{values[0], values[1], values[2], values[3]}};
    }

    /**
     * Yoshida and Uemori: a yield surface of constant size Y moves by theta in a bounding surface of size B + R, whose
     * centre is beta. With n = dev(xi)/q, |.|^2 = <., .> and a = B + R - Y,
     *
     *     alpha = theta + beta,   d theta = C (a n - sqrt(a/|theta|) theta) dx,   d beta = m (b n - beta) dx,
     *
     * and d R = m (Rsat - R) dx only while the surface of stagnation moves, centre g and radius r: |beta - g| = r, and
     * beta goes outwards; then d r = h d|beta - g| and d g = (1 - h) d|beta - g| along beta - g, with d|.| at fixed g.
     * All start at zero. F. Yoshida, T. Uemori, A model of large-strain cyclic plasticity describing the Bauschinger
     * effect and workhardening stagnation, Int. J. Plasticity 18 (2002) 661. Their modulus: FallingModulus.
     *
     * All of it follows the growth of the strain by one-step rules of second order from the begin of the increment:
     * after a reversal theta relaxes within few increments, and R starts and stops to grow within one, where BDF2 would
     * be of first order. n is that of the end, or, where BDF2 goes on with the flow, the mean of begin and end. Theta:
     * BoundedMotion, beta: exact. R, g and r follow the straight path of beta, of which the part beyond its last point
     * inside the surface of stagnation moves them, R by the exact solution, g and r by the midpoint rule: so R does
     * not jump from one iteration to the next.
     */
    class YoshidaUemori final : public BackStress
    {
    public:
      explicit YoshidaUemori(const Constants &constants)
        : law_(constants)
      {
      }

      HistoryLayout history_layout() const override
      {
        return {{"backstress_in_bounds", HistoryKind::tensor, "stress"},
                {"backstress_of_bounds", HistoryKind::tensor, "stress"},
                {"centre_of_stagnation", HistoryKind::tensor, "stress"},
                {"radius_of_stagnation", HistoryKind::positive, "stress"},
                {"hardening_of_bounds", HistoryKind::positive, "stress"},
                {"direction_of_flow", HistoryKind::tensor, "1"}};
      }

      std::string objection(const YieldSurface &, const Hardening &hardening) const override
      {
        if (hardening.evaluate(0.).value == law_.Y && hardening.evaluate(1.).value == law_.Y)
          return {};
        return "the yield surface keeps its size, the bounding surface hardens: set Hardening/Law = perfectly plastic "
               "with the flow stress that is the Yield stress here.";
      }

      Mandel value(const double *history) const override
      {
        return sum(tensor(history), 1., tensor(history + beta));
      }

      BackStressEnd update(const BackStressStart &from,
                           const Mandel &relative_stress,
                           const YieldPoint &at,
                           double x,
                           double *end) const override;

    private:
      /// Places in the history.
      static constexpr unsigned int beta = 4, centre = 8, radius = 12, growth = 13, direction = 14;

      /// A vector with its derivatives: columns 0 to 3 by the relative stress, 4 by the flow.
      struct Moved
      {
        Mandel value;
        std::array<Mandel, 5> by;
      };

      /// R at the end, with its derivatives.
      struct Bounds
      {
        double R;
        std::array<double, 5> by;
      };

      /// The part of the straight path of beta that is left to go when it leaves the surface of stagnation for good.
      struct Way
      {
        Mandel from, path; ///< from the centre to its begin; to its end
        double share; ///< of the whole path
        Mandel share_by_beta; ///< by the end of the path
      };

      Moved move_bounds(const double *committed, const Moved &n, double x) const;
      static Way way_outside(const double *committed, const Mandel &end);
      Bounds grow_bounds(const double *committed, const Moved &moved, double x, double *end) const;
      Moved move_yield_surface(const double *committed, const Moved &n, const Bounds &bounds, double x) const;

      Constants law_;
    };


    YoshidaUemori::Moved
    YoshidaUemori::move_bounds(const double *committed, const Moved &n, const double x) const
    {
      const double left = std::exp(-law_.m * x), follows = -std::expm1(-law_.m * x) * law_.b;
      Moved moved{};
      for (unsigned int i = 0; i < 4; ++i)
      {
        moved.value[i] = left * committed[beta + i] + follows * n.value[i];
        for (unsigned int j = 0; j < 4; ++j)
          moved.by[j][i] = follows * n.by[j][i];
        moved.by[4][i] = law_.m * (law_.b * n.value[i] - moved.value[i]);
      }
      return moved;
    }


    YoshidaUemori::Way YoshidaUemori::way_outside(const double *committed, const Mandel &end)
    {
      const Mandel g = tensor(committed + centre), before = sum(tensor(committed + beta), -1., g);
      const Mandel now = sum(end, -1., g), path = sum(now, -1., before);
      const double r = std::max(committed[radius], 0.);
      // |before + s path| = r
      const double A = product(path, path), B = product(before, path);
      const double C = std::min(product(before, before) - r * r, 0.);
      if (!(product(now, now) > r * r && A > 0.))
        return {};
      const double s = std::clamp((std::sqrt(B * B - A * C) - B) / A, 0., 1.);
      Way way{sum(before, s, path), sum(path, -s, path), 1. - s, {}};
      const double outwards = product(way.from, path);
      if (s > 0. && outwards > 0.)
        for (unsigned int i = 0; i < 4; ++i)
          way.share_by_beta[i] = 1.5 * s * way.from[i] / outwards;
      return way;
    }


    YoshidaUemori::Bounds YoshidaUemori::grow_bounds(const double *committed,
                                                     const Moved &moved,
                                                     const double x,
                                                     double *end) const
    {
      const Way way = way_outside(committed, moved.value);
      const double R_before = std::max(committed[growth], 0.);
      const double left = (law_.Rsat - R_before) * std::exp(-law_.m * way.share * x);
      Bounds bounds{law_.Rsat - left, {}};
      for (unsigned int j = 0; j < 5; ++j)
      {
        double share_slope = 0.;
        for (unsigned int i = 0; i < 4; ++i)
          share_slope += way.share_by_beta[i] * moved.by[j][i];
        bounds.by[j] = law_.m * left * (share_slope * x + (j == 4 ? way.share : 0.));
      }

      // Midpoint rule: the direction u of the sum of beta - g at both ends, which is along 2 from + path. It keeps
      // |beta - g| for h = 0 and g for h = 1.
      const Mandel both = sum(way.path, 2., way.from);
      const double squared = product(both, both);
      const double moves = squared > 0. ? (1. - law_.h) * product(both, way.path) / squared : 0.;
      const Mandel g = sum(tensor(committed + centre), moves, both);
      const Mandel distance = sum(moved.value, -1., g);
      end[radius] = way.share > 0. ? std::sqrt(product(distance, distance)) : committed[radius];
      end[growth] = bounds.R;
      std::copy(g.begin(), g.end(), end + centre);
      return bounds;
    }


    YoshidaUemori::Moved YoshidaUemori::move_yield_surface(const double *committed,
                                                           const Moved &n,
                                                           const Bounds &bounds,
                                                           const double x) const
    {
      const Mandel start = tensor(committed);
      const double a = law_.B - law_.Y;
      const BoundedMotion motion(product(start, start), product(start, n.value), product(n.value, n.value),
                                 law_.C * x, a + std::max(committed[growth], 0.), a + bounds.R);
      const auto &p = motion.p(), &q = motion.q();
      Moved moved{};
      moved.value = sum(sum({}, p.value, start), q.value, n.value);
      for (unsigned int j = 0; j < 5; ++j)
      {
        std::array<double, BoundedMotion::n_parameters> by{};
        by[BoundedMotion::along] = product(start, n.by[j]);
        by[BoundedMotion::square] = 2. * product(n.value, n.by[j]);
        by[BoundedMotion::length] = j < 4 ? 0. : law_.C;
        by[BoundedMotion::bound] = bounds.by[j];
        double p_slope = 0., q_slope = 0.;
        for (unsigned int z = 0; z < by.size(); ++z)
        {
          p_slope += p.by[z] * by[z];
          q_slope += q.by[z] * by[z];
        }
        moved.by[j] = sum(sum(sum({}, p_slope, start), q_slope, n.value), q.value, n.by[j]);
      }
      return moved;
    }


    BackStressEnd YoshidaUemori::update(const BackStressStart &from,
                                        const Mandel &relative_stress,
                                        const YieldPoint &at,
                                        const double flow,
                                        double *end) const
    {
      const Direction at_end(relative_stress, at);
      const double *committed = from.committed, x = from.predicted_flow + flow;
      const double share = from.predicted_flow > 0. ? .5 : 1.;
      Moved n{};
      for (unsigned int i = 0; i < 4; ++i)
      {
        n.value[i] = share * at_end.value[i] + (1. - share) * committed[direction + i];
        for (unsigned int j = 0; j < 4; ++j)
          n.by[j][i] = share * at_end.by_relative_stress[4 * i + j];
      }
      const Moved bounds_moved = move_bounds(committed, n, x);
      const Bounds bounds = grow_bounds(committed, bounds_moved, x, end);
      const Moved surface_moved = move_yield_surface(committed, n, bounds, x);
      BackStressEnd result{};
      for (unsigned int i = 0; i < 4; ++i)
      {
        end[i] = surface_moved.value[i];
        end[beta + i] = bounds_moved.value[i];
        end[direction + i] = at_end.value[i];
        result.value[i] = end[i] + end[beta + i];
        for (unsigned int j = 0; j < 4; ++j)
          result.by_relative_stress[4 * i + j] = surface_moved.by[j][i] + bounds_moved.by[j][i];
        result.by_flow[i] = surface_moved.by[4][i] + bounds_moved.by[4][i];
      }
      return result;
    }


    std::unique_ptr<BackStress> make(Section &section)
    {
      return std::make_unique<YoshidaUemori>(read_law<Constants>(section));
    }

    const Registry<BackStress>::Entry entry("yoshida-uemori", "Two surfaces, with stagnation of work hardening", make);
  } // namespace
} // namespace deltaform
