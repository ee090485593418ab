#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace deltaform
{
  /**
   * Name -> maker of the parts of one kind that a scene does not choose by an entry of their name (Registry is for
   * those, and rests on this): conditions, observers, strategies. A part registers itself by the last line of its own
   * .cc file, in the library or in a program that uses it:
   *
   *     const ConditionMakers::Entry entry("press limit", "a tool presses harder than the press can", make);
   */
  template <typename T, typename... Args>
  class Makers
  {
  public:
    using Maker = std::unique_ptr<T> (*)(Args...);

    struct Record
    {
      std::string sentence;
      Maker maker;
    };

    struct Entry
    {
      /// @throws std::logic_error if the name is taken: one of the two would be lost without a word
      Entry(const std::string &name, const std::string &sentence, const Maker maker)
      {
        if (!records().emplace(name, Record{sentence, maker}).second)
          throw std::logic_error("two of one kind are called '" + name + "'");
      }
    };

    /// The registered names in alphabetical order.
    static std::vector<std::string> names()
    {
      std::vector<std::string> result;
      for (const auto &[name, record] : records())
        result.push_back(name);
      return result;
    }

    static const std::string &sentence(const std::string &name)
    {
      return records().at(name).sentence;
    }

    /// @throws std::out_of_range if nothing is registered under @p name
    static std::unique_ptr<T> make(const std::string &name, Args... args)
    {
      return records().at(name).maker(args...);
    }

  private:
    // A function's static, so that it exists before the first self-registration of any file.
    static std::map<std::string, Record> &records()
    {
      static std::map<std::string, Record> the_records;
      return the_records;
    }
  };
} // namespace deltaform
