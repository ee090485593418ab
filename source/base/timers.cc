#include <deltaform/base/text.h>
#include <deltaform/base/timers.h>

#include <cstdio>
#include <ostream>

namespace deltaform
{
  namespace
  {
    std::string in_seconds(const double value)
    {
      char buffer[32];
      std::snprintf(buffer, sizeof buffer, "%.6f", value);
      return buffer;
    }
  } // namespace

  Timers::Timers()
    : start_(Clock::now())
  {
  }

  Timers::Index Timers::section(const std::string &name)
  {
    for (Index i = 0; i < sections_.size(); ++i)
      if (sections_[i].name == name)
        return i;
    sections_.push_back({name, 0, 0.});
    return sections_.size() - 1;
  }

  double Timers::total() const
  {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }

  double Timers::seconds(const Index index) const
  {
    return sections_[index].seconds;
  }

  unsigned long Timers::calls(const Index index) const
  {
    return sections_[index].calls;
  }

  void Timers::write_json(std::ostream &out) const
  {
    out << "{\n  \"total\": " << in_seconds(total()) << ",\n  \"sections\": [";
    for (Index i = 0; i < sections_.size(); ++i)
      out << (i == 0 ? "\n" : ",\n") << "    {\"name\": " << text::json_quote(sections_[i].name)
          << ", \"calls\": " << sections_[i].calls << ", \"seconds\": " << in_seconds(sections_[i].seconds) << "}";
    out << "\n  ]\n}\n";
  }
} // namespace deltaform
