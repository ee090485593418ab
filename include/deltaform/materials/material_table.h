#pragma once

#include <deltaform/parameters/scene_file.h>

#include <string>
#include <vector>

namespace deltaform
{
  /// Metals by name: a file in the language of scenes with a subsection per metal, which holds a Source and what
  /// section Material of a scene may hold (share/materials.prm). Stresses are in MPa.
  class MaterialTable
  {
  public:
    /// @throws SceneError if the file cannot be read
    explicit MaterialTable(const std::string &file_name);

    /// The file that comes with the program; empty if it is missing.
    static std::string shipped();

    /// In alphabetical order.
    std::vector<std::string> names() const;

    /// Where the constants of a metal come from; empty if nothing is said.
    std::string source(const std::string &metal) const;

    /**
     * The entries of a metal for section Material of a scene.
     * @param unit_of_stress of the scene, in Pa
     * @param rolling_direction has the blank one? Then r0 and r90 are taken, else their mean
     * @throws SceneError if a stress has no number
     */
    std::vector<SceneFile::Entry>
    entries(const std::string &metal, double unit_of_stress, bool rolling_direction) const;

  private:
    SceneFile file_;
  };
} // namespace deltaform
