#pragma once

#include <deltaform/assembly/accounts.h>
#include <deltaform/blanks/increment_size.h>
#include <deltaform/increment/increment_cost.h>
#include <deltaform/model/model.h>
#include <deltaform/reports/checkpoint.h>

#include <functional>
#include <optional>
#include <vector>

namespace deltaform
{
  /// An increment that was accepted, and the state at its end. What nobody asks for is not computed.
  class AcceptedIncrement
  {
  public:
    const Model &model;
    const Stage &stage;
    double time; ///< at its end
    unsigned int number; ///< counts from 1
    IncrementCost cost;
    double strain_at_rest = 0; ///< of a point, if more than allowed, where a refinement had left no equilibrium
    IncrementSize snap; ///< where the blank snapped to another equilibrium, if it is large
    bool is_last_here = true; ///< else the mesh is refined, and another one ends at the same time
    bool ends_stage = false;
    std::function<Checkpoint()> checkpoint = {}; ///< makes what a run can go on from

    const EnergyAccount &energies() const
    {
      if (!energies_)
        energies_ = model.energies();
      return *energies_;
    }

    const ContactAccount &contact() const
    {
      if (!contact_)
        contact_ = model.contact();
      return *contact_;
    }

    /// Cross-sections of a sheet at its nodes; none of a solid.
    const std::vector<SheetSection> &sections() const
    {
      if (!sections_)
        sections_ = model.blank().fields().sections();
      return *sections_;
    }

    /// See Fields::sharpest_bend().
    const SharpestBend &sharpest_bend() const
    {
      if (!sharpest_bend_)
        sharpest_bend_ = model.blank().fields().sharpest_bend(model.committed());
      return *sharpest_bend_;
    }

    /// See Fields::largest_shear().
    const LargestShear &largest_shear() const
    {
      if (!largest_shear_)
        largest_shear_ = model.blank().fields().largest_shear(model.committed());
      return *largest_shear_;
    }

    /// See Fields::overlap().
    const Overlap &overlap() const
    {
      if (!overlap_)
        overlap_ = model.blank().fields().overlap(model.committed());
      return *overlap_;
    }

    /// See Fields::innermost_place().
    const InnermostPlace &innermost_place() const
    {
      if (!innermost_place_)
        innermost_place_ = model.blank().fields().innermost_place(model.committed());
      return *innermost_place_;
    }

    /// See Fields::folded_cells().
    const FoldedCells &folded_cells() const
    {
      if (!folded_cells_)
        folded_cells_ = model.blank().fields().folded_cells(model.committed());
      return *folded_cells_;
    }

    /// See Fields::mesh_error().
    const MeshError &mesh_error() const
    {
      if (!mesh_error_)
        mesh_error_ = model.blank().fields().mesh_error(model.committed());
      return *mesh_error_;
    }

    /// Values along the blank, see Fields::profile().
    const Table &profile() const
    {
      if (!profile_)
        profile_ = model.blank().fields().profile(model.committed());
      return *profile_;
    }

    /// Criteria of the scene where they are largest.
    const std::vector<LargestCriterion> &largest_criteria() const
    {
      if (!largest_criteria_)
        largest_criteria_ = model.blank().fields().largest_criteria();
      return *largest_criteria_;
    }

    /// Of the flange; none where the scene does not ask.
    const FlangeWrinkling::Result &wrinkling() const
    {
      if (!wrinkling_)
      {
        const FlangeWrinkling *const asked = model.actors().wrinkling.get();
        wrinkling_ = asked != nullptr ? asked->judge(profile(), model.interfaces()) : FlangeWrinkling::Result();
      }
      return *wrinkling_;
    }

    double smallest_thickness() const
    {
      if (!smallest_thickness_)
        smallest_thickness_ = model.blank().fields().smallest_thickness();
      return *smallest_thickness_;
    }

    double balance_error() const
    {
      if (!balance_error_)
        balance_error_ = model.balance_error();
      return *balance_error_;
    }

    AcceptedIncrement(const Model &the_model, const Stage &the_stage, const double the_time,
                      const unsigned int the_number, const IncrementCost &the_cost)
      : model(the_model), stage(the_stage), time(the_time), number(the_number), cost(the_cost)
    {
    }

  protected: // what a test may know without a model
    mutable std::optional<EnergyAccount> energies_;
    mutable std::optional<ContactAccount> contact_;
    mutable std::optional<FlangeWrinkling::Result> wrinkling_;
    mutable std::optional<std::vector<SheetSection>> sections_;
    mutable std::optional<SharpestBend> sharpest_bend_;
    mutable std::optional<LargestShear> largest_shear_;
    mutable std::optional<FoldedCells> folded_cells_;
    mutable std::optional<Overlap> overlap_;
    mutable std::optional<MeshError> mesh_error_;
    mutable std::optional<InnermostPlace> innermost_place_;
    mutable std::optional<Table> profile_;
    mutable std::optional<std::vector<LargestCriterion>> largest_criteria_;
    mutable std::optional<double> smallest_thickness_, balance_error_;
  };
} // namespace deltaform
