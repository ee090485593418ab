#pragma once
// What laws share whose force is that of a spring, lambda = shift - eps gap.
#include <deltaform/contact/normal_law.h>

namespace deltaform
{
  class SpringLaw : public NormalLaw
  {
  public:
    using NormalLaw::respond;
    NormalResponse respond(const ContactPointState &state, const NormalSituation &situation) const override;
    bool uses_penalty() const override;
    bool is_free_when_clear(const ContactPointState &state) const override;
    bool is_concerned(const ContactPointState &state) const override;
    bool foresee(const ContactPointState &state, double opening, double compliance) const override;
    double estimate(const ContactPointState &state, double opening, double share) const override;

  protected:
    /// Of a point that touches.
    static NormalResponse spring(const ContactPointState &state, double gap);

  private:
    /// Response at the gap that is left, with what the iteration forbids.
    NormalResponse decide(const ContactPointState &state, double left, const NormalSituation &situation) const;
  };
} // namespace deltaform
