#pragma once

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/blanks/blank.h>

#include <vector>

namespace deltaform
{
  class Load;

  /**
   * The equation of a load whose path has a prescribed length: the increment, projected on the direction of the last
   * one, is as long as the length has grown (E. Riks, Int. J. Solids Struct. 15 (1979) 529). It passes maxima of the
   * load and of the displacement. Lengths are root mean squares of the displacements of all nodes; the first
   * increment has no direction, and takes the mean way of what is loaded.
   */
  class ArcLength
  {
  public:
    explicit ArcLength(const Blank &blank);

    /// The path begins at @p q.
    void begin(const Vector &q);

    /// Add the equation that the path is as long as @p length, and how the forces on the blank depend on the load.
    void assemble(const Load &load, const Vector &q, double length, AssemblyTarget &target) const;

    /// The state @p q, where the path is as long as @p length, is accepted.
    void accept(const Vector &q, double length);

    /// What is remembered; always as many numbers.
    std::vector<double> history() const;
    void set_history(const std::vector<double> &values);

  private:
    /// Derivative of the length travelled since the last accepted state, by the unknowns of the blank, and that length.
    std::pair<Vector, double> travelled(const Load &load, const Vector &q) const;

    /// Weight of the square of an unknown.
    double weight(DofIndex unknown) const;

    const Blank &blank_;
    DofIndex n_;
    double n_nodes_;
    Vector start_, direction_; ///< of the blank's unknowns; direction zero: none yet
    double accepted_ = 0.; ///< length
  };
} // namespace deltaform
