#include <deltaform/materials/hardening.h>
#include <deltaform/materials/rate_factor.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <memory>
#include <utility>

namespace deltaform
{
  namespace
  {
    /**
     * Weighted sum of two laws: s(e) = w s1(e) + (1 - w) s2(e), 0 <= w <= 1, for example of one that goes on (Swift)
     * and one that saturates (Voce). A slope of one part that is infinite is that of the sum, if the part has a weight.
     */
    class HardeningSum final : public Hardening
    {
    public:
      HardeningSum(const double weight, std::unique_ptr<Hardening> first, std::unique_ptr<Hardening> second)
        : weight_(weight), first_(std::move(first)), second_(std::move(second))
      {
      }

      FlowStress evaluate(const double equivalent_plastic_strain) const override
      {
        FlowStress sum{0., 0.};
        for (const auto &[share, law] : {std::pair(weight_, first_.get()), std::pair(1. - weight_, second_.get())})
          if (share > 0.)
          {
            const FlowStress part = law->evaluate(equivalent_plastic_strain);
            sum.value += share * part.value;
            sum.slope += share * part.slope;
          }
        return sum;
      }

    private:
      double weight_;
      std::unique_ptr<Hardening> first_, second_;
    };


    std::unique_ptr<Hardening> make(Section &section)
    {
      const double weight =
        section.number("Weight", required(.5), Range::between(0., 1.), "1", "w of the first law; 1 - w of the second.");
      Section first = section.sub("First"), second = section.sub("Second");
      auto one = Registry<Hardening>::choose(first, "Law", "swift", "Law of the part with the weight w.");
      auto other = Registry<Hardening>::choose(second, "Law", "voce", "Law of the part with the weight 1 - w.");
      for (const auto &[part, law] : {std::pair(&first, one.get()), std::pair(&second, other.get())})
        if (law->own_rate_factor(0.))
          part->fail("Law", "a law that knows rate and temperature is no part of a sum.");
      return std::make_unique<HardeningSum>(weight, std::move(one), std::move(other));
    }

    const Registry<Hardening>::Entry entry("sum", "w s1(e) + (1 - w) s2(e)", make);
  } // namespace
} // namespace deltaform
