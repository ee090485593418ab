#pragma once

#include <deltaform/assembly/types.h>
#include <deltaform/io/keyed_arrays.h>
#include <deltaform/stage/released_forces.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace deltaform
{
  /// Work done on the blank since the start, other than by its own energies.
  struct Work
  {
    double tools = 0; ///< by the tools
    double loads = 0; ///< by loads, supports and released forces
    double dissipated_before = 0; ///< by plastic flow, in the operation before
  };

  /// The state of a model at the end of an increment: a value that can be copied, kept, and gone back to.
  struct ModelState
  {
    double time = 0;
    std::string stage; ///< name of the one that it belongs to; empty: none has begun
    Vector unknowns;
    Vector hold; ///< what supports hold in the present stage
    ReleasedForces released;
    bool releases_at_once = false; ///< do released forces vanish in the next increment?

    /// @name Forces in equilibrium
    ///@{
    std::vector<Tensor1> tool_forces; ///< of the blank on the tools
    std::vector<double> travels; ///< of the tools
    std::vector<Tensor1> load_resultants;
    std::vector<std::vector<double>> load_histories; ///< of each load; empty: it remembers nothing
    Vector load_forces; ///< on the unknowns: loads, supports, released
    Vector reactions; ///< of the supports
    ///@}

    Work work;
    double largest_force = 0; ///< norm of all nodal forces so far
    double largest_resultant = 0; ///< of a tool, a support or a load so far

    KeyedArrays body; ///< of the cells of this process
    std::vector<std::string> interfaces; ///< contact points, in bytes that only the interfaces understand

    /// Write the state to a stream; all processes write the same. @throws SceneError
    void save(std::ostream &stream) const;

    /// @throws SceneError if it was saved by another number of processes
    void load(std::istream &stream);
  };
} // namespace deltaform
