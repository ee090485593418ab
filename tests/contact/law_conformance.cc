// What every registered enforcement, penalty rule and friction law has to fulfil, whatever it is called.
#include "../conformance.h"

#include <deltaform/contact/friction_law.h>
#include <deltaform/contact/normal_law.h>
#include <deltaform/contact/penalty_rule.h>
#include <deltaform/parameters/section.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  template <typename T>
  Entries documented(const std::string &name)
  {
    return documented_entries([&](ParameterTree &tree) {
      Section section = tree.root();
      Registry<T>::make(name, section);
    });
  }

  template <typename T>
  std::unique_ptr<T> make_of(const std::string &name, Entries entries, const Entries &overrides)
  {
    entries.insert(entries.end(), overrides.begin(), overrides.end());
    ParameterTree tree = ParameterTree::parse("", "test", entries);
    Section section = tree.root();
    return Registry<T>::make(name, section);
  }

  template <typename T>
  std::unique_ptr<T> make(const std::string &name, const Entries &overrides = {})
  {
    return make_of<T>(name, documented<T>(name), overrides);
  }

  template <typename T, typename Body>
  void for_all(const Entries &overrides, const Body &body)
  {
    BOOST_TEST_REQUIRE(!Registry<T>::names().empty());
    for (const auto &name : Registry<T>::names())
      BOOST_TEST_CONTEXT("'" << name << "'")
      {
        const auto make_law = [&](const Entries &entries) { return make_of<T>(name, entries, overrides); };
        with_two_sets(documented<T>(name), make_law, [&](const Entries &entries) { body(*make_law(entries)); });
      }
  }

  struct Random
  {
    std::mt19937 generator{7};

    double uniform(const double a, const double b)
    {
      return std::uniform_real_distribution<double>(a, b)(generator);
    }

    /// Over many orders of magnitude.
    double positive(const double smallest, const double largest)
    {
      return std::exp(uniform(std::log(smallest), std::log(largest)));
    }
  };

  ContactPointState random_point(Random &random)
  {
    ContactPointState state;
    state.stiffness = random.positive(1., 1e6);
    state.penalty_factor = random.positive(1e-3, 1e3) * state.stiffness;
    return state;
  }

  PenaltyInput random_input(Random &random)
  {
    PenaltyInput input;
    input.stiffness = random.positive(1e-2, 1e7);
    input.delta = random.positive(1e-9, 1e-2);
    input.area = random.positive(1e-6, 10.);
    input.previous_factor = random.positive(1e-3, 1e6) * input.stiffness;
    input.penetration = random.uniform(0., 1.) < .2 ? 0. : random.positive(1e-3, 1e3) * input.delta;
    input.force = input.previous_factor * input.penetration;
    input.thickness = random.positive(1e-3, 10.);
    input.modulus = random.positive(1., 1e6);
    input.previous_penetration = random.uniform(0., 1.) < .3 ? 0. : random.positive(.1, 10.) * input.penetration;
    input.coupling = random.uniform(-3., 3.) * input.stiffness * input.delta;
    input.shares_unknowns = random.uniform(0., 1.) < .5;
    input.neighbour = random.uniform(0., 1.) < .5 ? 0. : random.positive(1e-3, 1e6) * input.stiffness;
    return input;
  }

  /// Coulomb's coefficient is zero unless it is given.
  const std::vector<std::string> rough = {"Friction coefficient=.3"};

  FrictionInput random_friction(Random &random)
  {
    FrictionInput input;
    input.normal_force = random.positive(.1, 10.);
    input.stiffness = random.positive(1., 1e4);
    input.area = random.positive(.1, 10.);
    input.flow_stress = random.positive(.1, 10.);
    return input;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(law_conformance)

BOOST_AUTO_TEST_CASE(enforcement_complementarity)
{
  for_all<NormalLaw>(
    {},
    [](const NormalLaw &enforcement) {
      Random random;
      for (unsigned int k = 0; k < 1000; ++k)
      {
        const ContactPointState state = random_point(random);
        const double g = random.positive(1e-9, 1e-1);
        // Apart, and no force: no contact, whatever the distance.
        const NormalResponse apart = enforcement.respond(state, g, 0.);
        BOOST_TEST_REQUIRE((!apart.touching && !apart.tied && apart.force == 0. && apart.derivative == 0.));
        // Inside the tool or just touching: contact.
        BOOST_TEST_REQUIRE(enforcement.respond(state, -g, 0.).touching);
        BOOST_TEST_REQUIRE(enforcement.respond(state, 0., 0.).touching);
        // A reaction keeps the contact although a step has opened the gap a little; in the end the gap wins.
        const double lambda = random.positive(1e-3, 1e3) * state.stiffness;
        BOOST_TEST_REQUIRE(enforcement.respond(state, .99 * lambda / NormalLaw::weight(state), lambda).touching);
        BOOST_TEST_REQUIRE(!enforcement.respond(state, 1.01 * lambda / NormalLaw::weight(state), lambda).touching);
        BOOST_TEST_REQUIRE(enforcement.respond(state, -g, lambda).touching);
        // No compliance but in the continuation, and only unknowns of their own are tied.
        const NormalResponse inside = enforcement.respond(state, -g, lambda);
        BOOST_TEST_REQUIRE(inside.compliance == 0.);
        BOOST_TEST_REQUIRE(inside.tied == enforcement.has_multiplier());
        BOOST_TEST_REQUIRE(inside.force > 0.);
        if (enforcement.has_multiplier())
          BOOST_TEST_REQUIRE((inside.force == lambda && inside.derivative == 0.));
      }
    });
}

BOOST_AUTO_TEST_CASE(enforcement_derivative)
{
  for_all<NormalLaw>({},
                     [](const NormalLaw &enforcement) {
                       Random random;
                       for (unsigned int k = 0; k < 1000; ++k)
                       {
                         const ContactPointState state = random_point(random);
                         const double gap = random.uniform(-1e-2, 1e-2), h = 1e-7;
                         const double lambda = random.uniform(-1., 1.) * state.stiffness;
                         const auto at = [&](const double g) { return enforcement.respond(state, g, lambda); };
                         BOOST_TEST_REQUIRE(at(gap).derivative <= 0.);
                         if (at(gap - h).touching == at(gap + h).touching)
                           require_close(at(gap).derivative, (at(gap + h).force - at(gap - h).force) / (2. * h),
                                         1e-6 * state.penalty_factor, "the derivative, by differences,");
                         BOOST_TEST_REQUIRE((at(gap).touching || at(gap).force == 0.));
                       }
                     });
}

BOOST_AUTO_TEST_CASE(penalty_factors_are_positive_and_finite)
{
  for_all<PenaltyRule>({},
                       [](const PenaltyRule &rule) {
                         Random random;
                         for (unsigned int k = 0; k < 5000; ++k)
                         {
                           const PenaltyInput input = random_input(random);
                           const auto usable = [](const double factor) { return factor > 0. && std::isfinite(factor); };
                           BOOST_TEST_REQUIRE(usable(rule.predict(input)));
                           BOOST_TEST_REQUIRE(usable(rule.correct(input)));
                           PenaltyInput first = input;
                           first.force = 0.;
                           first.previous_factor = 0.;
                           first.penetration = 0.;
                           first.coupling = 0.;
                           BOOST_TEST_REQUIRE(usable(rule.predict(first)));
                           BOOST_TEST_REQUIRE(rule.floor(input) >= 0.);
                           // A pure function
                           BOOST_TEST_REQUIRE(rule.predict(input) == rule.predict(input));
                         }
                       });
}

BOOST_AUTO_TEST_CASE(a_promise_is_kept_by_corrections)
{
  // A spring k against a point, pressed by a given way: p = k w / (k + eps). Corrections must end with p <= delta if
  // the rule promises that, raise the factor only, and leave alone what is fine.
  for_all<PenaltyRule>({},
                       [](const PenaltyRule &rule) {
                         if (!rule.promises())
                           return;
                         Random random;
                         for (unsigned int k = 0; k < 500; ++k)
                         {
                           const double spring = random.positive(1., 1e5), way = random.positive(1e-4, 1.);
                           PenaltyInput input = random_input(random); // every field has a value
                           input.stiffness = random.positive(.1, 10.) * spring;
                           input.modulus = random.positive(.1, 10.) * spring * input.thickness / input.area;
                           input.delta = random.positive(1e-6, 2.) * way;
                           input.force = input.penetration = input.previous_penetration = input.coupling = 0.;
                           input.neighbour = 0.;
                           input.previous_factor = 0.; // a first touch
                           input.previous_factor = rule.predict(input);
                           unsigned int round = 0;
                           for (; round < 40; ++round)
                           {
                             input.penetration = spring * way / (spring + input.previous_factor);
                             input.force = input.previous_factor * input.penetration;
                             const double factor = rule.correct(input);
                             BOOST_TEST_REQUIRE(factor >= input.previous_factor);
                             if (input.penetration <= input.delta)
                             {
                               BOOST_TEST_REQUIRE(factor == input.previous_factor);
                               break;
                             }
                             BOOST_TEST_REQUIRE(factor > input.previous_factor);
                             input.previous_factor = factor;
                             input.previous_penetration = input.penetration;
                           }
                           BOOST_TEST_REQUIRE(round < 30u);
                           BOOST_TEST_REQUIRE(input.penetration <= input.delta);
                         }
                       });
}

BOOST_AUTO_TEST_CASE(predictions_keep_a_promise_at_constant_reaction)
{
  // Repeated predictions settle, from wherever they start, and there the promise is kept.
  for_all<PenaltyRule>({},
                       [](const PenaltyRule &rule) {
                         if (!rule.promises())
                           return;
                         Random random;
                         for (unsigned int k = 0; k < 200; ++k)
                         {
                           PenaltyInput input = random_input(random);
                           input.force = random.positive(1e-3, 1e3);
                           double change = 1.;
                           for (unsigned int round = 0; round < 40 && change > 1e-12; ++round)
                           {
                             input.penetration = input.force / input.previous_factor;
                             const double factor = rule.predict(input);
                             change = std::abs(factor / input.previous_factor - 1.);
                             input.previous_penetration = input.penetration;
                             input.previous_factor = factor;
                           }
                           BOOST_TEST_REQUIRE(change <= 1e-12);
                           BOOST_TEST_REQUIRE(input.force / input.previous_factor <= input.delta * (1. + 1e-12));
                         }
                       });
}

BOOST_AUTO_TEST_CASE(the_adaptive_rule_settles_at_its_aim)
{
  // With a floor that does not matter, at constant reaction: from below, every prediction comes nearer to the one
  // factor at which the penetration is the aim's share of delta (eqn (7) in its exact form). From above too, if the
  // point is a node; else they come down to four times that factor, and leave alone what is less.
  for (const double kappa : {1., 4.})
    for (const double aim : {.5, .8, .95})
    {
      const auto rule = make<PenaltyRule>("adaptive", {"Floor factor=1e-12", "Aim=" + std::to_string(aim)});
      Random random;
      for (unsigned int k = 0; k < 200; ++k)
      {
        PenaltyInput input = random_input(random);
        input.force = random.positive(1e-3, 1e3);
        input.shares_unknowns = kappa > 1.;
        const double aimed_at = input.force / (aim * input.delta);
        const double goal = std::clamp(input.previous_factor, aimed_at, kappa * aimed_at);
        double last = std::abs(std::log(input.previous_factor / goal));
        for (unsigned int round = 0; round < 30 && last > 1e-12; ++round)
        {
          input.penetration = input.force / input.previous_factor;
          input.previous_factor = rule->predict(input);
          const double now = std::abs(std::log(input.previous_factor / goal));
          BOOST_TEST_REQUIRE(now < last);
          last = now;
        }
        require_close(input.previous_factor / goal, 1., 1e-11, "factor over the one at which it settles");
      }
    }
}

BOOST_AUTO_TEST_CASE(a_force_that_moves_from_point_to_point_finds_the_same_springs)
{
  // Two points share a force, and it goes over from one to the other and back, in steps. Once the factors have come
  // down to where they serve both ends, the penetrations tell where the force is, as those of constant springs do.
  const auto rule = make<PenaltyRule>("adaptive", {"Floor factor=1e-12"});
  Random random;
  std::array<PenaltyInput, 2> points;
  points.fill(random_input(random));
  for (PenaltyInput &point : points)
    point.shares_unknowns = true;
  const double force = 1.;
  std::array<std::vector<double>, 2> penetrations;
  for (const double share : {.7, .5, .3, .5, .7, .5, .3, .5, .7, .5, .3})
    for (const unsigned int i : {0U, 1U})
    {
      PenaltyInput &point = points[i];
      point.force = force * (i == 0 ? share : 1. - share);
      // Many increments at every place, as each changes a factor by no more than its largest change.
      for (unsigned int increment = 0; increment < 20; ++increment)
        point.previous_factor = rule->predict(point);
      penetrations[i].push_back(point.force / point.previous_factor / point.delta);
    }
  for (const unsigned int i : {0U, 1U})
  {
    for (unsigned int k = 7; k < penetrations[i].size(); ++k)
      require_close(penetrations[i][k], penetrations[i][k - 4], 1e-12, "the second time as the first");
    // From the second turn on: in proportion to the force.
    require_close(penetrations[i][6] / penetrations[i][4], i == 0 ? 3. / 7. : 7. / 3., 1e-12, "with the force");
  }
}

BOOST_AUTO_TEST_CASE(floors_bound_the_factor)
{
  for_all<PenaltyRule>({},
                       [](const PenaltyRule &rule) {
                         Random random;
                         for (unsigned int k = 0; k < 1000; ++k)
                         {
                           PenaltyInput input = random_input(random);
                           input.previous_factor = std::max(input.previous_factor, rule.floor(input));
                           BOOST_TEST_REQUIRE(rule.predict(input) >= rule.floor(input) * (1. - 1e-14));
                         }
                       });
}

BOOST_AUTO_TEST_CASE(rules_without_a_promise_end_their_corrections)
{
  // A spring k against a point again: 'constant' stops at its goal, 'paper' and 'element stiffness' at once, the
  // others where the penetration is near delta; within the rounds that a solve allows.
  for (const std::string kind : {"per node", "per area"})
    for_all<PenaltyRule>({"Penalty factor=3e5", "Penalty factor is=" + kind},
                         [](const PenaltyRule &rule) {
                           if (rule.promises())
                             return;
                           Random random;
                           for (unsigned int k = 0; k < 500; ++k)
                           {
                             const double spring = random.positive(1., 1e5), way = random.positive(1e-4, 1.);
                             PenaltyInput input = random_input(random);
                             input.stiffness = random.positive(.1, 10.) * spring;
                             input.delta = random.positive(1e-6, 2.) * way;
                             input.force = input.previous_factor = input.previous_penetration = 0.;
                             input.previous_factor = rule.predict(input);
                             unsigned int round = 0;
                             for (; round < 60; ++round)
                             {
                               input.penetration = spring * way / (spring + input.previous_factor);
                               const double factor = rule.correct(input);
                               if (factor == input.previous_factor)
                                 break;
                               BOOST_TEST_REQUIRE(factor > input.previous_factor);
                               input.previous_factor = factor;
                               input.previous_penetration = input.penetration;
                             }
                             BOOST_TEST_REQUIRE(round < 20u);
                           }
                         });
}

BOOST_AUTO_TEST_CASE(the_constant_rule)
{
  Random random;
  for (unsigned int k = 0; k < 200; ++k)
  {
    const PenaltyInput input = random_input(random);
    const auto by_node = make<PenaltyRule>("constant", {"Penalty factor=3e5"});
    const auto by_area = make<PenaltyRule>("constant", {"Penalty factor=3e5", "Penalty factor is=per area"});
    BOOST_TEST_REQUIRE(by_node->predict(input) == 3e5);
    BOOST_TEST_REQUIRE(by_area->predict(input) == 3e5 * input.area);
  }
}

BOOST_AUTO_TEST_CASE(the_printed_rule)
{
  // eps delta = lambda + coupling, with all safeguards off, even where it turns negative; with them on, the previous
  // factor.
  const auto printed = make<PenaltyRule>("paper", {"Paper clamp=false", "Paper floor=0", "Paper cap=0"});
  const auto guarded = make<PenaltyRule>("paper");
  Random random;
  unsigned int negative = 0;
  for (unsigned int k = 0; k < 200; ++k)
  {
    const PenaltyInput input = random_input(random);
    const double exact = (input.force + input.coupling) / input.delta;
    BOOST_TEST_REQUIRE(printed->predict(input) == exact);
    negative += exact < 0.;
    if (exact < 0.)
      BOOST_TEST_REQUIRE(guarded->predict(input) ==
                         std::clamp(input.previous_factor, 1e-2 * input.stiffness, 1e6 * input.stiffness));
  }
  BOOST_TEST_REQUIRE(negative > 10u);
  BOOST_TEST_REQUIRE(printed->needs_coupling());
}

BOOST_AUTO_TEST_CASE(limits_of_friction)
{
  for_all<FrictionLaw>(rough, [](const FrictionLaw &law) {
    Random random;
    bool any = false;
    for (unsigned int k = 0; k < 1000; ++k)
    {
      const FrictionInput input = random_friction(random);
      const FrictionLimit limit = law.limit(input);
      any |= limit.value > 0.;
      BOOST_TEST_REQUIRE((limit.value >= 0. && limit.rate >= 0. && std::isfinite(limit.value)));
      // The limit's rate, where both sides are on the same branch.
      FrictionInput less = input, more = input;
      const double h = 1e-6 * input.normal_force;
      less.normal_force -= h;
      more.normal_force += h;
      const FrictionLimit a = law.limit(less), b = law.limit(more);
      if (a.rate == b.rate)
        require_close(limit.rate, (b.value - a.value) / (2. * h), 1e-6, "the rate of the limit, by differences,");
      // The limit does not change with the way to this increment, nor with what the law does not ask for. All may ask
      // for the area: it makes a pressure of the force.
      FrictionInput other = random_friction(random);
      other.normal_force = input.normal_force;
      other.area = input.area;
      other.flow_stress =
        law.needs_flow_stress() ? input.flow_stress : std::numeric_limits<double>::infinity();
      BOOST_TEST_REQUIRE(law.limit(other).value == limit.value);
      // A law that knows no stress of the blank has nothing but the pressure to slide against.
      other.normal_force = 0.;
      BOOST_TEST_REQUIRE((law.needs_flow_stress() || law.limit(other).value == 0.));
    }
    BOOST_TEST_REQUIRE(law.acts() == any);
  });
}

BOOST_AUTO_TEST_CASE(friction_within_its_limit)
{
  for_all<FrictionLaw>(rough, [](const FrictionLaw &law) {
    Random random;
    for (unsigned int path = 0; path < 50; ++path)
    {
      FrictionInput input = random_friction(random);
      input.committed = 0.;
      double dissipated = 0.;
      for (unsigned int k = 0; k < 200; ++k)
      {
        input.normal_force = random.uniform(0., 1.) < .1 ? 0. : random.positive(1e-3, 10.);
        input.slip_increment = random.uniform(-2., 2.) * input.normal_force / input.stiffness;
        const FrictionResponse now = law.update(input);
        const double limit = law.limit(input).value, t = input.committed, slip = input.slip_increment;
        BOOST_TEST_REQUIRE(std::abs(now.force) <= limit * (1. + 1e-14));
        BOOST_TEST_REQUIRE((now.sticking || std::abs(now.force) >= limit * (1. - 1e-14)));
        // What does not go into the spring is dissipated, never gained (backward Euler: force at the end).
        const double size = std::abs(slip) + std::abs(t) / input.stiffness; // whose round-off the difference has
        const double irreversible = slip - (now.force - t) / input.stiffness;
        BOOST_TEST_REQUIRE(now.force * irreversible >= -1e-14 * std::abs(now.force) * size);
        BOOST_TEST_REQUIRE((!now.sticking || std::abs(irreversible) <= 1e-12 * size));
        dissipated += now.force * irreversible;
        input.committed = now.force;
      }
      BOOST_TEST_REQUIRE((law.acts() ? dissipated > 0. : dissipated == 0.));
    }
  });
}

BOOST_AUTO_TEST_CASE(friction_derivatives)
{
  for_all<FrictionLaw>(rough, [](const FrictionLaw &law) {
    Random random;
    unsigned int sliding = 0, sticking = 0;
    for (unsigned int k = 0; k < 2000; ++k)
    {
      FrictionInput input = random_friction(random);
      const double limit = law.limit(input).value, lambda = input.normal_force, stiffness = input.stiffness;
      input.committed = random.uniform(-1., 1.) * limit;
      input.slip_increment = random.uniform(-2., 2.) * limit / stiffness;
      const double h_slip = 1e-6 * lambda / stiffness, h_lambda = 1e-6 * lambda;
      const auto at = [&](const double l, const double s) {
        FrictionInput near = input;
        near.normal_force = l;
        near.slip_increment = s;
        return law.update(near);
      };
      const double slip = input.slip_increment;
      const auto a = at(lambda, slip - h_slip), b = at(lambda, slip + h_slip);
      const auto c = at(lambda - h_lambda, slip), d = at(lambda + h_lambda, slip), now = at(lambda, slip);
      // No derivative where it starts to slide, or where another limit takes over and the rate jumps.
      if (a.sticking != now.sticking || b.sticking != now.sticking || c.sticking != d.sticking ||
          std::abs(c.force_rate - d.force_rate) > 1e-4)
        continue;
      (now.sticking ? sticking : sliding)++;
      require_close(now.slip_rate, (b.force - a.force) / (2. * h_slip), 1e-6 * stiffness,
                    "the derivative by the slip, by differences,");
      require_close(now.force_rate, (d.force - c.force) / (2. * h_lambda), 1e-6,
                    "the derivative by the normal force, by differences,");
    }
    BOOST_TEST_REQUIRE((!law.acts() || (sliding > 100u && sticking > 100u)));
  });
}

BOOST_AUTO_TEST_CASE(friction_knows_no_preferred_direction)
{
  for_all<FrictionLaw>(rough, [](const FrictionLaw &law) {
    Random random;
    for (unsigned int k = 0; k < 500; ++k)
    {
      FrictionInput input = random_friction(random);
      input.committed = random.uniform(-1., 1.);
      input.slip_increment = random.uniform(-5., 5.) / input.stiffness;
      FrictionInput turned = input;
      turned.committed *= -1.;
      turned.slip_increment *= -1.;
      const auto one = law.update(input), other = law.update(turned);
      BOOST_TEST_REQUIRE(one.force == -other.force);
      BOOST_TEST_REQUIRE(one.slip_rate == other.slip_rate);
      BOOST_TEST_REQUIRE(one.force_rate == -other.force_rate);
    }
  });
}

BOOST_AUTO_TEST_SUITE_END()
