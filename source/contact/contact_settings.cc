// Entries of section Contact.
#include <deltaform/contact/contact_settings.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

namespace deltaform
{
  namespace
  {
    /// In an expression of delta the word auto is -1: a negative value is that many times the estimate.
    std::map<std::string, double> with_automatic_delta(std::map<std::string, double> constants)
    {
      constants["auto"] = -1.;
      return constants;
    }
  } // namespace


  ContactSettings::ContactSettings(Section &section,
                                   const std::map<std::string, double> &constants,
                                   const std::string &natural_length)
    : normal_law(Registry<NormalLaw>::choose(section, "Enforcement", "penalty", "How gap >= 0 is imposed.")),
      rule(Registry<PenaltyRule>::choose(section, "Penalty rule", "adaptive", "Where the penalty factors come from.")),
      allowed_penetration(section.function("Allowed penetration",
                                           Default<std::string>("1e-3*" + natural_length),
                                           "length",
                                           "delta: how far a contact point may penetrate a tool; expression of t, "
                                           "thickness (of the blank) and edge (its shortest contact edge, of the first "
                                           "mesh). Default of a solid: 1e-3*edge. "
                                           "'auto': a twentieth of the estimated discretisation error of the contact.",
                                           with_automatic_delta(constants))),
      allowed_slip(
        section.function("Allowed elastic slip",
                         Default<std::string>("1e-3*" + natural_length),
                         "length",
                         "delta_t: how far a sticking point may slide elastically; sets the tangential "
                         "penalty factor mu lambda / delta_t. Default of a solid: 1e-3*edge.",
                         constants)),
      tangential_factor(section.number("Tangential factor",
                                       0.,
                                       Range::not_negative(),
                                       "force/length",
                                       "Constant tangential penalty factor; 0: from the allowed elastic slip.")),
      tangential_floor(section.number("Tangential floor factor",
                                      1e-3,
                                      Range::not_negative(),
                                      "1",
                                      "Lower bound of the tangential penalty factor over the nodal stiffness K_tt."))
  {
  }
} // namespace deltaform
