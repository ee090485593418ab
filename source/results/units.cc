#include <deltaform/base/text.h>
#include <deltaform/results/units.h>

#include <utility>

namespace deltaform
{
  Units::Units(const std::string &label)
    : label_(label)
  {
    const auto pieces = text::split(label, ',');
    if (pieces.size() == 3)
      {
        length_ = pieces[0];
        force_  = pieces[1];
        stress_ = pieces[2];
      }
  }



  std::string
  Units::of(const std::string &dimension) const
  {
    std::string result = dimension;
    for (const auto &[name, unit] : {std::pair<std::string, std::string>("length", length_), {"force", force_}, {"stress", stress_}})
      {
        const auto place = result.find(name);
        if (place != std::string::npos)
          result.replace(place, name.size(), unit);
      }
    return result;
  }
} // namespace deltaform
