#include <deltaform/base/registry.h>
#include <deltaform/materials/back_stress.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace deltaform
{
  namespace
  {
    /// One term: initial modulus C in tension (stress) and rate gamma (1) at which it saturates, at C/gamma.
    struct Term
    {
      double C, gamma;
    };

    /**
     * Terms of Armstrong and Frederick, in Ziegler's form, which stays in plane stress with any yield surface:
     *
     *     alpha = sum alpha_i,   d alpha_i = (C_i/q) dev(xi) dx - gamma_i alpha_i dx,   xi = t - alpha,
     *
     * for Mises the same as 2/3 C_i de_p - gamma_i alpha_i dx. By backward Euler alpha_i = (alpha_i,n + C_i x/q
     * dev(xi)) / (1 + gamma_i x). The deviator, because a pressure within alpha would mean nothing. P.J. Armstrong,
     * C.O. Frederick, CEGB report RD/B/N 731 (1966); J.L. Chaboche, Time-independent constitutive theories for cyclic
     * plasticity, Int. J. Plasticity 2 (1986) 149; H. Ziegler, A modification of Prager's hardening rule, Q. Appl.
     * Math. 17 (1959) 55.
     */
    class Chaboche final : public BackStress
    {
    public:
      explicit Chaboche(std::vector<Term> terms)
        : terms_(std::move(terms))
      {
      }

      HistoryLayout history_layout() const override
      {
        HistoryLayout layout;
        for (std::size_t i = 0; i < terms_.size(); ++i)
          layout.append({{terms_.size() == 1 ? "backstress" : "backstress_" + std::to_string(i + 1),
                          HistoryKind::tensor,
                          "stress"}});
        return layout;
      }

      Mandel value(const double *history) const override
      {
        Mandel sum{};
        for (std::size_t i = 0; i < 4 * terms_.size(); ++i)
          sum[i % 4] += history[i];
        return sum;
      }

      BackStressEnd update(const double *start,
                           const Mandel &relative_stress,
                           const YieldPoint &at,
                           const double x,
                           double *end) const override
      {
        const Direction n(relative_stress, at);
        BackStressEnd result{};
        double stiffness = 0.; // of d alpha/d n
        for (const auto [C, gamma] : terms_)
        {
          const double scale = 1. / (1. + gamma * x);
          for (unsigned int i = 0; i < 4; ++i)
          {
            end[i] = scale * (start[i] + C * x * n.value[i]);
            result.value[i] += end[i];
            result.by_flow[i] += scale * (C * n.value[i] - gamma * end[i]);
          }
          stiffness += scale * C * x;
          start += 4;
          end += 4;
        }
        for (unsigned int k = 0; k < 16; ++k)
          result.by_relative_stress[k] = stiffness * n.by_relative_stress[k];
        return result;
      }

    private:
      std::vector<Term> terms_;
    };


    std::unique_ptr<BackStress> make_linear(Section &section)
    {
      const double C = section.number("Hardening modulus",
                                      required(2000.),
                                      Range::not_negative(),
                                      "stress",
                                      "C: slope of the backstress against the plastic strain in tension.");
      return std::make_unique<Chaboche>(std::vector<Term>{{C, 0.}});
    }


    std::unique_ptr<BackStress> make_chaboche(Section &section)
    {
      constexpr std::size_t most = 8;
      const std::string name = "Terms";
      std::vector<Term> terms;
      for (const auto &row : section.rows(name,
                                          required("20000 100; 500 0"),
                                          2,
                                          "stress, 1",
                                          "Rows of modulus C and rate gamma, up to 8: a term saturates at C/gamma."))
      {
        if (!(row[0] >= 0.))
          section.fail(name, "a modulus must not be negative.");
        if (!(row[1] >= 0.))
          section.fail(name, "a rate must not be negative: the backstress would grow without bounds.");
        terms.push_back({row[0], row[1]});
      }
      if (terms.empty() || terms.size() > most)
        section.fail(name, "must have one to " + std::to_string(most) + " rows.");
      return std::make_unique<Chaboche>(std::move(terms));
    }

    const Registry<BackStress>::Entry linear("linear", "Linear kinematic hardening (Ziegler)", make_linear);
    const Registry<BackStress>::Entry
      chaboche("chaboche", "Terms that saturate (Armstrong and Frederick)", make_chaboche);
  } // namespace
} // namespace deltaform
