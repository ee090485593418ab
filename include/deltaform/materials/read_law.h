#pragma once

#include <deltaform/materials/elasticity.h>
#include <deltaform/materials/hardening.h>
#include <deltaform/materials/parameter_table.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

namespace deltaform
{
  /**
   * A law that is a value, from the section of a scene that has its parameters (Law::parameters()).
   * @throws SceneError
   */
  template <typename Law>
  Law read_law(Section &section)
  {
    Law law{};
    const ParameterTable<Law> &table = Law::parameters();
    for (const auto &parameter : table.parameters)
      law.*parameter.member = section.number(
        parameter.name, {parameter.value, parameter.required}, parameter.range, parameter.unit, parameter.sentence);
    for (const auto &condition : table.conditions)
      if (!condition.holds(law))
        section.fail(condition.parameter, condition.sentence);
    return law;
  }


  /// Hencky's elasticity. @throws SceneError
  inline Elasticity read_elasticity(Section &section)
  {
    const double poisson =
      section.number("Poisson's ratio", required(.3), Range::inside(-1., .5), "1", "Poisson's ratio.");
    const double young =
      section.number("Young's modulus", required(69004.), Range::positive(), "stress", "Young's modulus.");
    return {young, poisson};
  }


  /// The maker that registers a value as a hardening law.
  template <typename Law>
  std::unique_ptr<Hardening> hardening_from(Section &section)
  {
    return hardening_of(read_law<Law>(section));
  }
} // namespace deltaform
