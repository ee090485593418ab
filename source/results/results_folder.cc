#include <deltaform/io/atomic_file.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/process/ranks.h>
#include <deltaform/reports/checkpoint.h>
#include <deltaform/results/earlier_run.h>
#include <deltaform/results/results_folder.h>

#include <deal.II/base/config.h>

#include <filesystem>

namespace deltaform
{
  namespace
  {
    const std::string &made(const std::string &folder)
    {
      std::error_code error;
      std::filesystem::create_directories(folder, error);
      if (error)
        throw SceneError("Cannot make the folder '" + folder + "' for the results: " + error.message() +
                         ". Choose another with --output or Output/Folder.");
      return folder;
    }
  } // namespace


  ResultsFolder::ResultsFolder(const ResultsHead &head, Journal &journal, Timers &timers, const bool force)
    : folder_(head.folder), title_(head.title), label_(head.units), lock_(made(folder_), force), units_(head.units),
      comments_{head.title, "deltaform " DELTAFORM_VERSION ", units: " + head.units,
                std::string("Forces are those of the blank on the tool, ") +
                  (head.axisymmetric ? "for the full circumference (2 pi)." : "per unit width (plane strain).")},
      journal_(journal), timers_(timers)
  {
  }


  void ResultsFolder::begin(const std::function<void(std::ostream &)> &print_scene, const bool resumed)
  {
    std::error_code error;
    if (ranks::first())
      remove_drafts(folder_);
    // State and results of an earlier run must not be taken for those of this run.
    if (ranks::first())
      for (const std::string &file : {path("summary.json"), resumed ? "" : Checkpoint::path(folder_)})
        if (!file.empty() && (std::filesystem::remove(file, error), error))
          throw SceneError("Cannot remove '" + file + "' of an earlier run: " + error.message() + ".");
    write_file_atomically(path("scene.prm"), [&](std::ostream &out) {
      out << "# deltaform " << DELTAFORM_VERSION << ", deal.II " << DEAL_II_PACKAGE_VERSION
          << ": the scene as read, with every default.\n";
      print_scene(out);
    });
    journal_.open_log(path("run.log"), resumed);
    // Before the first file of the same kind is written.
    if (!resumed)
      writer_.run([folder = folder_]() { remove_earlier_results(folder); });
  }
} // namespace deltaform
