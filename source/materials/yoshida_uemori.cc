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
     * Backward Euler. The share of the increment in which the surface of stagnation moves is that beyond the last point
     * of the straight path of beta inside of it, so that R does not jump from one iteration to the next.
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
                {"hardening_of_bounds", HistoryKind::positive, "stress"}};
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

      BackStressEnd update(const double *start,
                           const Mandel &relative_stress,
                           const YieldPoint &at,
                           double x,
                           double *end) const override;

    private:
      /// Places in the history.
      static constexpr unsigned int beta = 4, centre = 8, radius = 12, growth = 13;

      /// A vector with its derivatives: columns 0 to 3 by the relative stress, 4 by the flow.
      struct Moved
      {
        Mandel value;
        std::array<Mandel, 5> by;
      };

      /// R at the end, with its derivatives, and the surface of stagnation.
      struct Bounds
      {
        double R;
        std::array<double, 5> by;
      };

      Moved move_bounds(const double *start, const Direction &n, double x) const;
      Bounds grow_bounds(const double *start, const Moved &moved, double x, double *end) const;
      Moved move_yield_surface(const double *start, const Direction &n, const Bounds &bounds, double x) const;

      Constants law_;
    };


    YoshidaUemori::Moved YoshidaUemori::move_bounds(const double *start, const Direction &n, const double x) const
    {
      const double scale = 1. / (1. + law_.m * x), rate = law_.m * law_.b;
      Moved moved{};
      for (unsigned int i = 0; i < 4; ++i)
      {
        moved.value[i] = scale * (start[beta + i] + rate * x * n.value[i]);
        for (unsigned int j = 0; j < 4; ++j)
          moved.by[j][i] = scale * rate * x * n.by_relative_stress[4 * i + j];
        moved.by[4][i] = scale * (rate * n.value[i] - law_.m * moved.value[i]);
      }
      return moved;
    }


    YoshidaUemori::Bounds YoshidaUemori::grow_bounds(const double *start,
                                                     const Moved &moved,
                                                     const double x,
                                                     double *end) const
    {
      const Mandel before = sum(tensor(start + beta), -1., tensor(start + centre));
      const Mandel now = sum(moved.value, -1., tensor(start + centre)), path = sum(now, -1., before);
      const double r = std::max(start[radius], 0.), distance = std::sqrt(product(now, now));

      // Share s of the path at which beta leaves the surface of stagnation for good: |before + s path| = r
      const double A = product(path, path), B = product(before, path);
      const double C = std::min(product(before, before) - r * r, 0.);
      double share = 1.;
      Mandel share_by_beta{};
      if (distance > r && A > 0.)
      {
        share = std::clamp((std::sqrt(B * B - A * C) - B) / A, 0., 1.);
        const Mandel there = sum(before, share, path);
        const double outwards = product(there, path);
        if (share > 0. && outwards > 0.)
          for (unsigned int i = 0; i < 4; ++i)
            share_by_beta[i] = -1.5 * share * there[i] / outwards;
      }

      const double y = (1. - share) * x, R_before = std::max(start[growth], 0.);
      Bounds bounds{(R_before + law_.m * law_.Rsat * y) / (1. + law_.m * y), {}};
      const double rate = law_.m * (law_.Rsat - bounds.R) / (1. + law_.m * y);
      for (unsigned int j = 0; j < 5; ++j)
      {
        double share_slope = 0.;
        for (unsigned int i = 0; i < 4; ++i)
          share_slope += share_by_beta[i] * moved.by[j][i];
        bounds.by[j] = rate * (-share_slope * x + (j == 4 ? 1. - share : 0.));
      }

      const double beyond = std::max(distance - r, 0.);
      end[radius] = r + law_.h * beyond;
      end[growth] = bounds.R;
      for (unsigned int i = 0; i < 4; ++i)
        end[centre + i] = start[centre + i] + (beyond > 0. ? (1. - law_.h) * beyond / distance * now[i] : 0.);
      return bounds;
    }


    YoshidaUemori::Moved YoshidaUemori::move_yield_surface(const double *start,
                                                           const Direction &n,
                                                           const Bounds &bounds,
                                                           const double x) const
    {
      // theta (1 + k/sqrt|theta|) = theta_n + x C a n = V with k = x C sqrt(a): |theta| = w^2, w^2 + k w = |V|
      const double a = law_.B + bounds.R - law_.Y, root = std::sqrt(a), k = x * law_.C * root;
      const Mandel V = sum(tensor(start), x * law_.C * a, n.value);
      const double v = std::sqrt(product(V, V));
      Moved moved{};
      if (!(v > 0.))
        return moved;
      const double w = 2. * v / (k + std::sqrt(k * k + 4. * v)), ratio = w / (w + k);
      for (unsigned int i = 0; i < 4; ++i)
        moved.value[i] = ratio * V[i];
      for (unsigned int j = 0; j < 5; ++j)
      {
        Mandel V_slope;
        for (unsigned int i = 0; i < 4; ++i)
          V_slope[i] = law_.C * (x * bounds.by[j] * n.value[i] +
                                 (j < 4 ? x * a * n.by_relative_stress[4 * i + j] : a * n.value[i]));
        const double v_slope = product(V, V_slope) / v;
        const double k_slope = law_.C * (x * bounds.by[j] / (2. * root) + (j < 4 ? 0. : root));
        const double w_slope = (v_slope - w * k_slope) / (2. * w + k);
        const double ratio_slope = (k * w_slope - w * k_slope) / ((w + k) * (w + k));
        for (unsigned int i = 0; i < 4; ++i)
          moved.by[j][i] = ratio * V_slope[i] + ratio_slope * V[i];
      }
      return moved;
    }


    BackStressEnd YoshidaUemori::update(const double *start,
                                        const Mandel &relative_stress,
                                        const YieldPoint &at,
                                        const double x,
                                        double *end) const
    {
      const Direction n(relative_stress, at);
      const Moved bounds_moved = move_bounds(start, n, x);
      const Bounds bounds = grow_bounds(start, bounds_moved, x, end);
      const Moved surface_moved = move_yield_surface(start, n, bounds, x);
      BackStressEnd result{};
      for (unsigned int i = 0; i < 4; ++i)
      {
        end[i] = surface_moved.value[i];
        end[beta + i] = bounds_moved.value[i];
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
