#include <deltaform/geometry/curvature.h>
#include <deltaform/geometry/curve.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace deltaform
{
  namespace
  {
    bool is_sharp_corner(const Segment &segment)
    {
      return segment.kind == Segment::Kind::arc && segment.radius == 0. && segment.convex && segment.sweep != 0.;
    }

    /// Arc length on either side of a corner within which friction grows.
    double reach_of(const Segment &corner, const double offset)
    {
      return .25 * offset * std::abs(corner.sweep);
    }
  } // namespace


  double mean_curvature(const Curve &curve, const double arc_length, const double reach)
  {
    double turned = 0.;
    curve.for_each_image(arc_length,
                         [&](const double s) {
                           for (const Segment &segment : curve.segments())
                             if (segment.kind == Segment::Kind::arc && segment.radius > 0)
                             {
                               const double end = std::min(s + reach, segment.arc_start + segment.length);
                               const double overlap = end - std::max(s - reach, segment.arc_start);
                               if (overlap > 0)
                                 turned += (segment.convex ? 1. : -1.) * overlap / segment.radius;
                             }
                         });
    return turned / (2 * reach);
  }


  double curvature_change(const Curve &curve, const double arc_length, const double reach)
  {
    double change = 0.;
    for (const double side : {-1., 1.})
      curve.for_each_image(arc_length + side * reach,
                           [&](const double s) {
                             for (const Segment &segment : curve.segments())
                               if (segment.kind == Segment::Kind::arc && segment.radius > 0 && s > segment.arc_start &&
                                   s < segment.arc_start + segment.length)
                                 change += side * (segment.convex ? 1. : -1.) / segment.radius;
                           });
    return change / (2 * reach);
  }


  double curvature(const Curve &curve, const double arc_length)
  {
    double result = 0.;
    curve.for_each_image(arc_length,
                         [&](const double s) {
                           for (const Segment &segment : curve.segments())
                             if (segment.kind == Segment::Kind::arc && segment.radius > 0 && s > segment.arc_start &&
                                 s < segment.arc_start + segment.length)
                               result += (segment.convex ? 1. : -1.) / segment.radius;
                         });
    return result;
  }


  double smallest_radius(const Curve &curve)
  {
    double result = std::numeric_limits<double>::infinity();
    for (const Segment &segment : curve.segments())
      if (segment.kind == Segment::Kind::arc && segment.radius > 0)
        result = std::min(result, segment.radius);
    return result;
  }


  double smallest_radius(const Curve &curve, const double from, const double to)
  {
    const double way = curve.slip(from, to), first = std::min(from, from + way), last = std::max(from, from + way);
    double result = std::numeric_limits<double>::infinity();
    for (const Segment &segment : curve.segments())
    {
      if (segment.kind != Segment::Kind::arc || (segment.radius == 0 && !segment.convex))
        continue;
      std::vector<double> begins, ends;
      curve.for_each_image(segment.arc_start, [&](const double s) { begins.push_back(s); });
      curve.for_each_image(segment.arc_start + segment.length, [&](const double s) { ends.push_back(s); });
      for (unsigned int i = 0; i < begins.size(); ++i)
        if (std::max(begins[i], ends[i]) > first && std::min(begins[i], ends[i]) < last)
          result = std::min(result, segment.radius);
    }
    return result;
  }


  CornerShare corner_share(const Curve &curve, const double arc_length, const double offset)
  {
    CornerShare share;
    for (const Segment &segment : curve.segments())
      if (is_sharp_corner(segment))
        curve.for_each_image(segment.arc_start, [&](const double s) {
          const double reach = reach_of(segment, offset), way = arc_length - s;
          if (std::abs(way) < share.value * reach)
            share = {std::abs(way) / reach, std::copysign(1. / reach, way)};
        });
    return share;
  }


  double offset_slip(const Curve &curve, const double a, const double b, const double offset)
  {
    const double whole = curve.slip(a, b);
    if (offset == 0. || whole == 0.)
      return whole;
    const double first = std::min(a, a + whole), last = std::max(a, a + whole);
    // Where the integrand may have kinks: the joints and their images, the offset before and after each, and where the
    // share of the friction at a corner begins to grow.
    const auto for_kinks = [&](const auto &action) {
      for (const Segment &segment : curve.segments())
      {
        for (const double joint : {segment.arc_start, segment.arc_start + segment.length})
          curve.for_each_image(joint, [&](const double s) { action(s, offset); });
        if (is_sharp_corner(segment))
          curve.for_each_image(segment.arc_start, [&](const double s) { action(s, reach_of(segment, offset)); });
      }
    };
    bool any = false;
    for_kinks([&](const double s, const double reach) { any |= s + reach > first && s - reach < last; });
    if (!any)
      return whole;
    std::vector<double> kinks{first, last};
    for_kinks([&](const double s, const double reach) {
      for (const double kink : {s - reach, s, s + reach})
        if (kink > first && kink < last)
          kinks.push_back(kink);
    });
    std::sort(kinks.begin(), kinks.end());
    const double gauss = std::sqrt(.6);
    const std::array<double, 3> point = {{-gauss, 0., gauss}}, weight = {{5. / 18., 8. / 18., 5. / 18.}};
    double sum = 0.;
    for (unsigned int k = 0; k + 1 < kinks.size(); ++k)
    {
      const double length = kinks[k + 1] - kinks[k], middle = .5 * (kinks[k + 1] + kinks[k]);
      const double ahead = 1. + offset * curvature(curve, middle);
      for (unsigned int g = 0; g < 3; ++g)
      {
        const double place = middle + .5 * length * point[g];
        sum += weight[g] * length * ahead * corner_share(curve, place, offset).value /
               (1. + offset * mean_curvature(curve, place, offset));
      }
    }
    return whole > 0 ? sum : -sum;
  }
} // namespace deltaform
