#include "chaboche.h"

#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

namespace deltaform
{
  namespace
  {
    std::unique_ptr<BackStress> make(Section &section)
    {
      const double C = section.number("Hardening modulus",
                                      required(2000.),
                                      Range::not_negative(),
                                      "stress",
                                      "C: slope of the backstress against the plastic strain in tension.");
      return std::make_unique<Chaboche>(std::vector<Chaboche::Term>{{C, 0.}});
    }

    const Registry<BackStress>::Entry entry("linear", "Linear kinematic hardening (Ziegler)", make);
  } // namespace
} // namespace deltaform
