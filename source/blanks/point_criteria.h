#pragma once

#include <deltaform/materials/point_field.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace deltaform
{
  /// The point fields that a scene asks for (Limits/Criteria) and their committed values, point by point.
  class PointCriteria
  {
  public:
    /// Read them. @throws SceneError if the scene names one that there is not, or that is nothing for such a blank
    PointCriteria(const Section &scene, const PointFieldHost &host);

    /// Of @p n points: all zero.
    void reset(std::size_t n);

    unsigned int n_fields() const
    {
      return fields_.size();
    }

    const std::vector<std::string> &names() const
    {
      return names_;
    }

    const PointField &field(const unsigned int k) const
    {
      return *fields_[k];
    }

    double value(const std::size_t point, const unsigned int k) const
    {
      return values_[point * n_fields() + k];
    }

    /// An accepted increment of one point.
    void grow(std::size_t point, const PointStep &step);

    /// All values, point by point; for a change of the mesh.
    void set_values(std::vector<double> values)
    {
      values_ = std::move(values);
    }

    /// Value of a cross-section, whose points have the numbers @p first to @p first + weights.size() - 1 from face to
    /// face. @param weights shares of the thickness, summing to 1
    double across(std::size_t first, const std::vector<double> &weights, unsigned int k) const;

    /// The name of a field in columns: "rice_tracey".
    std::string column(unsigned int k) const;

    /// Every array of the state with its name.
    template <typename Criteria, typename Action>
    static void each_array(Criteria &criteria, const Action &action)
    {
      if (!criteria.names_.empty())
        action("criteria: " + criteria.all_names(), criteria.values_);
    }

  private:
    std::string all_names() const;

    std::vector<std::string> names_;
    std::vector<std::unique_ptr<PointField>> fields_;
    std::vector<double> values_;
  };
} // namespace deltaform
