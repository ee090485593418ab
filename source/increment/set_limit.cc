#include <deltaform/increment/set_limit.h>

#include <algorithm>
#include <utility>

namespace deltaform
{
  namespace
  {
    // doc/decisions/README.md, "Few sets or many"
    constexpr double sets_of_an_iteration = 4.; ///< what an iteration costs without its sets
    constexpr double worth_a_look = .6; ///< share of the effort
    constexpr unsigned int pause_after_change = 80, longest_pause = 640;
  } // namespace


  void SetLimit::met(const unsigned int sets, const bool ended)
  {
    sets_ += sets;
    if (!ended)
      vain_sets_ += sets;
  }


  void SetLimit::accept(const double length, const unsigned int iterations)
  {
    const double effort = sets_of_an_iteration * iterations + std::exchange(sets_, 0U);
    const double in_vain = std::exchange(vain_sets_, 0U);
    if (compares_)
      compare(length, effort);
    else
      wait(effort, in_vain);
  }


  void SetLimit::wait(const double effort, const double in_vain)
  {
    waited_.effort += effort;
    waited_.in_vain += in_vain;
    if (++count_ < pause_)
      return;
    // With few sets it is not known how many more there would be.
    compares_ = is_few_ || waited_.in_vain > worth_a_look * waited_.effort;
    if (!compares_)
      pause_ = first_pause;
    count_ = 0;
    waited_ = {};
  }


  void SetLimit::compare(const double length, const double effort)
  {
    const auto other_is_faster = comparison_.accept(length, effort);
    if (!other_is_faster)
      return;
    is_few_ = is_few_ != *other_is_faster;
    pause_ = *other_is_faster ? pause_after_change : std::min(2 * pause_, longest_pause);
    compares_ = false;
  }
} // namespace deltaform
