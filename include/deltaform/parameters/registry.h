#pragma once

#include <deltaform/parameters/makers.h>

#include <memory>
#include <string>
#include <vector>

namespace deltaform
{
  class Section;

  /// Section::choice(). A call from here spares those who hold a registry of laws the header of sections, and so their
  /// recompilation with it.
  std::string read_choice(Section &section,
                          const std::string &entry,
                          const std::string &default_name,
                          const std::vector<std::string> &choices,
                          const std::string &sentence);


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
  class Registry : public Makers<T, Section &, Args...>
  {
  public:
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
      using Base = Makers<T, Section &, Args...>;
      return Base::make(read_choice(section, entry, default_name, Base::names(), what_for), section, args...);
    }
  };

  /// The usual maker: construct from the section.
  template <typename Derived, typename Base, typename... Args>
  std::unique_ptr<Base> make_as(Section &section, Args... args)
  {
    return std::make_unique<Derived>(section, args...);
  }
} // namespace deltaform
