#pragma once
// A shell or solid with pressure and one tool, without a scene: enough to see how Newton's method converges.
#include "../blanks/any_blank.h"
#include "../contact/fake_surface.h"
#include "convergence.h"

namespace deltaform
{
  namespace testing
  {
    class ShellProblem : public Equations, public ActiveSet
    {
    public:
      /// A flat disc or strip of radius 1, clamped at its edge. @p contact and @p tool: see InterfaceFixture; none: no
      /// contact
      ShellProblem(const Entries &blank_entries,
                   const Entries &contact,
                   const Entries &tool,
                   const std::string &kind = "shell")
        : blank(make_blank(kind,
                           Entries{"Blank/Points=0 0; 1 0",
                                   "Blank/Thickness=.05",
                                   "Blank/Elements=20",
                                   "Material/Young's modulus=2e3",
                                   "Material/Poisson's ratio=.3"} +
                             blank_entries))
      {
        n = blank->n_dofs();
        if (!tool.empty())
        {
          fixture = std::make_unique<InterfaceFixture>(blank->surface(), contact, tool);
          n = fixture->n;
        }
        const unsigned int n_border = fixture ? fixture->tool.force_driven() : 0;
        dealii::DynamicSparsityPattern pattern(n - n_border, n - n_border);
        blank->add_couplings(pattern);
        for (unsigned int i = 0; i < n - n_border; ++i)
          pattern.add(i, i);
        if (fixture && fixture->settings.normal_law->has_multiplier())
          for (unsigned int i = 0; i < fixture->contact.n_points(); ++i)
          {
            const ContactPoint node = fixture->contact.point(Vector(n), i);
            for (unsigned int k = 0; k < node.n_dofs; ++k)
            {
              pattern.add(node.dofs[k], blank->n_dofs() + i);
              pattern.add(blank->n_dofs() + i, node.dofs[k]);
            }
          }
        system = std::make_unique<System>(std::move(pattern), n_border, "klu");

        prescribed.assign(n, false);
        for (const auto dof : blank->fixed_dofs())
          prescribed[dof] = true;
        for (const auto component : {Component::r, Component::z, Component::rotation})
          for (const auto dof : blank->boundary().dofs("end", component))
            prescribed[dof] = true;
        if (!blank->axisymmetric())
          for (const auto component : {Component::r, Component::rotation})
            for (const auto dof : blank->boundary().dofs("start", component))
              prescribed[dof] = true;
        scale.assign(n, 1.);
        size.assign(n, 1.);
        for (unsigned int i = 0; i < blank->n_dofs(); ++i)
          scale[i] = blank->dof_scale(i);
        for (unsigned int i = blank->n_dofs(); i < n - n_border; ++i)
          scale[i] = 1. / blank->stiffness_scale();
        committed.reinit(n);
        if (fixture)
          fixture->contact.begin_stage(committed, 0.);
      }

      double typical_length() const override
      {
        return blank->initial_thickness();
      }

      Status assemble(const Vector &q, const bool tangent) override
      {
        system->clear(tangent);
        const Status status = blank->assemble(q, *system);
        if (!status.good())
          return status;
        if (fixture && factors_due)
        {
          fixture->contact.read_stiffness(q, *system);
          fixture->contact.predict_factors(q, nullptr);
          factors_due = false;
        }
        blank->boundary().assemble_pressure(q, blank->boundary().faces().front(), pressure, true, *system);
        if (fixture)
          fixture->contact.assemble(q, *system);
        return status;
      }

      double limit_step(const Vector &q, Vector &d) const override
      {
        return blank->admissible_step(q, d);
      }

      ActiveSet *active_set() override
      {
        return fixture ? this : nullptr;
      }

      std::size_t signature() const override
      {
        return 0;
      }

      void prepare_step(const Vector &d) override
      {
        if (fixture)
          fixture->contact.prepare_step(d);
      }

      void advance(const double factor) override
      {
        if (fixture)
          fixture->contact.advance(factor);
      }

      bool changed() const override
      {
        return fixture && fixture->contact.status_changed();
      }

      unsigned int patience() const override
      {
        return 2;
      }

      bool consistent(const double allowed_tension) const override
      {
        return !fixture || fixture->contact.consistent(allowed_tension);
      }

      unsigned int correct(const Vector &q) override
      {
        return fixture ? fixture->contact.correct_factors(q) : 0;
      }

      /**
       * Solve the increment that ends at @p time under @p new_pressure and commit it; if that fails, once more with
       * soft contact, and then in two halves.
       */
      NewtonResult increment(const double time, const double new_pressure, const unsigned int depth = 0)
      {
        const double time_before = last_time, pressure_before = pressure;
        const NewtonSettings settings = newton_settings({"Force tolerance=1e-12", "Maximal iterations=40"});
        Timers timers;
        Newton newton(*this, *system, settings, scale, size, timers);
        NewtonResult result;
        Vector q;
        for (const double share : {1., .03})
        {
          if (share < 1. && (!fixture || result.converged()))
            break;
          pressure = new_pressure;
          factors_due = true;
          if (fixture)
          {
            fixture->contact.begin_increment(committed, time);
            fixture->contact.soften(share);
          }
          q = committed;
          result = newton.solve(q, committed, prescribed, committed, 0.);
        }
        if (!result.converged())
        {
          BOOST_TEST_REQUIRE(depth < 5u,
                             "at time " << time << " (" << static_cast<int>(result.outcome)
                                        << "):" << listed_residuals(result.residuals));
          pressure = pressure_before;
          increment(.5 * (time_before + time), .5 * (pressure_before + new_pressure), depth + 1);
          return increment(time, new_pressure, depth + 1);
        }
        if (fixture)
          fixture->contact.commit(q);
        blank->commit(q);
        committed = q;
        last_time = time;
        return result;
      }

      unsigned int n;
      std::unique_ptr<Blank> blank;
      std::unique_ptr<InterfaceFixture> fixture;
      std::unique_ptr<System> system;
      std::vector<bool> prescribed;
      std::vector<double> scale, size;
      Vector committed;
      double pressure = 0., last_time = 0.;
      bool factors_due = true;
    };

    const Entries yielding{"Material/Model=elastoplastic",
                           "Material/Hardening/Law=linear",
                           "Material/Hardening/Initial flow stress=20",
                           "Material/Hardening/Hardening modulus=100"};
    const Entries punch{"Shape=hemispherical punch",
                        "Radius=.5",
                        "Side=bottom",
                        "Position z=-.025",
                        "Friction coefficient=.05",
                        "Motion=t"};

    /// Call @p body with the entries of a blank of either degree and symmetry.
    inline void for_all_variants(const Entries &more, const std::function<void(const Entries &)> &body)
    {
      for (const std::string degree : {"1", "2"})
        for (const std::string symmetry : {"axisymmetric", "plane strain"})
          BOOST_TEST_CONTEXT("degree " << degree << ", " << symmetry)
      body(Entries{"Blank/Degree=" + degree, "Blank/Symmetry=" + symmetry} + more);
    }

    inline void check_order(const NewtonResult &result)
    {
      const double order = observed_order(result.residuals, 1e-14);
      BOOST_TEST_MESSAGE("order " << order << ":" << listed_residuals(result.residuals));
      BOOST_TEST(order >= 1.8, listed_residuals(result.residuals));
    }
  } // namespace testing
} // namespace deltaform
