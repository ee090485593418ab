#pragma once

#include <deltaform/assembly/energy.h>
#include <deltaform/io/keyed_arrays.h>

#include <optional>
#include <vector>

namespace deltaform
{
  /// The energies of a blank, for as long as somebody asks for them; zero after that.
  class BlankAccount
  {
  public:
    bool counts() const
    {
      return sum_.has_value();
    }

    void stop()
    {
      sum_.reset();
    }

    /// At the end of an increment: the energy stored now, what was dissipated, and the work of the transverse stress.
    void add(const double elastic, const double plastic, const double normal = 0.)
    {
      if (!sum_)
        return;
      sum_->elastic = elastic;
      sum_->plastic += plastic;
      sum_->normal += normal;
    }

    BlankEnergy sum() const
    {
      return sum_.value_or(BlankEnergy());
    }

    /// @name State
    ///@{
    void put(KeyedArrays &state) const
    {
      const BlankEnergy now = sum();
      state.put(key, std::vector<double>{now.elastic, now.plastic, now.normal});
    }

    void take(const KeyedArrays &state)
    {
      std::vector<double> energies = state.at(key);
      energies.resize(3); // states of solids once held two
      if (sum_)
        sum_ = BlankEnergy{energies[0], energies[1], energies[2]};
    }
    ///@}

  private:
    static constexpr const char *key = "energies";
    std::optional<BlankEnergy> sum_ = BlankEnergy();
  };
} // namespace deltaform
