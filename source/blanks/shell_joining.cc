#include "shell_joining.h"

#include <algorithm>
#include <cmath>

namespace deltaform
{
  bool ShellJoining::bends(const double bend, const double length) const
  {
    constexpr double share = .3;
    return std::abs(bend) > share * limit_.at(std::abs(bend) / length);
  }


  bool ShellJoining::halves_of_one(const Elements &elements, const unsigned int element) const
  {
    const ShellMesh::Part &one = elements.parts[element], &other = elements.parts[element + 1];
    const double size = one.end - one.begin;
    // Shares of a cell are binary fractions: exact.
    if (one.cell != other.cell || other.end - other.begin != size || std::fmod(one.begin / size, 2.) != 0.)
      return false;
    const auto &left = elements.left_alone;
    return std::find(left.begin(), left.end(), ShellMesh::Part{one.cell, one.begin, other.end}) == left.end();
  }


  bool ShellJoining::straight(const Elements &elements, const unsigned int element) const
  {
    constexpr double share = .2;
    const double one = elements.bends[element], other = elements.bends[element + 1];
    const double length = elements.lengths[element];
    const auto is = [&](const double bend, const double along) {
      return std::abs(bend) < share * limit_.at(std::abs(bend) / along);
    };
    return is(one, length) && is(other, length) && is(one + other, 2. * length);
  }


  bool ShellJoining::graded(const Elements &elements, const unsigned int element) const
  {
    constexpr double ratio = 2.2; // less than the one at which a neighbour is halved
    const auto &lengths = elements.lengths;
    const double both = lengths[element] + lengths[element + 1];
    return (element == 0 || both < ratio * lengths[element - 1]) &&
           (element + 2 >= lengths.size() || both < ratio * lengths[element + 2]);
  }


  bool ShellJoining::same_metal(const unsigned int element) const
  {
    constexpr double difference = .02;
    const unsigned int n_layers = parts_.points().n_layers(), per_cell = parts_.points().per_cell();
    for (unsigned int l = 0; l < n_layers; ++l)
      for (unsigned int i = 0; i < 2; ++i)
      {
        const auto strain = [&](const unsigned int k) {
          return parts_.state().strain((element * per_cell + k) * n_layers + l)[i];
        };
        double least = strain(0), most = least;
        for (unsigned int k = 1; k < 2 * per_cell; ++k)
        {
          least = std::min(least, strain(k));
          most = std::max(most, strain(k));
        }
        if (most - least > difference)
          return false;
      }
    return true;
  }


  std::vector<bool> ShellJoining::at_rest(const Elements &elements) const
  {
    constexpr unsigned int reach = 6;
    const unsigned int n = elements.parts.size();
    std::vector<bool> result(n, true);
    for (unsigned int c = 0; c < n; ++c)
      if (elements.halved[c] || elements.short_for_tools[c] || bends(elements.bends[c], elements.lengths[c]))
        for (unsigned int k = std::max(c, reach) - reach; k < std::min(c + reach + 1, n); ++k)
          result[k] = false;
    return result;
  }


  std::vector<bool> ShellJoining::choose(const Elements &elements) const
  {
    const unsigned int n = elements.parts.size();
    std::vector<bool> result(n, false);
    const std::vector<bool> rests = at_rest(elements);
    unsigned int pairs = 0;
    for (unsigned int c = 0; c + 1 < n; ++c)
      if (rests[c] && rests[c + 1] && elements.were_bent[c] && elements.were_bent[c + 1] &&
          halves_of_one(elements, c) && straight(elements, c) && graded(elements, c) && same_metal(c))
      {
        result[c] = true;
        ++pairs;
        ++c;
      }
    // Each change of the mesh takes iterations.
    constexpr unsigned int least = 8, share = 8;
    if (pairs < std::max(least, n / share))
      result.assign(n, false);
    return result;
  }
} // namespace deltaform
