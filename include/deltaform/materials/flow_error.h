#pragma once

#include <deltaform/materials/material.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  /**
   * The local error of backward Euler in J2 flow: it takes the direction at the end for the whole increment, the
   * trapezoidal rule takes the mean of both ends, so that they differ by half the turn of the direction. Of the turn
   * only the sine counts: a reversal by 180 degrees is followed exactly. The difference of two rules of neighbouring
   * orders as an estimate: E. Hairer, S.P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, Springer
   * 1993, sec. II.4.
   *
   * @param before, after Kirchhoff stress at both ends of the increment, in the same axes
   * @return share of the increment of plastic strain that goes astray, in [0, 1/2]
   */
  inline double flow_error(const Mandel &before, const Mandel &after)
  {
    const double mean_before = (before[0] + before[1] + before[2]) / 3.;
    const double mean_after = (after[0] + after[1] + after[2]) / 3.;
    double aa = 0., bb = 0., ab = 0.;
    for (unsigned int k = 0; k < 4; ++k)
    {
      const double a = before[k] - (k < 3 ? mean_before : 0.), b = after[k] - (k < 3 ? mean_after : 0.);
      aa += a * a;
      bb += b * b;
      ab += a * b;
    }
    return aa * bb > 0. ? .5 * std::sqrt(std::max(0., 1. - ab * ab / (aa * bb))) : 0.;
  }


  /// Mean over the flow of a blank, weighted by volume and increment of the equivalent plastic strain.
  struct MeanFlowError
  {
    double astray = 0., flow = 0.;

    void add(const double weighted_increment, const Mandel &before, const Mandel &after)
    {
      astray += weighted_increment * flow_error(before, after);
      flow += weighted_increment;
    }

    double value() const
    {
      return flow > 0. ? astray / flow : 0.;
    }
  };
} // namespace deltaform
