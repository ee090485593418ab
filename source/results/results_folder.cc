#include <deltaform/base/atomic_file.h>
#include <deltaform/base/ranks.h>
#include <deltaform/base/scene_error.h>
#include <deltaform/model/checkpoint.h>
#include <deltaform/results/earlier_run.h>
#include <deltaform/results/results_folder.h>

#include <deal.II/base/config.h>

#include <filesystem>

namespace deltaform
{
  ResultsFolder::ResultsFolder(const ResultsHead &head, const std::function<void(std::ostream &)> &print_scene,
                               Journal &journal, Timers &timers, const bool resumed)
    : folder_(head.folder), title_(head.title), label_(head.units), units_(head.units),
      comments_{head.title, "deltaform " DELTAFORM_VERSION ", units: " + head.units,
                std::string("Forces are those of the blank on the tool, ") +
                  (head.axisymmetric ? "for the full circumference (2 pi)." : "per unit width (plane strain).")},
      journal_(journal), timers_(timers)
  {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error)
      throw SceneError("Cannot make the folder '" + folder_ + "' for the results: " + error.message() +
                       ". Choose another with --output or Output/Folder.");
    // State and results of an earlier run must not be taken for those of this run.
    if (!resumed && ranks::first())
      std::filesystem::remove(Checkpoint::path(folder_), error);
    if (ranks::first())
      std::filesystem::remove(path("summary.json"), error);
    write_file_atomically(path("scene.prm"), [&](std::ostream &out) {
      out << "# deltaform " << DELTAFORM_VERSION << ", deal.II " << DEAL_II_PACKAGE_VERSION
          << ": the scene as read, with every default.\n";
      print_scene(out);
    });
    journal_.open_log(path("run.log"), resumed);
    // Before the first file of the same kind is written.
    if (!resumed)
      behind_.run([folder = folder_]() { remove_earlier_results(folder); });
  }
} // namespace deltaform
