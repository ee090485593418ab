#pragma once

#include <deltaform/model/model.h>
#include <deltaform/model/next_state.h>
#include <deltaform/model/workspace.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/scene/scene.h>

#include <string>
#include <vector>

namespace deltaform
{
  namespace testing
  {
    /// A model of a scene, with what its next state is sought with.
    struct ModelFixture
    {
      explicit ModelFixture(const std::vector<std::string> &entries)
        : tree(ParameterTree::parse("", "test", entries)), scene(tree),
          model(scene.actors, *scene.linear_solver, timers), workspace(model), next(model, workspace)
      {
      }

      ParameterTree tree;
      Scene scene;
      Timers timers;
      Model model;
      Workspace workspace;
      NextState next;
    };
  } // namespace testing
} // namespace deltaform
