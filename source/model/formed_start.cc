#include <deltaform/assembly/collector.h>
#include <deltaform/model/formed_start.h>
#include <deltaform/parameters/text.h>
#include <deltaform/process/ranks.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace deltaform
{
  namespace
  {
    // Of the forces in the cells: so much is out of balance in a state that was accepted.
    constexpr double tolerance_of_equilibrium = 1e-4;

    /// What the cells add to the residual, without regard to its sign.
    class Magnitude : public Collector
    {
    public:
      using Collector::Collector;

      void add(const DofIndex *dofs, const unsigned int n, const double *, const double *vector) override
      {
        for (unsigned int i = 0; i < n; ++i)
          residual[dofs[i]] += std::abs(vector[i]);
      }
    };
  } // namespace


  void FormedStart::begin(const TakenOver &taken)
  {
    std::copy(taken.unknowns.begin(), taken.unknowns.end(), state_.unknowns.begin());
    held_ = taken.held;
    due_ = true;
    begin_accounts();
  }


  void FormedStart::begin_accounts()
  {
    const BlankEnergy energy = actors_.blank->energy();
    state_.work = ModelState().work;
    state_.work.loads = energy.elastic - energy.normal;
    state_.work.dissipated_before = energy.plastic;
  }


  void FormedStart::enter(const Stage &stage, const ForceBook &book)
  {
    if (!std::exchange(due_, false))
      return;
    book.release_formed(body_, stage, state_);
    Magnitude inside(state_.unknowns.size());
    body_.assemble(state_.unknowns, state_.time, inside);
    if (actors_.blank->may_be_distributed())
      ranks::sum(inside.residual.begin(), inside.residual.size());
    in_cells_ = norm(inside.residual);
    // What is left of a blank that was released is the tolerance of its equilibrium.
    ReleasedForces &released = state_.released;
    released.any = norm(released.on_blank) > tolerance_of_equilibrium * in_cells_;
    state_.releases_at_once = released.any && stage.release_at_once;
    fade(released.any ? Vector(released.on_blank) : Vector(released.on_blank.size()));
  }


  double FormedStart::norm(const Vector &forces) const
  {
    double square = 0.;
    for (DofIndex i = 0; i < numbering_.n_blank; ++i)
      square += std::pow(forces[i] / numbering_.scale[i], 2);
    return std::sqrt(square);
  }


  void FormedStart::fade(const Vector &forces)
  {
    state_.released.on_blank = forces;
    state_.released.of_earlier_operation = numbering_.resultant(forces);
    for (unsigned int i = 0; i < numbering_.n_blank; ++i)
      state_.load_forces[i] = forces[i];
  }


  bool FormedStart::drop_transfer_error()
  {
    ReleasedForces &released = state_.released;
    if (!released.any)
      return false;
    missing_ = released.on_blank;
    Vector error(missing_), kept(missing_);
    for (DofIndex i = 0; i < numbering_.n_blank; ++i)
    {
      if (supports_.is_prescribed()[i])
        continue; // a support of this stage holds it
      error[i] -= held_ ? (*held_)[i] : 0.;
      if (held_)
        kept[i] = (*held_)[i];
    }
    fade(kept);
    share_ = in_cells_ > 0. ? norm(error) / in_cells_ : 0.;
    return held_ && norm(error) > 0.;
  }


  std::string FormedStart::left_over() const
  {
    if (held_ || share_ == 0.)
      return "";
    return "the blank begins with " + text::rounded(100. * share_) +
           " % of the forces in its cells out of balance: what held it in the earlier operation and, if that was on "
           "another mesh, the error of the transfer; they " +
           (state_.releases_at_once ? "are gone at once" : "fade out over the stage");
  }


  std::string FormedStart::end(const std::string &why)
  {
    const std::string error = "the blank begins on another mesh than that on which it was formed, where " +
                              text::rounded(100. * share_) + " % of the forces in its cells do not balance";
    if (!why.empty())
    {
      fade(missing_);
      return error + "; they fade out over the stage, as without them there is no equilibrium: " + why;
    }
    const double before = state_.work.loads;
    begin_accounts();
    return error + ". Equilibrium is regained; the elastic energy goes from " +
           text::format(before) + " to " + text::format(state_.work.loads);
  }
} // namespace deltaform
