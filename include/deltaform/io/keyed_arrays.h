#pragma once

#include <deltaform/parameters/scene_error.h>

#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <cstring>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

namespace deltaform
{
  /// Arrays of numbers by their names: the state of a part, as a value that is copied and saved like any other.
  class KeyedArrays
  {
  public:
    void put(const std::string &name, std::vector<double> values)
    {
      arrays_[name] = std::move(values);
    }

    void put(const std::string &name, const double value)
    {
      arrays_[name] = {value};
    }

    /// Of plain values that consist of numbers, such as tensors.
    template <typename T>
    void put(const std::string &name, const std::vector<T> &values)
    {
      static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(double) == 0);
      std::vector<double> &array = arrays_[name];
      array.resize(values.size() * (sizeof(T) / sizeof(double)));
      if (!values.empty())
        std::memcpy(array.data(), values.data(), values.size() * sizeof(T));
    }

    bool has(const std::string &name) const
    {
      return arrays_.count(name) > 0;
    }

    /// @throws SceneError if there is no such array
    const std::vector<double> &at(const std::string &name) const
    {
      const auto place = arrays_.find(name);
      if (place == arrays_.end())
        throw SceneError("The saved state has no '" + name + "': it is that of another scene. Start again.");
      return place->second;
    }

    /// What has a size keeps it. @throws SceneError if the array has another one
    void take(const std::string &name, std::vector<double> &values) const
    {
      check_size(name, values.size());
      values = at(name);
    }

    void take(const std::string &name, double &value) const
    {
      check_size(name, 1);
      value = at(name).at(0);
    }

    template <typename T>
    void take(const std::string &name, std::vector<T> &values) const
    {
      static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(double) == 0);
      check_size(name, values.size() * (sizeof(T) / sizeof(double)));
      const std::vector<double> &array = at(name);
      values.resize(array.size() / (sizeof(T) / sizeof(double)));
      if (!values.empty())
        std::memcpy(values.data(), array.data(), values.size() * sizeof(T));
    }

    /// All of them by their names.
    const std::map<std::string, std::vector<double>> &all() const
    {
      return arrays_;
    }

    bool operator==(const KeyedArrays &other) const
    {
      return arrays_ == other.arrays_;
    }

    template <typename Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &arrays_;
    }

  private:
    void check_size(const std::string &name, const std::size_t n) const
    {
      const std::size_t saved = at(name).size();
      if (n != 0 && saved != 0 && n != saved)
        throw SceneError("The saved state has " + std::to_string(saved) + " numbers of '" + name +
                         "', this scene has " + std::to_string(n) +
                         ": it is damaged, or that of another scene. Start again.");
    }

    std::map<std::string, std::vector<double>> arrays_;
  };


  /// A part names its arrays once, in a function each_array(part, action); this action puts them into a state.
  class PutInto
  {
  public:
    explicit PutInto(KeyedArrays &state)
      : state_(state)
    {
    }

    template <typename T>
    void operator()(const std::string &name, const T &values) const
    {
      state_.put(name, values);
    }

  private:
    KeyedArrays &state_;
  };


  /// And this one takes them from a state. @throws SceneError if it has no such array
  class TakeFrom
  {
  public:
    explicit TakeFrom(const KeyedArrays &state)
      : state_(state)
    {
    }

    template <typename T>
    void operator()(const std::string &name, T &values) const
    {
      state_.take(name, values);
    }

  private:
    const KeyedArrays &state_;
  };
} // namespace deltaform
