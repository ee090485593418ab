#pragma once
// What summary.json says; private to the results.
#include <deltaform/reports/accepted_increment.h>
#include <deltaform/reports/mesh_error_sum.h>
#include <deltaform/reports/observer.h>
#include <deltaform/results/output_settings.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <string>
#include <vector>

namespace deltaform
{
  /// The outcome of a run in a page: what its last increment left, and what all of them cost.
  class RunSummary
  {
  public:
    explicit RunSummary(const OutputSettings &output)
      : output_(output)
    {
    }

    void begin(const Model &model, const Stage &stage);
    void accepted(const AcceptedIncrement &increment);
    void moved(const AcceptedIncrement &increment);

    /// Title and label of the units stand in it, and the seconds that the run took. Numbers that are not finite become
    /// null, bytes that are no UTF-8 a question mark.
    std::string json(const Model &model, const RunOutcome &outcome, const std::string &title,
                     const std::string &units_label, double seconds) const;

    /// Measures that find nothing on the part.
    std::vector<std::string> missing(const Model &model) const;

    /// The last line for the user.
    std::string last_line(const Model &model, const RunOutcome &outcome, double seconds) const;

    void save(boost::archive::binary_oarchive &archive) const
    {
      archive << cost_.rounds << cost_.correction_iterations << cost_.cutbacks << promise_ << between_ << deepest_
              << forces_ << travels_ << formed_.names << formed_.units << formed_.rows << cost_.rejected_iterations
              << mesh_error_;
    }

    void load(boost::archive::binary_iarchive &archive)
    {
      archive >> cost_.rounds >> cost_.correction_iterations >> cost_.cutbacks >> promise_ >> between_ >> deepest_ >>
        forces_ >> travels_ >> formed_.names >> formed_.units >> formed_.rows >> cost_.rejected_iterations >>
        mesh_error_;
    }

  private:
    void remember(const AcceptedIncrement &increment);
    void remember_forces(const Model &model);
    std::vector<Measure::Result> measured(const Measure &measure, const Model &model) const;

    const OutputSettings &output_;
    IncrementCost cost_; ///< of the run
    double promise_ = 0., between_ = 0.; ///< largest p/delta and penetration between nodes of the run
    double deepest_ = 0.; ///< the same over delta, but for edges over sharp corners
    std::vector<double> forces_, travels_; ///< of each tool: the largest that it has pressed with, and where
    /// Profile at the end of the last stage but one, or of a blank that an earlier operation left and this one lets go;
    /// empty where nobody asks for it.
    Table formed_;
    MeshErrorSum mesh_error_;
    bool any_ = false; ///< was any increment accepted?
    double time_ = 0., thinnest_ = 0., energy_error_ = 0.,
           artificial_friction_ = 0.; ///< of the last accepted increment
  };
} // namespace deltaform
