#include <deltaform/io/units.h>
#include <deltaform/parameters/text.h>

#include <cctype>

namespace deltaform
{
  Units::Units(const std::string &label)
    : label_(label)
  {
    const auto pieces = text::split(label, ',');
    if (pieces.size() != 3 && pieces.size() != 4)
      return;
    length_ = pieces[0];
    force_ = pieces[1];
    stress_ = pieces[2];
    if (pieces.size() == 4)
      time_ = pieces[3];
  }

  std::string Units::of(const std::string &dimension) const
  {
    // Word by word, so that a label which contains another dimension's name is left alone.
    std::string result, word;
    const auto finish_word = [&]() {
      result += word == "length"   ? length_
                : word == "force"  ? force_
                : word == "stress" ? stress_
                : word == "time"   ? time_
                                   : word;
      word.clear();
    };
    for (const char c : dimension)
      if (std::isalnum(static_cast<unsigned char>(c)) || c == '_')
        word += c;
      else
      {
        finish_word();
        result += c;
      }
    finish_word();
    return result;
  }
} // namespace deltaform
