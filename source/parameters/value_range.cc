#include <deltaform/parameters/text.h>
#include <deltaform/parameters/value_range.h>

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace deltaform
{
  namespace
  {
    constexpr double most_values = 10000;

    /// Is the whole of a text one finite number?
    bool read_number(const std::string &text, double &value)
    {
      char *end = nullptr;
      value = std::strtod(text.c_str(), &end);
      return !text.empty() && *end == '\0' && std::isfinite(value);
    }
  } // namespace


  std::vector<std::string> values_of_range(const std::string &text)
  {
    const auto pieces = text::split(text, ':');
    double first = 0., last = 0., step = 0.;
    if (pieces.size() != 3 || !read_number(pieces[0], first) || !read_number(pieces[1], last) ||
        !read_number(pieces[2], step))
      return {text};
    const double steps = (last - first) / step;
    if (!(steps >= 0.) || !std::isfinite(steps)) // a step of zero, or away from the last value
      throw std::invalid_argument("a step of " + pieces[2] + " does not lead from " + pieces[0] + " to " + pieces[1]);
    if (steps >= most_values)
      throw std::invalid_argument("more than " + fmt::format("{:g}", most_values) + " values");
    std::vector<std::string> result;
    // Sums of decimal steps end a little before or after the last value.
    for (int i = 0; i <= std::floor(steps * (1 + 1e-12) + 1e-9); ++i)
      result.push_back(fmt::format("{:.12g}", first + i * step));
    return result;
  }
} // namespace deltaform
