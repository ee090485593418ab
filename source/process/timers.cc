#include <deltaform/process/timers.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <iomanip>
#include <ostream>

namespace deltaform
{
  namespace
  {
    /// What the clock tells apart.
    double to_microseconds(const double seconds)
    {
      return std::round(1e6 * seconds) / 1e6;
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
    nlohmann::ordered_json sections = nlohmann::ordered_json::array();
    for (const Section &section : sections_)
      sections.push_back(
        {{"name", section.name}, {"calls", section.calls}, {"seconds", to_microseconds(section.seconds)}});
    const nlohmann::ordered_json timing{{"total", to_microseconds(total())}, {"sections", sections}};
    out << std::setw(2) << timing << '\n';
  }
} // namespace deltaform
