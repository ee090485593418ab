// Active set: gap = 0 where lambda > 0. The force of every contact point is an unknown; the semi-smooth Newton method
// chooses the set by the sign of lambda - c gap with c > 0. Where a point is tied its row is -gap - compliance lambda =
// 0, so that the matrix is symmetric without friction; elsewhere it is lambda = 0.
#include <deltaform/contact/contact_force.h>
#include <deltaform/contact/normal_law.h>
#include <deltaform/contact/point_rows.h>
#include <deltaform/parameters/registry.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    class ActiveSet : public NormalLaw
    {
    public:
      explicit ActiveSet(Section &)
      {
      }

      NormalResponse respond(const ContactPointState &state, const double gap, const double multiplier) const override
      {
        NormalResponse response;
        response.tied = multiplier - weight(state) * gap >= 0;
        response.touching = response.tied;
        response.force = response.tied ? multiplier : 0.;
        return response;
      }

      NormalResponse respond(const ContactPointState &state, const NormalSituation &situation) const override
      {
        NormalResponse response;
        if (std::isfinite(situation.gap))
        {
          // See SpringLaw: what touched is not lost for the error of the extrapolation.
          const bool held = situation.held && state.multiplier > 0;
          response = respond(state, held ? std::min(situation.gap, 0.) : situation.gap, state.multiplier);
        }
        response.compliance = situation.compliance;
        response.gap = response.touching ? situation.gap + situation.compliance * response.force : situation.gap;
        if (situation.share < 1)
          response.compliance += 1. / (situation.share * state.stiffness);
        return response;
      }

      bool uses_penalty() const override
      {
        return false;
      }

      bool is_free_when_clear(const ContactPointState &) const override
      {
        return false;
      }

      bool is_concerned(const ContactPointState &) const override
      {
        return true;
      }

      /// The step itself changes the force.
      double estimate(const ContactPointState &state, double, double) const override
      {
        return state.multiplier;
      }

      /// An exact constraint is to be exact: its residual is a length that the forces hardly notice.
      bool is_solution(const ContactPointState &state, const double allowed_tension, const bool final) const override
      {
        if (state.touching && final && std::abs(state.gap) > 1e-8 * state.thickness + state.tolerance())
          return false;
        return NormalLaw::is_solution(state, allowed_tension, final);
      }

      bool has_multiplier() const override
      {
        return true;
      }

      void start(const std::vector<ContactPointState> &points, const DofIndex first, Vector &q) const override
      {
        for (unsigned int i = 0; i < points.size(); ++i)
          q[first + i] = points[i].touching ? points[i].force : 0.;
      }

      void read_unknown(const Vector &q, const DofIndex own, ContactPointState &state) const override
      {
        state.multiplier = q[own];
      }

      bool acts(const NormalResponse &) const override
      {
        return true;
      }

      void join(PointRows &rows, const DofIndex own) const override
      {
        rows.append(own);
      }

      void add_equation(const NormalResponse &response,
                        const ContactPointState &state,
                        const double compliance,
                        const ContactForce &force,
                        PointRows &rows) const override
      {
        const double lambda = state.multiplier;
        if (response.tied)
          rows.add_equation(-state.gap - (response.compliance - compliance) * lambda,
                            -response.compliance,
                            -force.normal(),
                            force.by_multiplier());
        else
          rows.add_equation(lambda, 1.);
      }

      void close(const Vector &q, const DofIndex own, AssemblyTarget &target) const override
      {
        const double residual = q[own], one = 1.;
        target.add(&own, 1, target.wants_tangent() ? &one : nullptr, &residual);
      }
    };

    const Registry<NormalLaw>::Entry entry("active set",
                                           "gap = 0 exactly where the reaction is compressive; no penalty factor",
                                           &make_as<ActiveSet, NormalLaw>);
  } // namespace
} // namespace deltaform
