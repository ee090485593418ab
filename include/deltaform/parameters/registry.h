#pragma once

#include <deltaform/parameters/section.h>

#include <deal.II/base/exceptions.h>

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace deltaform
{
  /**
   * Name -> maker of the laws of one kind. A law registers itself by the last line of its own .cc file:
   *
   *     static const Registry<Hardening>::Entry entry("swift", "K (e0 + e)^n", make_as<Swift, Hardening>);
   *
   * The registry feeds the choices in the scene, `--list`, the generated parameter page and the conformance tests. Its
   * makers read the law's parameters from the section of the scene in which the law was named; some are told more
   * (@p Args): a load its blank.
   */
  template <typename T, typename... Args>
  class Registry
  {
  public:
    using Maker = std::unique_ptr<T> (*)(Section &, Args...);

    struct Record
    {
      std::string sentence;
      Maker maker;
    };

    struct Entry
    {
      /// @throws std::logic_error if the name is taken: one of two laws would be lost without a word
      Entry(const std::string &name, const std::string &sentence, const Maker maker)
      {
        if (!records().emplace(name, Record{sentence, maker}).second)
          throw std::logic_error("two laws of one kind are called '" + name + "'");
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

    static std::unique_ptr<T> make(const std::string &name, Section &section, Args... args)
    {
      const auto record = records().find(name);
      AssertThrow(record != records().end(),
                  dealii::ExcMessage("Nothing is registered under the name '" + name + "'."));
      return record->second.maker(section, args...);
    }

    /**
     * Read the entry @p entry of @p section, whose value is one of the registered names, and make what it names from
     * the same section.
     */
    static std::unique_ptr<T> choose(Section &section,
                                     const std::string &entry,
                                     const std::string &default_name,
                                     const std::string &what_for,
                                     Args... args)
    {
      return make(section.choice(entry, default_name, names(), what_for), section, args...);
    }

  private:
    // A function's static, so that it exists before the first self-registration of any file.
    static std::map<std::string, Record> &records()
    {
      static std::map<std::string, Record> the_records;
      return the_records;
    }
  };

  /// The usual maker: construct from the section.
  template <typename Derived, typename Base, typename... Args>
  std::unique_ptr<Base> make_as(Section &section, Args... args)
  {
    return std::make_unique<Derived>(section, args...);
  }
} // namespace deltaform
