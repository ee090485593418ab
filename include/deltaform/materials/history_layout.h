#pragma once

#include <initializer_list>
#include <string>
#include <vector>

namespace deltaform
{
  /// How a quantity of the history is interpolated, turned with the metal and drawn.
  enum class HistoryKind : unsigned char
  {
    scalar, ///< one value
    positive, ///< one value, never less than zero
    tensor ///< four values (Mandel), in the axes of the point
  };

  /// One quantity of the history of a point.
  struct HistoryField
  {
    std::string name; ///< also that of the drawn field: "equivalent_plastic_strain"
    HistoryKind kind;
    std::string unit; ///< dimension: "1", "stress"
    unsigned int first = 0; ///< where its values begin in those of a point

    unsigned int size() const
    {
      return kind == HistoryKind::tensor ? 4 : 1;
    }
  };

  /**
   * What a law remembers at a point, in the order of its values. The law says it once; the blanks transfer, turn, draw
   * and save the history by it, without knowing the law.
   */
  class HistoryLayout
  {
  public:
    HistoryLayout() = default;
    HistoryLayout(std::initializer_list<HistoryField> fields);

    /// The fields of another law behind those of this one.
    void append(const HistoryLayout &other);

    /// Values per point.
    unsigned int size() const
    {
      return size_;
    }

    const std::vector<HistoryField> &fields() const
    {
      return fields_;
    }

    /// @return the field of this name; null if there is none
    const HistoryField *find(const std::string &name) const;

    /// Names and kinds: "plastic_strain:tensor equivalent_plastic_strain:positive"; of no fields it is empty.
    std::string to_string() const;

    /**
     * How far to go from the values @p from towards the values @p to (one point each), if every positive field has to
     * stay in its range @p least to @p most. Fields of other kinds know no range.
     * @return share of the way, in [0, 1]; a little less than what leads to a bound, for the sake of round-off
     */
    double share_within(const double *from, const double *to, const double *least, const double *most) const;

    /// Positive fields that round-off or extrapolation made negative are zero.
    void clip(double *values) const;

  private:
    std::vector<HistoryField> fields_;
    unsigned int size_ = 0;
  };
} // namespace deltaform
