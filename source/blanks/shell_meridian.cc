#include "shell_meridian.h"

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    /// Hermite polynomials of an end of [0, 1]: of its place, and of the tangent there. Each by itself: as a pair they
    /// go through memory in halves, which stalls the processor (half of the time of describe()).
    ///@{
    double by_place(const double xi, const unsigned int end)
    {
      const double eta = 1. - xi;
      return end == 0 ? eta * eta * (1. + 2. * xi) : xi * xi * (1. + 2. * eta);
    }

    double by_tangent(const double xi, const unsigned int end)
    {
      const double eta = 1. - xi;
      return end == 0 ? xi * eta * eta : -xi * xi * eta;
    }
    ///@}

    /// Their derivatives.
    ///@{
    double slope_by_place(const double xi, const unsigned int end)
    {
      const double slope = 6. * xi * (1. - xi);
      return end == 0 ? -slope : slope;
    }

    double slope_by_tangent(const double xi, const unsigned int end)
    {
      const double eta = 1. - xi;
      return end == 0 ? eta * (1. - 3. * xi) : xi * (1. - 3. * eta);
    }
    ///@}

    /// Their second derivatives.
    ///@{
    double bend_by_place(const double xi, const unsigned int end)
    {
      const double bend = 6. * (1. - 2. * xi);
      return end == 0 ? -bend : bend;
    }

    double bend_by_tangent(const double xi, const unsigned int end)
    {
      return 6. * xi - (end == 0 ? 4. : 2.);
    }
    ///@}
  } // namespace


  ShellMeridian::ShellMeridian(const ShellSpace &space)
    : space_(space)
  {
    set_up();
  }


  void ShellMeridian::set_up()
  {
    pieces_.clear();
    for (const auto &cell : space_.mesh().cells())
      if (space_.degree() == 1)
        pieces_.push_back({{{cell.nodes[0], cell.nodes[1]}}, {{cell.angle[0], cell.angle[1]}}});
      else
      {
        pieces_.push_back({{{cell.nodes[0], cell.nodes[2]}}, {{cell.angle[0], cell.angle[2]}}});
        pieces_.push_back({{{cell.nodes[2], cell.nodes[1]}}, {{cell.angle[2], cell.angle[1]}}});
      }
    length_.assign(pieces_.size(), 0.);
    directions_.assign(pieces_.size(), {});
  }


  const Tensor1 &ShellMeridian::direction(const Vector &q, const unsigned int piece, const unsigned int end) const
  {
    const double theta = angle(q, pieces_[piece], end);
    Direction &kept = directions_[piece][end];
    if (kept.angle != theta)
      kept = {theta, Tensor1({std::cos(theta), std::sin(theta)})};
    return kept.value;
  }


  inline ShellMeridian::End ShellMeridian::add_end(const Vector &q,
                                                   const unsigned int piece,
                                                   const double xi,
                                                   const unsigned int end,
                                                   const unsigned int k,
                                                   ContactPoint &result) const
  {
    const unsigned int node = pieces_[piece].nodes[end];
    const Tensor1 &t = direction(q, piece, end);
    const Point2 place = space_.position(q, node);
    const double weight = by_place(xi, end), arm = by_tangent(xi, end) * length_[piece];
    const End now{end == 0 ? 1. - xi : xi, weight, arm * t[0], arm * t[1]};
    result.nodes[k] = {node, now.share};
    result.x[0] += weight * place[0] + now.along_r;
    result.x[1] += weight * place[1] + now.along_z;
    return now;
  }


  void
  ShellMeridian::describe(const Vector &q, const unsigned int piece, const double xi, ContactPoint &result) const
  {
    result.n_nodes = 2;
    result.n_dofs = 6;
    result.x = Point2();
    result.reference_coordinate = result.arc_coordinate = 0.;
    const unsigned int nearest = xi > .5 ? 1 : 0;
    for (unsigned int k = 0; k < 2; ++k)
    {
      const auto [share, weight, along_r, along_z] = add_end(q, piece, xi, k == 0 ? nearest : 1 - nearest, k, result);
      const unsigned int node = result.nodes[k].node;
      const auto &dofs = space_.dofs()[node];
      for (unsigned int c = 0; c < 3; ++c)
        result.dofs[3 * k + c] = dofs[c];
      const auto set = [&](const unsigned int c, const double r, const double z, const double dr, const double dz) {
        result.jacobian[3 * k + c][0] = r;
        result.jacobian[3 * k + c][1] = z;
        result.second[3 * k + c][0] = dr;
        result.second[3 * k + c][1] = dz;
      };
      set(0, weight, 0., 0., 0.);
      set(1, 0., weight, 0., 0.);
      set(2, -along_z, along_r, -along_r, -along_z);
      result.reference_coordinate += share * space_.mesh().nodes()[node][0];
      result.arc_coordinate += share * space_.mesh().arc_length()[node];
    }
  }


  void ShellMeridian::locate(const Vector &q, const unsigned int piece, const double xi, ContactPoint &result) const
  {
    result.n_nodes = 2;
    result.x = Point2();
    const unsigned int nearest = xi > .5 ? 1 : 0;
    add_end(q, piece, xi, nearest, 0, result);
    add_end(q, piece, xi, 1 - nearest, 1, result);
  }


  Tensor1 ShellMeridian::rate(const Vector &q, const unsigned int piece, const double xi) const
  {
    Tensor1 result;
    for (const unsigned int end : {0, 1})
    {
      const Tensor1 x = space_.position(q, pieces_[piece].nodes[end]);
      result += slope_by_place(xi, end) * x + slope_by_tangent(xi, end) * length_[piece] * direction(q, piece, end);
    }
    return result;
  }


  ContactSurface::FaceCurve ShellMeridian::curve(const Vector &q, const unsigned int piece, const double xi) const
  {
    ContactSurface::FaceCurve result;
    const unsigned int nearest = xi > .5 ? 1 : 0; // whose unknowns describe() names first
    for (unsigned int k = 0; k < 2; ++k)
    {
      const unsigned int end = k == 0 ? nearest : 1 - nearest;
      const Tensor1 x = space_.position(q, pieces_[piece].nodes[end]), &t = direction(q, piece, end);
      const double by_x = slope_by_place(xi, end), by_t = length_[piece] * slope_by_tangent(xi, end);
      result.along += by_x * x + by_t * t;
      result.bend += bend_by_place(xi, end) * x + length_[piece] * bend_by_tangent(xi, end) * t;
      result.jacobian[3 * k] = Tensor1({by_x, 0.});
      result.jacobian[3 * k + 1] = Tensor1({0., by_x});
      result.jacobian[3 * k + 2] = by_t * Tensor1({-t[1], t[0]});
    }
    return result;
  }


  double ShellMeridian::area(const Vector &q, const unsigned int piece, const double xi) const
  {
    const double along = rate(q, piece, xi).norm();
    if (!space_.axisymmetric())
      return along;
    double r = 0.;
    for (const unsigned int end : {0, 1})
      r += by_place(xi, end) * space_.position(q, pieces_[piece].nodes[end])[0] +
           by_tangent(xi, end) * length_[piece] * direction(q, piece, end)[0];
    return along * (2. * dealii::numbers::PI * r);
  }


  double ShellMeridian::largest_motion(const unsigned int piece,
                                       const std::array<double, ContactPoint::max_dofs> &change) const
  {
    // h_00 + h_01 = 1; h_10 and -h_11 are at most 4/27; the chord of an arc is shorter than the arc.
    const double ends =
      std::sqrt(std::max(change[0] * change[0] + change[1] * change[1], change[3] * change[3] + change[4] * change[4]));
    return ends + 4. / 27. * length_[piece] * (std::abs(change[2]) + std::abs(change[5]));
  }


  void ShellMeridian::update(const Vector &q)
  {
    for (unsigned int i = 0; i < pieces_.size(); ++i)
    {
      const Piece &piece = pieces_[i];
      const double chord = space_.position(q, piece.nodes[0]).distance(space_.position(q, piece.nodes[1]));
      // Tangents of this length make the cubic an arc, but for the sixth order of its angle (Goldapp, Comput. Aided
      // Geom. Des. 8 (1991) 227): 4 R tan(angle/4), the chord being 2 R sin(angle/2).
      const double quarter = std::cos(.25 * (angle(q, piece, 1) - angle(q, piece, 0)));
      length_[i] = chord / (quarter * quarter);
    }
  }
} // namespace deltaform
