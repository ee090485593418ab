#include <deltaform/assembly/stiffness_view.h>
#include <deltaform/increment/predictor.h>

#include <algorithm>
#include <utility>

namespace deltaform
{
  std::vector<Vector> Predictor::steps() const
  {
    std::vector<Vector> result;
    for (const Vector *const rate : {&rate_, &change_})
      if (rate->size() > 0)
      {
        result.push_back(*rate);
        result.back() *= rate == &rate_ ? length_ : length_ * length_;
      }
    return result;
  }


  void Predictor::renumber(std::vector<Vector> steps)
  {
    passage_ = Passage();
    continues_ = false;
    rate_ = change_ = Vector();
    if (!steps.empty())
      (rate_ = std::move(steps[0])) /= length_;
    if (steps.size() > 1)
      (change_ = std::move(steps[1])) /= length_ * length_;
  }


  void Predictor::accept(const Vector &before,
                         const Vector &now,
                         const double length,
                         const StiffnessView &tangent,
                         const ElementChain &chain)
  {
    passage_.accept(before, now, rate_.size() > 0 ? step(length) : Vector(now.size()), length, tangent, chain);
    Vector rate = now;
    rate -= before;
    rate /= length;
    if (rate_.size() > 0)
    {
      Vector change = rate;
      change -= rate_;
      change /= .5 * (length_ + length);
      if (change_.size() > 0)
        look_for_change(change, tangent);
      change_ = std::move(change);
    }
    rate_ = std::move(rate);
    length_ = length;
    continues_ = true;
  }


  void Predictor::look_for_change(const Vector &change, const StiffnessView &tangent)
  {
    constexpr double memory = .95, most = 2.; // of the last increment; a snap is no trend
    Vector force(change.size());
    tangent.multiply(change_, force);
    const double energy = change_ * force;
    if (!(energy > 0.)) // a blank that snaps
      return;
    found_ = memory * found_ + std::clamp(change * force / energy, -most, most);
    looks_ = memory * looks_ + 1.;
  }


  double Predictor::weight() const
  {
    constexpr double share = .5;
    return looks_ > 0. ? share * std::clamp(found_ / looks_, 0., 1.) : 0.;
  }


  Vector Predictor::step(const double length) const
  {
    Vector result = rate_;
    result *= length;
    if (change_.size() > 0)
      result.add(weight() * length * .5 * (length + length_), change_);
    return result;
  }


  void Predictor::predict(const double length, Vector &q, const ElementChain &chain) const
  {
    if (rate_.size() == 0)
      return;
    const Vector expected = step(length);
    q += passage_.step(expected, length, chain).value_or(expected);
  }
} // namespace deltaform
