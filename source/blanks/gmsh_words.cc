#include "gmsh_words.h"

#include <deltaform/parameters/ceilings.h>
#include <deltaform/parameters/text.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

namespace deltaform
{
  namespace
  {
    bool is_white(const char c)
    {
      return c == ' ' || (c >= '\t' && c <= '\r');
    }

    /// As much of a word as a message can show.
    std::string shown(const std::string &word)
    {
      return "'" + text::printable(word.substr(0, 40)) + (word.size() > 40 ? "..." : "") + "'";
    }
  } // namespace


  GmshWords::GmshWords(const std::string &content)
    : content_(content)
  {
  }


  void GmshWords::skip_white()
  {
    for (; place_ < content_.size() && is_white(content_[place_]); ++place_)
      line_ += content_[place_] == '\n';
  }


  bool GmshWords::at_end()
  {
    skip_white();
    return place_ == content_.size();
  }


  std::string GmshWords::word()
  {
    if (at_end())
      fail("the file ends where something should follow");
    const std::size_t begin = place_;
    while (place_ < content_.size() && !is_white(content_[place_]))
      ++place_;
    return content_.substr(begin, place_ - begin);
  }


  std::string GmshWords::rest_of_line()
  {
    const std::size_t begin = place_;
    place_ = std::min(content_.find('\n', place_), content_.size());
    return content_.substr(begin, place_ - begin);
  }


  GmshWords::Number GmshWords::integer(const std::string &what, const Number least, const Number most)
  {
    const std::string text = word();
    Number value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
      fail(shown(text) + " is no " + what);
    if (value < least || value > most)
      fail(text + " cannot be a " + what);
    return value;
  }


  GmshWords::Number GmshWords::count(const std::string &what, const std::size_t bytes)
  {
    const Number n = integer(what, 0, std::numeric_limits<int>::max());
    if (static_cast<std::size_t>(n) > (content_.size() - place_) / bytes)
      fail(std::to_string(n) + " cannot be the " + what + ": the rest of the file does not hold so many");
    return n;
  }


  double GmshWords::coordinate()
  {
    const std::string text = word();
    char *end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (*end != '\0')
      fail(shown(text) + " is no number");
    if (!(std::abs(value) <= ceilings::magnitude))
      fail(shown(text) + " cannot be a coordinate");
    return value;
  }


  void GmshWords::skip(const Number n)
  {
    for (Number i = 0; i < n; ++i)
      word();
  }


  void GmshWords::expect(const std::string &expected)
  {
    if (const std::string found = word(); found != expected)
      fail(shown(found) + " stands where " + expected + " should");
  }


  void GmshWords::skip_to(const std::string &end)
  {
    while (!at_end())
      if (word() == end)
        return;
    fail("the file ends before " + end);
  }


  void GmshWords::fail(const std::string &message) const
  {
    throw std::invalid_argument("line " + std::to_string(line_) + ": " + message);
  }
} // namespace deltaform
