#include <deltaform/parameters/ceilings.h>
#include <deltaform/parameters/magnitudes.h>
#include <deltaform/parameters/text.h>

#include <cmath>
#include <stdexcept>

namespace deltaform
{
  void Magnitudes::add(const double value, const bool is_size, const std::string &unit, const std::string &entry)
  {
    const double size = std::abs(value);
    if (size > ceilings::magnitude || (is_size && size < ceilings::smallest_size))
      throw std::invalid_argument("must lie between " + text::format(ceilings::smallest_size) + " and " +
                                  text::format(ceilings::magnitude) +
                                  ": products of other numbers cannot be computed");
    if (unit != "length")
      return;
    const Length own{size, entry};
    const Length &largest = size > largest_.value ? own : largest_;
    const Length &smallest = is_size && (smallest_.value == 0. || size < smallest_.value) ? own : smallest_;
    if (smallest.value > 0. && largest.value > ceilings::length_ratio * smallest.value)
    {
      const Length &other = largest.entry == entry ? smallest : largest;
      throw std::invalid_argument("is more than " + text::format(ceilings::length_ratio) + " times " +
                                  (largest.entry == entry ? "larger" : "smaller") + " than " + other.entry + " = " +
                                  text::rounded(other.value) + ": such lengths cannot be told apart by numbers of 16 "
                                                               "digits");
    }
    const Length new_largest = largest, new_smallest = smallest;
    largest_ = new_largest;
    smallest_ = new_smallest;
  }
} // namespace deltaform
