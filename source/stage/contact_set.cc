#include <deltaform/contact/contact_measures.h>
#include <deltaform/io/byte_stream.h>
#include <deltaform/parameters/text.h>
#include <deltaform/stage/contact_set.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace deltaform
{
  namespace
  {
    /// Move a tool along its direction until it touches, by its unknown @p travel. @return has it found the blank?
    bool bring_into_contact(const ContactInterface &interface, const double extent, double &travel, const Vector &q)
    {
      // The distance is Lipschitz: going by the gap never goes too far.
      constexpr unsigned int most_steps = 1000;
      const double reach = 1e3 * (1. + extent);
      for (unsigned int step = 0; step < most_steps; ++step)
      {
        const double gap = interface.projector().closest(q, travel * interface.tool().direction()).second;
        if (!(gap < reach))
          return false;
        if (gap <= 1e-12 * extent)
          return true;
        travel += gap;
      }
      return false;
    }


    /// Why the run cannot go on: the contact point @p i penetrates @p ratio times what is allowed.
    std::string broken_promise_in_words(const ContactInterface &interface, const unsigned int i, const double ratio,
                                        const bool at_nodes, const Vector &committed)
    {
      const ContactPointState &state = interface.trial()[i];
      return "the promise penetration <= delta cannot be kept: tool '" + interface.tool().name() +
             (at_nodes ? "', node " : "', contact point ") + std::to_string(i) +
             " (R0 = " + text::rounded(interface.point(committed, i).reference_coordinate) + ") penetrates " +
             text::rounded(state.penetration()) + ", " + text::rounded(ratio) + " times the allowed " +
             text::rounded(state.delta) + ", with penalty factor " + text::rounded(state.penalty_factor);
    }


    /// What to try where the node of the contact point @p i also touches a tool on the other side; else empty.
    std::string clamped_in_words(const ContactInterface &interface, const unsigned int i,
                                 const std::vector<ContactInterface *> &active, const Vector &committed)
    {
      const ContactPoint point = interface.point(committed, i);
      std::string sentence;
      for (const auto *other : active)
        if (other->tool().side() != interface.tool().side() && i < other->n_points() && other->trial()[i].touching &&
            other->point(committed, i).nodes[0].node == point.nodes[0].node)
          sentence += ". The node is clamped between '" + interface.tool().name() + "' and '" + other->tool().name() +
                      "': its thickness is " + text::rounded(point.thickness) + ", the gap leaves " +
                      text::rounded(point.thickness + interface.trial()[i].gap + other->trial()[i].gap) +
                      ". Use Contact thickness = initial for the tool with the fixed gap, a wider gap, or a force";
      return sentence;
    }
  }


  ContactSet::ContactSet(Actors &actors)
    : actors_(actors)
  {
  }


  void ContactSet::enter_stage(const Stage &stage)
  {
    active_.clear();
    for (auto &interface : actors_.interfaces)
      if (interface->tool().exists_in(stage.name))
        active_.push_back(interface.get());
  }


  bool ContactSet::takes_part(const ContactInterface &interface) const
  {
    return std::find(active_.begin(), active_.end(), &interface) != active_.end();
  }


  std::vector<std::string> ContactSet::begin_stage(const double time, const double extent, Vector &q)
  {
    std::vector<std::string> lost;
    for (auto *interface : active_)
    {
      const Tool &tool = interface->tool();
      if (tool.force_driven() && interface->n_touching() == 0 &&
          !bring_into_contact(*interface, extent, q[interface->travel_dof()], q))
        lost.push_back(tool.name());
      interface->begin_stage(q, time);
    }
    return lost;
  }


  std::vector<double> ContactSet::travels(const Vector &q) const
  {
    std::vector<double> result;
    for (const auto &interface : actors_.interfaces)
      result.push_back(interface->tool().force_driven() ? q[interface->travel_dof()] : 0.);
    return result;
  }


  void ContactSet::set_travels(const std::vector<double> &travels, Vector &q) const
  {
    for (unsigned int i = 0; i < actors_.interfaces.size(); ++i)
      if (const ContactInterface &interface = *actors_.interfaces[i]; interface.tool().force_driven())
        q[interface.travel_dof()] = travels[i];
  }


  void ContactSet::transfer(Vector &q)
  {
    for (auto &interface : actors_.interfaces)
    {
      interface->transfer(q, actors_.blank->adaptive()->point_origins(interface->tool().side()));
      interface->start_multipliers(q);
    }
  }


  void ContactSet::resize()
  {
    for (auto &interface : actors_.interfaces)
      interface->resize();
  }


  std::vector<std::string> ContactSet::save() const
  {
    std::vector<std::string> result;
    for (const auto &interface : actors_.interfaces)
    {
      ByteStream bytes;
      {
        boost::archive::binary_oarchive archive(bytes.stream());
        archive << static_cast<const ContactInterface &>(*interface);
      }
      result.push_back(bytes.take());
    }
    return result;
  }


  void ContactSet::load(const std::vector<std::string> &bytes)
  {
    for (std::size_t i = 0; i < actors_.interfaces.size(); ++i)
    {
      std::istringstream stream(bytes[i]);
      boost::archive::binary_iarchive archive(stream);
      archive >> *actors_.interfaces[i];
    }
  }


  void ContactSet::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    if (!actors_.contact || !actors_.contact->normal_law->has_multiplier())
      return;
    const Vector zero(actors_.blank->n_dofs());
    for (const auto &interface : actors_.interfaces)
      for (unsigned int i = 0; i < interface->n_points(); ++i)
      {
        const ContactPoint node = interface->point(zero, i);
        const DofIndex multiplier = interface->multiplier_dof(i);
        for (unsigned int k = 0; k < node.n_dofs; ++k)
        {
          pattern.add(node.dofs[k], multiplier);
          pattern.add(multiplier, node.dofs[k]);
        }
      }
  }


  Status ContactSet::assemble(const Vector &q, double /*time*/, AssemblyTarget &target) const
  {
    for (auto *interface : active_)
      interface->assemble(q, target);
    return {};
  }


  double ContactSet::limit_travels(Vector &d, const double length) const
  {
    double factor = 1.;
    for (const auto *interface : active_)
      if (interface->tool().force_driven())
      {
        // A tool that has lost contact for a moment goes back to the blank, on its own: were the whole step shortened
        // by what this component is too long, the blank would hardly move.
        double &travel = d[interface->travel_dof()];
        const double closest = interface->free_travel();
        if (closest > 0)
          travel = std::clamp(travel, -std::min(closest, length), std::min(closest, length));
        factor = std::min(factor, length / std::max(std::abs(travel), 1e-300));
      }
    return factor;
  }


  std::string ContactSet::broken_promise(const Vector &committed) const
  {
    if (!actors_.contact || !actors_.contact->normal_law->uses_penalty() || !actors_.contact->rule->promises())
      return "";
    for (const auto *interface : active_)
    {
      const auto [i, ratio] = FactorControl::broken_promise(interface->trial());
      if (i == invalid_index)
        continue;
      const bool at_nodes = actors_.blank->surface().points_per_edge() == 0;
      return broken_promise_in_words(*interface, i, ratio, at_nodes, committed) +
             clamped_in_words(*interface, i, active_, committed);
    }
    return "";
  }


  std::array<std::vector<double>, 2>
  ContactSet::longest_edges(const Vector &committed, const EdgeWishes &wishes) const
  {
    std::array<EdgeWishes, 2> of_sides{{wishes, wishes}};
    for (const auto *interface : active_)
      if (wishes.smooth && !interface->tool().force_driven())
        clamp_edges(*interface, of_sides[interface->tool().side() == Side::top ? 1 : 0].clamped);
    std::array<std::vector<double>, 2> longest;
    for (const auto *interface : active_)
    {
      const auto side = static_cast<unsigned int>(interface->tool().side());
      shorten_edges(*interface, committed, of_sides[side], longest[side]);
    }
    return longest;
  }


  void ContactSet::accept(const Vector &q, double /*time*/, double /*duration*/)
  {
    for (auto *interface : active_)
      interface->commit(q);
  }


  void ContactSet::add_to(EnergyAccount &account) const
  {
    // Also of tools that have left.
    ContactEnergy energy;
    for (const auto &interface : actors_.interfaces)
      energy += interface->energy();
    account.friction += energy.friction;
    account.friction_error += energy.friction_error();
    account.climbing += energy.climbing;
    account.contact += energy.stored;
    account.epsilon_work += energy.epsilon;
    account.thickness_work += energy.thickness;
  }


  void ContactSet::count_no_energy()
  {
    for (auto &interface : actors_.interfaces)
      interface->count_no_energy();
  }
} // namespace deltaform
