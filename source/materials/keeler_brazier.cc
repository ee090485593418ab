// The forming limit of low-carbon steels after Keeler and Brazier: thickness and hardening exponent. In true strains
//
//   FLC0 = (23.3 + 14.13 t) n/.21 [% of engineering strain], t in mm <= 3.1, n <= .21;   E0 = ln(1 + FLC0/100),
//   left of plane strain e1 = E0 - e2 (constant thinning), right of it e1 = E0 + e2 tan 20 degrees.
//
// S.P. Keeler, W.G. Brazier, Relationship between laboratory material characterization and press-shop formability,
// Proc. Microalloying 75 (1977) 517; the coefficients as they are commonly quoted.
#include <deltaform/materials/forming_limit.h>
#include <deltaform/parameters/section.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    std::unique_ptr<FormingLimit> read(Section &section, const Material &)
    {
      const double t = section.number("Sheet thickness", required(.8), Range::positive(), "mm",
                                      "In mm, whatever the units of the scene; more than 3.1 mm counts as 3.1 mm.");
      const double n = section.number("Hardening exponent", required(.21), Range::positive(), "1",
                                      "n of K e^n; more than .21 counts as .21.");
      const double percent = (23.3 + 14.13 * std::min(t, 3.1)) * std::min(n, .21) / .21;
      const double plane_strain = std::log1p(percent / 100.);
      constexpr double tan_20 = .36397023426620236;
      return std::make_unique<FormingLimit>(std::vector<FormingLimit::Point>{
        {-1., plane_strain + 1.}, {0., plane_strain}, {1.5 * plane_strain, plane_strain * (1. + 1.5 * tan_20)}});
    }

    const FormingLimits::Entry
      entry("keeler-brazier", "Low-carbon steels, from thickness and hardening exponent", read);
  } // namespace
} // namespace deltaform
