#include "chaboche.h"

#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <string>
#include <utility>

namespace deltaform
{
  Chaboche::Chaboche(std::vector<Term> terms)
    : terms_(std::move(terms))
  {
  }


  HistoryLayout Chaboche::history_layout() const
  {
    HistoryLayout layout;
    for (std::size_t i = 0; i < terms_.size(); ++i)
      layout.append({{terms_.size() == 1 ? "backstress" : "backstress_" + std::to_string(i + 1),
                      HistoryKind::tensor,
                      "stress"}});
    return layout;
  }


  Mandel Chaboche::value(const double *history) const
  {
    Mandel sum{};
    for (std::size_t i = 0; i < 4 * terms_.size(); ++i)
      sum[i % 4] += history[i];
    return sum;
  }


  BackStressEnd Chaboche::update(const BackStressStart &from,
                                 const Mandel &relative_stress,
                                 const YieldPoint &at,
                                 const double x,
                                 double *end) const
  {
    const Direction n(relative_stress, at);
    const double *start = from.values;
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


  namespace
  {
    std::unique_ptr<BackStress> make(Section &section)
    {
      constexpr std::size_t most = 8;
      const std::string name = "Terms";
      std::vector<Chaboche::Term> terms;
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

    const Registry<BackStress>::Entry entry("chaboche", "Terms that saturate (Armstrong and Frederick)", make);
  } // namespace
} // namespace deltaform
