#pragma once
// What the conformance tests share: they loop over all that is registered, with two sets of parameters, and end at the
// first failure.
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/scene_error.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace deltaform
{
  namespace testing
  {
    /// Assignments "A/B/entry=value".
    using Entries = std::vector<std::string>;

    inline Entries operator+(Entries a, const Entries &b)
    {
      a.insert(a.end(), b.begin(), b.end());
      return a;
    }

    /// The first failure ends the test case, and says what came out and what was expected.
    inline void
    require_close(const double value, const double expected, const double tolerance, const std::string &what)
    {
      const bool close = std::abs(value - expected) <= tolerance;
      BOOST_REQUIRE_MESSAGE(close,
                            std::setprecision(17) << what << " is " << value << " instead of " << expected
                                                  << ", which is more than " << tolerance << " away");
    }

    /// What the documentation of a law amounts to as entries.
    template <typename Declare>
    Entries documented_entries(const Declare &declare)
    {
      ParameterTree tree = ParameterTree::documentation();
      declare(tree);
      std::ostringstream text;
      tree.print_prm(text);
      Entries result;
      for (const auto &entry : SceneFile::parse(text.str(), "documentation").entries)
        result.push_back(to_string(entry.path, entry.name) + "=" + entry.value);
      return result;
    }

    /// The assignment with .8 of its number; empty if it has none, or zero.
    inline std::string scaled(const std::string &entry)
    {
      const auto equal = entry.find('=');
      std::istringstream text(entry.substr(equal + 1));
      double value = 0.;
      if (!(text >> value) || !(text >> std::ws).eof() || value == 0.)
        return "";
      std::ostringstream result;
      result << entry.substr(0, equal + 1) << std::setprecision(17) << .8 * value;
      return result.str();
    }

    /// Other entries than the @p documented ones: every number is scaled if @p make, called with all entries, takes it.
    /// Nothing if there is no number.
    template <typename Make>
    Entries other_entries(const Entries &documented, const Make &make)
    {
      Entries result = documented;
      for (auto &entry : result)
        if (std::string other = scaled(entry); !other.empty())
        {
          std::swap(entry, other);
          try
          {
            make(result);
          }
          catch (const SceneError &) // out of its range
          {
            std::swap(entry, other);
          }
        }
      return result == documented ? Entries() : result;
    }

    /// Call @p body with the entries of a law's documentation, and with others.
    template <typename Make, typename Body>
    void with_two_sets(const Entries &documented, const Make &make, const Body &body)
    {
      body(documented);
      const auto others = other_entries(documented, make);
      if (others.empty())
        return;
      BOOST_TEST_CONTEXT("other parameters")
      body(others);
    }
  } // namespace testing
} // namespace deltaform
