// The columns of history.csv are part of the interface: add, do not rename.
#include "../solver/mpi.h"

#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/reports/accepted_increment.h>
#include <deltaform/reports/reported_columns.h>
#include <deltaform/scene/scene.h>

#include <boost/test/unit_test.hpp>

using namespace deltaform;

BOOST_AUTO_TEST_SUITE(reported_columns)

BOOST_AUTO_TEST_CASE(names_and_values)
{
  ParameterTree tree = ParameterTree::parse(
    "", "test",
    {"Blank/Points=0 0; 40 0", "Blank/Thickness=3", "Material/Young's modulus=206e3", "Material/Poisson's ratio=.3",
     "Material/Model=linear elastic", "Tools/Names=die 2", "Tools/die 2/Shape=plate", "Tools/die 2/Side=bottom",
     "Tools/die 2/Position z=-1.6", "Tools/die 2/Motion=t", "Supports/Names=no turn", "Supports/no turn/Boundary=start",
     "Supports/no turn/Component=rotation", "Loads/Names=weight", "Loads/weight/Kind=pressure",
     "Loads/weight/Value=t"});
  const Scene scene(tree);
  Timers timers;
  Model model(const_cast<Actors &>(scene.actors), *scene.linear_solver, timers);
  Columns columns;
  describe_increment(columns);
  describe_tools({"die 2"}, columns);
  describe_cost(columns);
  describe_contact(columns);
  describe_thickness(columns);
  describe_linear_solver(columns);
  describe_mesh(columns);
  describe_energies(columns);
  describe_supports({"no turn"}, columns);
  describe_loads({"weight"}, columns);
  describe_balance(columns);
  describe_load_sizes({"weight"}, columns);
  describe_pressures({"weight"}, columns);
  std::string names, dimensions;
  for (const auto &column : columns.columns())
  {
    names += column.name + ",";
    dimensions += column.dimension + ",";
    BOOST_TEST(!column.meaning.empty(), column.name);
  }
  BOOST_TEST(names == "increment,stage,time,die_2_travel,die_2_force_z,die_2_force_r,newton_iterations,penalty_rounds,"
                      "penalty_iterations,cutbacks,max_penetration,max_penetration_over_delta,"
                      "max_penetration_between_nodes,min_epsilon,max_epsilon,floor_share,contact_pairs,min_thickness,"
                      "linear_iterations,unknowns,cells,estimated_error,tool_work,elastic_energy,plastic_energy,"
                      "friction_energy,contact_energy,epsilon_work,thickness_work,load_work,energy_error,"
                      "no_turn_reaction,weight_force_z,weight_force_r,balance_error,"
                      "weight_size,weight_pressure,weight_volume,weight_height,");
  BOOST_TEST(dimensions == "1,1,time,length,force,force,1,1,1,1,length,1,length,force/length,force/length,1,1,length,"
                           "1,1,1,1,force*length,force*length,force*length,force*length,force*length,force*length,"
                           "force*length,force*length,1,force,force,force,1,load,stress,volume,length,");

  AcceptedIncrement increment(model, scene.actors.stages.front(), .5, 7, {5, 1, 2, 0, 3});
  const auto row = columns.row(increment);
  BOOST_REQUIRE(row.size() == columns.columns().size());
  BOOST_TEST(std::get<double>(row[0]) == 7.);
  BOOST_TEST(std::get<std::string>(row[1]) == increment.stage.name);
  BOOST_TEST(std::get<double>(row[2]) == .5);
  BOOST_TEST(std::get<double>(row[6]) == 5.);
  BOOST_TEST(std::get<double>(row[7]) == 1.);
  BOOST_TEST(std::get<double>(row[8]) == 2.);
  BOOST_TEST(std::get<double>(row[9]) == 3.);
  BOOST_TEST(std::get<double>(row[17]) == 3.);
}

BOOST_AUTO_TEST_SUITE_END()
