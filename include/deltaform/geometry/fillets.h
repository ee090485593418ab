#pragma once

#include <deltaform/assembly/types.h>

#include <vector>

namespace deltaform
{
  /**
   * Corner points joined by straight edges, with a fillet at each corner: what the fillets leave of the edges. The
   * outline of a tool and the meridian of a blank are built from it.
   */
  class FilletedCorners
  {
  public:
    /**
     * @param radii one per point; 0 is a sharp corner. Those of the first and the last point are ignored, unless the
     *   last point is joined to the first (@p closed)
     * @throws std::invalid_argument naming the corner if a fillet does not fit, two neighbouring points coincide, the
     *   path turns back on itself or a number is not one
     */
    FilletedCorners(const std::vector<Point2> &points, const std::vector<double> &radii, bool closed);

    unsigned int n_points() const
    {
      return static_cast<unsigned int>(setbacks_.size());
    }

    unsigned int n_edges() const
    {
      return static_cast<unsigned int>(tangents_.size());
    }

    bool is_corner(const unsigned int point) const
    {
      return closed_ || (point > 0 && point + 1 < n_points());
    }

    const Tensor1 &tangent(const unsigned int edge) const
    {
      return tangents_[edge];
    }

    /// Of the edge that ends in a corner.
    const Tensor1 &tangent_before(const unsigned int corner) const
    {
      return tangents_[(corner + n_edges() - 1) % n_edges()];
    }

    /// What the fillet of a point takes of the edges next to it.
    double setback(const unsigned int point) const
    {
      return setbacks_[point];
    }

    /// Length of what the fillets leave of an edge; 0 if that is round-off.
    double straight(unsigned int edge) const;

  private:
    void check_corner(unsigned int i, const Point2 &point, double radius) const;
    void check_edge(unsigned int e, const std::vector<Point2> &points, const std::vector<double> &radii) const;

    bool closed_;
    std::vector<Tensor1> tangents_; ///< by edge
    std::vector<double> lengths_; ///< by edge
    std::vector<double> setbacks_; ///< by point
  };
} // namespace deltaform
