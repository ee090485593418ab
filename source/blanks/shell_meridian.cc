#include "shell_meridian.h"

#include <cmath>

namespace deltaform
{
  namespace
  {
    /// Hermite polynomials on [0, 1] or their derivatives: of the places of both ends, and of the tangents there.
    struct Hermite
    {
      std::array<double, 2> place, tangent;
    };

    Hermite values(const double xi)
    {
      const double eta = 1. - xi;
      return {{{eta * eta * (1. + 2. * xi), xi * xi * (1. + 2. * eta)}}, {{xi * eta * eta, -xi * xi * eta}}};
    }

    Hermite derivatives(const double xi)
    {
      const double eta = 1. - xi;
      return {{{-6. * xi * eta, 6. * xi * eta}}, {{eta * (1. - 3. * xi), xi * (1. - 3. * eta)}}};
    }
  } // namespace


  ShellMeridian::ShellMeridian(const ShellSpace &space)
    : space_(space)
  {
    for (const auto &cell : space.mesh().cells())
      if (space.degree() == 1)
        pieces_.push_back({{{cell.nodes[0], cell.nodes[1]}}, {{cell.angle[0], cell.angle[1]}}});
      else
      {
        pieces_.push_back({{{cell.nodes[0], cell.nodes[2]}}, {{cell.angle[0], cell.angle[2]}}});
        pieces_.push_back({{{cell.nodes[2], cell.nodes[1]}}, {{cell.angle[2], cell.angle[1]}}});
      }
    length_.assign(pieces_.size(), 0.);
    directions_.resize(pieces_.size());
  }


  const Tensor1 &ShellMeridian::direction(const Vector &q, const unsigned int piece, const unsigned int end) const
  {
    const double theta = angle(q, pieces_[piece], end);
    Direction &kept = directions_[piece][end];
    if (kept.angle != theta)
      kept = {theta, Tensor1({std::cos(theta), std::sin(theta)})};
    return kept.value;
  }


  void
  ShellMeridian::describe(const Vector &q, const unsigned int piece, const double xi, ContactPoint &result) const
  {
    const Piece &own = pieces_[piece];
    const double length = length_[piece];
    const Hermite shape = values(xi);
    result.n_nodes = 2;
    result.n_dofs = 6;
    result.x = Point2();
    result.reference_coordinate = result.arc_coordinate = 0.;
    const unsigned int nearest = xi > .5 ? 1 : 0;
    for (const unsigned int k : {0, 1})
    {
      const unsigned int end = k == 0 ? nearest : 1 - nearest, node = own.nodes[end];
      const double share = end == 0 ? 1. - xi : xi;
      const Tensor1 &t = direction(q, piece, end), d({-t[1], t[0]});
      const double arm = shape.tangent[end] * length;
      result.nodes[k] = {node, share};
      for (unsigned int c = 0; c < 3; ++c)
      {
        result.dofs[3 * k + c] = space_.dofs()[node][c];
        result.second[3 * k + c] = Tensor1();
      }
      result.x += shape.place[end] * Tensor1(space_.position(q, node)) + arm * t;
      result.jacobian[3 * k] = Tensor1({shape.place[end], 0.});
      result.jacobian[3 * k + 1] = Tensor1({0., shape.place[end]});
      result.jacobian[3 * k + 2] = arm * d;
      result.second[3 * k + 2] = -arm * t;
      result.reference_coordinate += share * space_.mesh().nodes()[node][0];
      result.arc_coordinate += share * space_.mesh().arc_length()[node];
    }
  }


  double ShellMeridian::area(const Vector &q, const unsigned int piece, const double xi) const
  {
    const Piece &own = pieces_[piece];
    const Hermite shape = values(xi), slope = derivatives(xi);
    Tensor1 along;
    double r = 0.;
    for (const unsigned int end : {0, 1})
    {
      const Tensor1 x = space_.position(q, own.nodes[end]), &t = direction(q, piece, end);
      along += slope.place[end] * x + slope.tangent[end] * length_[piece] * t;
      r += shape.place[end] * x[0] + shape.tangent[end] * length_[piece] * t[0];
    }
    return along.norm() * (space_.axisymmetric() ? 2. * dealii::numbers::PI * r : 1.);
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
