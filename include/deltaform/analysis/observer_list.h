#pragma once

#include <deltaform/model/workspace.h>
#include <deltaform/reports/accepted_increment.h>
#include <deltaform/reports/observer.h>

#include <memory>
#include <string>
#include <vector>

namespace deltaform
{
  /// The observers of a run, told in their order.
  class ObserverList
  {
  public:
    void add(std::unique_ptr<Observer> observer)
    {
      all_.push_back(std::move(observer));
    }

    /// Call @p action with each.
    template <typename Action>
    void tell(const Action &action) const
    {
      for (const auto &observer : all_)
        action(*observer);
    }

    /// An increment will be tried: whoever wants to see its tangent is shown it.
    void announce(const Model &model, Workspace &workspace, unsigned int number) const;

    /// What they remember, in bytes that only they understand.
    std::string save() const;
    void load(const std::string &bytes) const;

  private:
    std::vector<std::unique_ptr<Observer>> all_;
  };
} // namespace deltaform
