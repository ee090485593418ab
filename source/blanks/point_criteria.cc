#include "point_criteria.h"

#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>

#include <algorithm>

namespace deltaform
{
  PointCriteria::PointCriteria(const Section &scene, const PointFieldHost &host)
  {
    Section limits = scene.sub("Limits");
    const auto known = PointFields::names();
    names_ = limits.names("Criteria", "", "What is measured at every point: " + text::join(known, ", ") + ".");
    if (limits.documentation())
      names_ = known;
    else if (const std::string own = "temperature rise";
             keeps_its_heat(host.law) && std::find(names_.begin(), names_.end(), own) == names_.end())
      names_.push_back(own);
    for (const auto &name : names_)
    {
      if (std::find(known.begin(), known.end(), name) == known.end())
        limits.fail("Criteria",
                    "there is no criterion '" + name + "'; the nearest is '" + text::nearest(name, known) + "'");
      Section own = limits.sub(name);
      fields_.push_back(PointFields::make(name, own, host));
    }
  }


  void PointCriteria::reset(const std::size_t n)
  {
    values_.assign(n * n_fields(), 0.);
  }


  void PointCriteria::grow(const std::size_t point, const PointStep &step)
  {
    for (unsigned int k = 0; k < n_fields(); ++k)
      values_[point * n_fields() + k] += fields_[k]->growth(step);
  }


  double PointCriteria::across(const std::size_t first, const std::vector<double> &weights, const unsigned int k) const
  {
    const std::size_t n = weights.size();
    switch (fields_[k]->across())
    {
    case PointField::Across::middle:
      return .5 * (value(first + (n - 1) / 2, k) + value(first + n / 2, k));
    case PointField::Across::mean:
    {
      double sum = 0.;
      for (std::size_t l = 0; l < n; ++l)
        sum += weights[l] * value(first + l, k);
      return sum;
    }
    case PointField::Across::largest:
      break;
    }
    double most = value(first, k);
    for (std::size_t l = 1; l < n; ++l)
      most = std::max(most, value(first + l, k));
    return most;
  }


  std::string PointCriteria::column(const unsigned int k) const
  {
    std::string result = names_[k];
    std::replace_if(
      result.begin(), result.end(), [](const char c) { return c == ' ' || c == '-'; }, '_');
    return result;
  }


  std::string PointCriteria::all_names() const
  {
    return text::join(names_, ", ");
  }
} // namespace deltaform
