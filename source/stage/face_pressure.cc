#include <deltaform/contact/contact_measures.h>
#include <deltaform/stage/face_pressure.h>

namespace deltaform
{
  namespace
  {
    // Change of the transverse stress that is left to the next increment, over the initial flow stress; and corrections
    // after which any change is (doc/decisions/README.md).
    constexpr double negligible_change = .2;
    constexpr unsigned int most_corrections = 4;
  } // namespace


  FacePressure::FacePressure(const Actors &actors, const ContactSet &contact, const ReleasedForces &released)
    : actors_(actors), contact_(contact), released_(released),
      matters_(actors.blank->feels_pressure() && !actors.interfaces.empty())
  {
  }


  void FacePressure::begin_increment(const Vector &committed, const double time)
  {
    time_ = time;
    n_corrections_ = 0;
    if (matters_)
      actors_.blank->set_pressure(at(committed, &ContactInterface::committed));
  }


  bool FacePressure::correct(const Vector &q)
  {
    if (!matters_ || n_corrections_ == most_corrections || (n_corrections_ == 0 && is_nearly_accepted()))
      return false;
    const FaceValues pressure = at(q, &ContactInterface::trial);
    if (!(actors_.blank->pressure_change(pressure) > negligible_change))
      return false;
    actors_.blank->set_pressure(pressure);
    ++n_corrections_;
    return true;
  }


  bool FacePressure::is_nearly_accepted() const
  {
    double sum = 0.;
    for (const auto *interface : contact_.interfaces())
      sum += largest_pressure_change(*interface);
    return .5 * sum <= negligible_change * actors_.blank->initial_flow_stress();
  }


  FaceValues FacePressure::at(const Vector &q, const Points points) const
  {
    const unsigned int n_nodes = actors_.blank->surface().n_nodes();
    FaceValues pressure;
    pressure.fill(std::vector<double>(n_nodes, 0.));
    for (const auto *interface : contact_.interfaces())
      add_contact_pressure(*interface, (interface->*points)(), q, pressure);
    const double share = released_.share(time_);
    for (unsigned int side = 0; side < 2; ++side)
      for (unsigned int i = 0; share > 0. && i < released_.pressure[side].size(); ++i)
        pressure[side][i] += share * released_.pressure[side][i];
    return pressure;
  }
} // namespace deltaform
