#pragma once

#include <string>

namespace deltaform
{
  /**
   * Labels of the units. The program computes in any consistent system; the scene's label 'in, tonf, tonf/in^2'
   * (length, force, stress) only names it in the results; a fourth piece is the unit of time. A label of another form
   * leaves the dimensions' names.
   */
  class Units
  {
  public:
    explicit Units(const std::string &label);

    /// Label of a dimension such as "length", "force/length", "1". Words that are no dimension stay as they are.
    std::string of(const std::string &dimension) const;

    const std::string &label() const
    {
      return label_;
    }

  private:
    std::string label_, length_ = "length", force_ = "force", stress_ = "stress", time_ = "time";
  };
} // namespace deltaform
