#pragma once

#include <functional>
#include <optional>

namespace deltaform
{
  /**
   * The step of Newton's method within a radius: d(mu) = -(K + mu M)^-1 R with the least mu >= 0 for which |d| comes to
   * the radius at most, M being the metric of |d|. |d(mu)| falls as mu rises, like 1/mu where nothing but mu resists.
   * A factorization is cheap against an assembly, and a length within a factor of about two will do (More and Sorensen
   * 1983, SIAM J. Sci. Stat. Comput. 4, 553; Conn, Gould and Toint 2000, Trust-Region Methods, 7.3).
   */
  class RadiusSearch
  {
  public:
    /// Solve with mu. @return |d(mu)|, nothing if there is no step
    using Length = std::function<std::optional<double>(double mu)>;

    /**
     * @param radius    of the step [length]; infinite: mu = 0
     * @param force     |R| [force]: mu = force/radius is enough wherever K resists
     * @param length_at what solves; the last step that it was asked for is the one that was found
     * @return false if there is no step
     */
    bool find(double radius, double force, const Length &length_at);

    /// Is a step of this @p length short enough?
    static bool is_within(double radius, double length);

    /// mu of the last step [force/length].
    double stiffness() const
    {
      return last_.mu;
    }

  private:
    /// A step that was tried.
    struct Tried
    {
      double mu = 0., length = 0.;
    };

    /// From what was too long and too short, where there is one (length > 0).
    static double next(const Tried &too_long, const Tried &too_short, double radius, double most);

    Tried last_;
  };
} // namespace deltaform
