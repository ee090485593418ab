#pragma once

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/assembly/types.h>

namespace deltaform
{
  class Load;

  /**
   * What a unit load works on between the undeformed blank and the state q, if all nodes go straight:
   *   V(q) = integral_0^1 f(s q).q ds,
   * f the forces of a unit load. Of a pressure it is the volume that its face sweeps, of an edge load the displacement
   * times the edge's length. f is a polynomial in q of second order at most, so that two Gauss points are exact.
   *
   * A load that follows a way has its size p as an unknown after those of the sparse matrix, with the equation
   * V(q) = V*. With R = -p f in the rows of the blank, the sum of both is the derivative of -p (V - V*): the tangent is
   * symmetric, and regular where dp = 0. (Control by what grows: J. L. Batoz, G. Dhatt, Int. J. Numer. Meth. Eng. 14
   * (1979) 1262; here the displacement is a volume.)
   */
  class LoadWay
  {
  public:
    LoadWay(const Load &load, const Vector &q);

    double value() const
    {
      return value_;
    }

    /// dV/dq.
    const Vector &gradient() const
    {
      return gradient_;
    }

    /// Add the equation V(q) = @p prescribed, and how the forces on the blank depend on the size of the load.
    void assemble(double prescribed, AssemblyTarget &target) const;

  private:
    const Load &load_;
    const Vector &q_;
    double value_ = 0.;
    Vector gradient_;
  };
} // namespace deltaform
