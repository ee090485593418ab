#pragma once

#include <deltaform/parameters/parameter_tree.h>

#include <optional>
#include <string>
#include <vector>

namespace deltaform
{
  /**
   * A state from which a run goes on, in the file checkpoint.bin of its folder of results. It is written whole or not
   * at all, and read by the version of the program that wrote it only. The states of the parts are bytes that only
   * those parts understand.
   */
  struct Checkpoint
  {
    /// An entry of the scene, "Blank/Elements", and its value.
    struct Entry
    {
      std::string name, value;
    };

    std::vector<Entry> scene; ///< every entry with its value
    unsigned int increment = 0; ///< the last one that was accepted
    double time = 0; ///< at its end
    unsigned int stage = 0; ///< to which it belongs
    std::string state, observers; ///< in bytes: of the run (State), and what the observers remember

    /// The saved value of an entry; empty if the scene had none.
    std::string value(const std::string &entry) const;

    /// What is said of a file that cannot be read back.
    static std::string damaged(const std::string &folder);

    /// File name inside a folder of results.
    static std::string path(const std::string &folder);

    /// @throws SceneError if the file cannot be written
    void write(const std::string &folder) const;

    /// The state saved in a folder, if there is one. @throws SceneError if it is damaged or of another version.
    static std::optional<Checkpoint> read(const std::string &folder);

    /**
     * What the scene now says otherwise than the saved one, in words. Only entries that steer the computation may
     * differ: Title, Solver, Steps, Contact (but for Enforcement), Output, and allowed penetrations of tools.
     * @throws SceneError naming an entry that may not
     */
    std::vector<std::string> changes(const ParameterTree &tree) const;

    static std::vector<Entry> entries(const ParameterTree &tree);
  };
} // namespace deltaform
