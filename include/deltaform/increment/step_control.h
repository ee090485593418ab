#pragma once

#include <deltaform/increment/effort.h>
#include <deltaform/increment/failed_length.h>
#include <deltaform/increment/target_search.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace deltaform
{
  class Section;

  /// Entries of the step control.
  struct StepSettings
  {
    /// @param target iterations aimed at by default
    explicit StepSettings(Section &section, unsigned int target = 5);

    unsigned int target_iterations;
    double growth, shrink;
    double largest_strain, largest_rotation;
    unsigned int max_increments;
    double flow_error; ///< 0: not controlled
    bool extrapolate;
  };

  /**
   * Size of the next increment of a stage: aims at a number of Newton iterations and, if asked, at an error of the
   * integration of flow (the smaller size of the two); is cut after a failure, grows again, and meets the times at
   * which results are asked for exactly.
   *
   * The error is of first order in the increment. Its control is proportional-integral, which damps the noise that
   * contact makes: K. Gustafsson, M. Lundh, G. Soederlind, A PI stepsize control for the numerical solution of ordinary
   * differential equations, BIT 28 (1988) 270.
   */
  class StepControl
  {
  public:
    /// Of a stage: its largest increment, unless the scene has another.
    static constexpr double usual_share = .013;

    /**
     * @param begin, end  of the stage
     * @param first, smallest, largest increments
     * @param meet        times that must be met, ascending
     */
    StepControl(const StepSettings &settings,
                double begin,
                double end,
                double first,
                double smallest,
                double largest,
                const std::vector<double> &meet);

    /// End of the next increment that starts at @p time.
    double next(double time) const;

    /**
     * The increment was accepted.
     * @param iterations it took; nothing: it was solved by a last resort, which does what shorter increments do not, so
     *                   that their cuts are taken back
     * @param error      if it is controlled
     * @param longest    increment that would have been as large as allowed, in strain and rotation, at its rate
     * @param spent      iterations, those of failed attempts included
     */
    void accept(std::optional<unsigned int> iterations,
                double error = 0.,
                double longest = std::numeric_limits<double>::infinity(),
                unsigned int spent = 0);

    /// The next increment is to be no longer than this.
    void shorten(double longest);

    /// The increment failed: a shorter one is next; at the smallest one, some longer ones. @return false if nothing is
    /// left to try
    bool reject(double tried);

    /// What is tried in an increment of this @p length, which was cut @p cutbacks times. @param continues others
    Effort effort(double length, unsigned int cutbacks, bool continues) const;

    double increment() const
    {
      return increment_;
    }

    bool finished(double time) const;

    /// What later increments depend on, for a run that is resumed.
    struct State
    {
      double increment = 0;
      unsigned int quiet = 0, shortened = 0;
      double error = 0;
      FailedLength failed;
      TargetSearch search;
    };

    State state() const
    {
      return {increment_, quiet_, shortened_, error_, failed_, search_};
    }

    /// Go on from @p state, within the bounds of this control.
    void restore(const State &state);

  private:
    void take_back_cuts();

    /// What the iterations and the error of an accepted increment make of the next one.
    void resize(unsigned int iterations, double error);

    const StepSettings &settings_;
    static constexpr unsigned int most_longer_tries = 4, cuts_before_last_resorts = 2;
    unsigned int longer_tries_ = 0; ///< tries of longer increments since the last one was accepted
    double end_, smallest_, largest_;
    double usual_; ///< the largest increment, or where a scene allows longer ones what it would be by default
    double increment_;
    std::vector<double> meet_;
    unsigned int shortened_ = 0; ///< iterations of the increment that was the last to make the next one shorter
    unsigned int quiet_ = 0; ///< accepted increments that have to pass before it grows again
    FailedLength failed_;
    TargetSearch search_;
    double error_ = 0.; ///< of the last accepted increment; 0: none
  };
} // namespace deltaform
