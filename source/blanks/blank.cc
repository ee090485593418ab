#include <deltaform/blanks/blank.h>

#include <algorithm>

namespace deltaform
{
  KeyedArrays Blank::formed(const Vector &q)
  {
    KeyedArrays result = state();
    result.put("unknowns", std::vector<double>(q.begin(), q.begin() + n_dofs()));
    std::vector<double> places;
    for (const auto &x : positions(Vector(n_dofs())))
      places.insert(places.end(), {x[0], x[1]});
    result.put("undeformed places of nodes", places);
    return result;
  }


  bool Blank::has_nodes_of(const KeyedArrays &formed) const
  {
    const std::vector<double> &places = formed.at("undeformed places of nodes");
    const auto own = positions(Vector(n_dofs()));
    if (places.size() != 2 * own.size())
      return false;
    for (std::size_t i = 0; i < own.size(); ++i)
      if (own[i].distance(Point2(places[2 * i], places[2 * i + 1])) > 1e-9 * typical_length())
        return false;
    return true;
  }


  TakenOver Blank::take_formed(const KeyedArrays &formed)
  {
    if (!has_nodes_of(formed))
      throw SceneError("the earlier operation had another mesh, and a blank of this kind keeps its mesh from one "
                       "operation to the next. Give it the section Blank of the earlier scene");
    set_state(formed);
    const auto &unknowns = formed.at("unknowns");
    if (unknowns.size() != n_dofs())
      throw SceneError("the state of the earlier operation has " + std::to_string(unknowns.size()) +
                       " unknowns, this blank has " + std::to_string(n_dofs()) + ": it is damaged");
    return {Vector(unknowns.begin(), unknowns.end()), std::nullopt};
  }
} // namespace deltaform
