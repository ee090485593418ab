// The state of a solid, for a run that goes on.
#include <deltaform/base/archive.h>
#include <deltaform/base/byte_stream.h>
#include <deltaform/base/ranks.h>
#include <deltaform/base/scene_error.h>
#include <deltaform/blanks/solid.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/array.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <sstream>

namespace deltaform
{
  void Solid::save(std::ostream &stream) const
  {
    const BlankEnergy total = energy();
    ByteStream own;
    {
      boost::archive::binary_oarchive archive(own.stream());
      archive << passes_ << estimated_error_ << history_ << carried_ << faces_[0].area << faces_[1].area
              << smallest_thickness_ << total.elastic << total.plastic;
      archive_plain(archive, spin_);
      archive_plain(archive, committed_stress_);
      archive_plain(archive, committed_deformation_);
      archive_plain(archive, plastic_metric_);
      archive << volume_offset_;
      archive_plain(archive, committed_places_);
    }
    const std::vector<std::string> all = ranks::gather(own.take());
    boost::archive::binary_oarchive(stream) << all;
  }


  void Solid::load(std::istream &stream)
  {
    std::vector<std::string> all;
    boost::archive::binary_iarchive(stream) >> all;
    if (all.size() != ranks::count())
      throw SceneError("Cannot resume: the run was saved by " + std::to_string(all.size()) + " processes and goes on " +
                       "with as many only (mpirun -np " + std::to_string(all.size()) + "); these are " +
                       std::to_string(ranks::count()) + ".");
    std::istringstream own(all[ranks::mine()]);
    BlankEnergy total;
    boost::archive::binary_iarchive archive(own);
    std::vector<std::vector<bool>> passes;
    archive >> passes;
    std::vector<Vector> none;
    for (auto pass = passes_.size(); pass < passes.size(); ++pass)
    {
      mesh_.triangulation().load_refine_flags(passes[pass]);
      refine(none);
    }
    archive >> estimated_error_ >> history_ >> carried_ >> faces_[0].area >> faces_[1].area >> smallest_thickness_ >>
      total.elastic >> total.plastic;
    if (energy_)
      energy_ = total;
    archive_plain(archive, spin_);
    archive_plain(archive, committed_stress_);
    archive_plain(archive, committed_deformation_);
    archive_plain(archive, plastic_metric_);
    archive >> volume_offset_;
    archive_plain(archive, committed_places_);
    stress_ = committed_stress_;
    deformation_ = committed_deformation_;
  }
} // namespace deltaform
