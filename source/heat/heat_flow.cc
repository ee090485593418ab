#include <deltaform/heat/heat_flow.h>
#include <deltaform/heat/heat_system.h>
#include <deltaform/parameters/section.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  double HeatAccount::error() const
  {
    const double largest =
      std::max({std::abs(stored), std::abs(flow), std::abs(friction), std::abs(tools), std::abs(surroundings)});
    return largest > 0. ? (stored - (flow + friction - tools - surroundings)) / largest : 0.;
  }


  std::unique_ptr<HeatFlow>
  HeatFlow::read(const Section &root, Blank &blank, const std::vector<std::unique_ptr<ContactInterface>> &interfaces)
  {
    Section heat = root.sub("Heat");
    const auto names =
      heat.section_names("Names", "", "What surrounds the blank and exchanges heat with it, one subsection each.");
    if (heat.documentation())
    {
      const Film film(heat.sub("<name>"), blank);
      const ToolHeat tool(root.sub("Tools").sub("<name>").sub("Heat"), MetalHeat());
    }
    if (blank.conducting() == nullptr)
    {
      if (!names.empty())
        heat.fail("Names", "the blank does not conduct: state Material/Heat/Conductivity.");
      return nullptr;
    }
    std::unique_ptr<HeatFlow> result(new HeatFlow(blank));
    for (const auto &interface : interfaces)
    {
      const Section own = root.sub("Tools").sub(interface->tool().name()).sub("Heat");
      const Tool &tool = interface->tool();
      const auto effusivity = result->tools_.emplace(&tool, ToolHeat(own, blank.conducting()->metal()))
                                .first->second.effusivity();
      if (effusivity)
        result->half_spaces_.emplace(&tool, HalfSpace(*effusivity, result->n_points(tool)));
    }
    for (const auto &name : names)
      result->films_.emplace_back(heat.sub(name), blank);
    return result;
  }


  namespace
  {
    /// Over what touches of the points from @p first to before @p end (stress).
    double mean_pressure(const std::vector<ContactPointState> &points, const unsigned int first, const unsigned int end)
    {
      double force = 0., area = 0.;
      for (unsigned int i = first; i < end; ++i)
        if (points[i].touching)
        {
          force += points[i].force;
          area += points[i].area;
        }
      return area > 0. ? force / area : 0.;
    }
  } // namespace


  HeatFlow::HeatFlow(Blank &blank)
    : blank_(blank), conducting_(*blank.conducting()), rise_(blank.n_dofs())
  {
  }


  unsigned int HeatFlow::n_points(const Tool &tool) const
  {
    return blank_.surface().n_contact_points(tool.side());
  }


  std::vector<HeatFlow::Exchange> HeatFlow::with_tools(const double duration,
                                                       const Vector &q,
                                                       const std::vector<ContactInterface *> &interfaces,
                                                       std::vector<bool> &touches,
                                                       std::vector<Crossing> &crossings)
  {
    std::vector<Exchange> result;
    for (const ContactInterface *const interface : interfaces)
    {
      const ToolHeat &tool = tools_.at(&interface->tool());
      const auto half_space = half_spaces_.find(&interface->tool());
      const unsigned int group = interface->projector().group();
      double pressure = 0.;
      for (unsigned int i = 0; i < interface->n_points(); ++i)
      {
        // Which of the points of an edge carry its force is nearly arbitrary.
        if (i % group == 0)
          pressure = mean_pressure(interface->committed(), i, i + group);
        // A point that has let go may have slipped before.
        const ContactPointState &state = interface->committed()[i];
        const double friction = interface->account().friction_work()[i];
        if (!state.touching && friction == 0.)
          continue;
        const ContactPoint point = interface->point(q, i);
        double conductance = state.touching ? tool.conductance(pressure) : 0.;
        double outside = tool.rise();
        if (half_space != half_spaces_.end() && point.area > 0. && duration > 0.)
        {
          const double area = point.area * duration, flux = (1. - tool.blank_share()) * friction / area;
          const auto [seen, rise] = half_space->second.joint(i, conductance, flux);
          conductance = seen;
          outside += rise;
          crossings.push_back({&half_space->second, i, area, flux, result.size(), result.size() + point.n_nodes});
        }
        for (unsigned int a = 0; a < point.n_nodes; ++a)
        {
          const auto [node, share] = point.nodes[a];
          result.push_back({node, share * duration * (conductance * point.area), outside,
                            share * tool.blank_share() * friction});
          touches[node] = touches[node] || state.touching;
        }
      }
    }
    return result;
  }


  std::vector<HeatFlow::Exchange>
  HeatFlow::with_surroundings(const double duration, const Vector &q, const std::vector<bool> &touches) const
  {
    std::vector<Exchange> result;
    for (const Film &film : films_)
      film.each_area(conducting_, q, touches, [&](const unsigned int node, const double area) {
        result.push_back({node, duration * film.coefficient() * area, film.rise(), 0.});
      });
    return result;
  }


  double HeatFlow::lost(const std::vector<Exchange> &exchanges, const std::size_t first, const std::size_t end) const
  {
    double sum = 0.;
    for (std::size_t i = first; i < end; ++i)
      sum += exchanges[i].conductance * (rise_[conducting_.place_of(exchanges[i].node)] - exchanges[i].outside);
    return sum;
  }


  void HeatFlow::heat_tools(const std::vector<Exchange> &exchanges, const std::vector<Crossing> &crossings)
  {
    std::map<const HalfSpace *, std::vector<double>> flux;
    for (const auto &one : half_spaces_)
      flux[&one.second].resize(one.second.n_points(), 0.);
    for (const Crossing &one : crossings)
      flux[one.half_space][one.point] = one.flux + lost(exchanges, one.first, one.end) / one.area;
    for (auto &one : half_spaces_)
      one.second.end(flux[&one.second]);
  }


  void HeatFlow::advance(const double duration, const Vector &q, const std::vector<ContactInterface *> &interfaces)
  {
    std::vector<bool> touches(blank_.surface().n_nodes(), false);
    for (auto &one : half_spaces_)
      one.second.begin(duration);
    std::vector<Crossing> crossings;
    const auto tools = with_tools(duration, q, interfaces, touches, crossings);
    const auto surroundings = with_surroundings(duration, q, touches);

    HeatSystem system(rise_.size());
    conducting_.assemble(q, rise_, duration, system);
    system.share();
    for (const auto *const exchanges : {&tools, &surroundings})
      for (const Exchange &one : *exchanges)
      {
        const DofIndex place = conducting_.place_of(one.node);
        const double residual = one.conductance * (rise_[place] - one.outside) - one.heat;
        system.add(&place, 1, &one.conductance, &residual);
        account_.friction += one.heat;
      }
    account_.flow += conducting_.heat_of_flow(rise_);
    rise_ += system.solve();
    account_.tools += lost(tools, 0, tools.size());
    account_.surroundings += lost(surroundings, 0, surroundings.size());
    heat_tools(tools, crossings);
    conducting_.give(rise_);
    account_.stored = conducting_.stored_heat();
  }


  std::vector<double> HeatFlow::temperatures() const
  {
    std::vector<double> result = conducting_.at_nodes(rise_);
    for (double &value : result)
      value += conducting_.metal().initial_temperature;
    return result;
  }


  std::optional<std::pair<double, double>> HeatFlow::tool_temperatures() const
  {
    if (half_spaces_.empty())
      return std::nullopt;
    std::pair<double, double> result{std::numeric_limits<double>::infinity(),
                                     -std::numeric_limits<double>::infinity()};
    for (const auto &[tool, half_space] : half_spaces_)
    {
      const double start = tools_.at(tool).rise() + conducting_.metal().initial_temperature;
      for (const double rise : half_space.rise())
        result = {std::min(result.first, start + rise), std::max(result.second, start + rise)};
    }
    return result;
  }


  void HeatFlow::set_rise(const Vector &rise)
  {
    rise_.reinit(blank_.n_dofs());
    std::copy_n(rise.begin(), rise_.size(), rise_.begin());
    conducting_.give(rise_);
    for (auto &one : half_spaces_)
      one.second.transfer(blank_.adaptive()->point_origins(one.first->side()));
  }


  void HeatFlow::put(KeyedArrays &state) const
  {
    state.put("rise of the temperature of nodes", std::vector<double>(rise_.begin(), rise_.end()));
    state.put("heat since the start", std::vector<double>{account_.stored, account_.flow, account_.friction,
                                                          account_.tools, account_.surroundings});
    for (const auto &[tool, half_space] : half_spaces_)
      state.put("heat in the tool " + tool->name(), half_space.state());
  }


  void HeatFlow::take(const KeyedArrays &state)
  {
    std::vector<double> rise(blank_.n_dofs()), sums(5);
    state.take("rise of the temperature of nodes", rise);
    state.take("heat since the start", sums);
    rise_.reinit(blank_.n_dofs());
    std::copy(rise.begin(), rise.end(), rise_.begin());
    account_ = {sums[0], sums[1], sums[2], sums[3], sums[4]};
    for (auto &[tool, half_space] : half_spaces_)
      half_space.set_state(state.at("heat in the tool " + tool->name()), n_points(*tool));
  }
} // namespace deltaform
