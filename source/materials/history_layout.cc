#include <deltaform/materials/history_layout.h>

#include <algorithm>

namespace deltaform
{
  HistoryLayout::HistoryLayout(const std::initializer_list<HistoryField> fields)
  {
    for (HistoryField field : fields)
    {
      field.first = size_;
      size_ += field.size();
      fields_.push_back(std::move(field));
    }
  }


  void HistoryLayout::append(const HistoryLayout &other)
  {
    for (HistoryField field : other.fields_)
    {
      field.first += size_;
      fields_.push_back(std::move(field));
    }
    size_ += other.size_;
  }


  const HistoryField *HistoryLayout::find(const std::string &name) const
  {
    const auto field =
      std::find_if(fields_.begin(), fields_.end(), [&](const HistoryField &f) { return f.name == name; });
    return field != fields_.end() ? &*field : nullptr;
  }


  std::string HistoryLayout::to_string() const
  {
    std::string result;
    for (const auto &field : fields_)
    {
      const char *kind = field.kind == HistoryKind::tensor     ? ":tensor"
                         : field.kind == HistoryKind::positive ? ":positive"
                                                               : ":scalar";
      result += (result.empty() ? "" : " ") + field.name + kind;
    }
    return result;
  }


  double HistoryLayout::share_within(const double *const from,
                                     const double *const to,
                                     const double *const least,
                                     const double *const most) const
  {
    double share = 1.;
    for (const auto &field : fields_)
      if (field.kind == HistoryKind::positive)
      {
        const unsigned int i = field.first;
        const double bound = to[i] > most[i] ? most[i] : to[i] < least[i] ? least[i]
                                                                          : to[i];
        if (bound != to[i])
          share = std::min(share, (1. - 1e-14) * (bound - from[i]) / (to[i] - from[i]));
      }
    return std::max(0., share);
  }


  void HistoryLayout::clip(double *const values) const
  {
    for (const auto &field : fields_)
      if (field.kind == HistoryKind::positive)
        values[field.first] = std::max(0., values[field.first]);
  }
} // namespace deltaform
