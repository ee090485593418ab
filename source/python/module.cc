// The compiled part of the Python package: scenes and runs as lists, dictionaries and arrays. What users see is in
// deltaform/__init__.py.
#include <deltaform/app/mpi_session.h>
#include <deltaform/app/run_in_memory.h>
#include <deltaform/io/units.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/process/processes.h>
#include <deltaform/process/ranks.h>
#include <deltaform/scene/input_warnings.h>
#include <deltaform/scene/scene.h>

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <unistd.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <mutex>
#include <sstream>

namespace py = pybind11;
using namespace deltaform;

namespace
{
  /// MPI, and the processes that were launched together.
  struct Session
  {
    Session(int argc, char **argv)
      : mpi(argc, argv), all(MPI_COMM_WORLD)
    {
    }

    const MpiSession mpi;
    const ranks::Processes all;
  };

  std::unique_ptr<Session> session;
  pid_t started_in = 0; ///< the process that has started MPI
  std::mutex one_at_a_time; ///< neither MPI nor Trilinos may be used by two threads

  /// The first scene that is built starts MPI, the interpreter's end ends it.
  void start_mpi()
  {
    if (session == nullptr)
    {
      static char name[] = "deltaform";
      static char *arguments[] = {name, nullptr};
      session = std::make_unique<Session>(1, arguments);
      started_in = getpid();
      py::module_::import("atexit").attr("register")(py::cpp_function([]() {
        if (started_in == getpid())
          session.reset();
      }));
    }
    if (started_in != getpid())
      throw std::runtime_error("this process is a copy of one that has already used deltaform, and MPI does not "
                               "survive that: start processes with multiprocessing.get_context('spawn')");
    if (ranks::count() > 1)
      throw std::runtime_error("several processes were launched together (mpirun): deltaform in Python runs a scene in "
                               "one; for several processes use the program");
  }


  /// What a scene is made of: a file or a text, and entries that replace those in it.
  struct Source
  {
    std::string name;
    std::optional<std::string> text; ///< none: the file of this name
    std::vector<std::string> sets; ///< "Section/Entry=value"

    std::unique_ptr<ParameterTree> tree() const
    {
      // Trees stay where they are made.
      return text ? std::unique_ptr<ParameterTree>(new auto(ParameterTree::parse(*text, name, sets)))
                  : std::unique_ptr<ParameterTree>(new auto(ParameterTree::read(name, sets)));
    }
  };


  /// Is it a number that is not known?
  bool unknown(const Columns::Cell &cell)
  {
    const auto *const word = std::get_if<std::string>(&cell);
    return word != nullptr && word->empty();
  }


  /// A column of @p n cells: numbers as an array, with NaN where one is not known, words as a list.
  template <typename CellAt>
  py::object column_of(const std::size_t n, const CellAt &cell_at)
  {
    bool numbers = true;
    for (std::size_t i = 0; i < n && numbers; ++i)
      numbers = std::holds_alternative<double>(cell_at(i)) || unknown(cell_at(i));
    if (!numbers)
    {
      py::list words;
      for (std::size_t i = 0; i < n; ++i)
        words.append(py::cast(cell_at(i)));
      return std::move(words);
    }
    py::array_t<double> values(static_cast<py::ssize_t>(n));
    for (std::size_t i = 0; i < n; ++i)
      values.mutable_at(static_cast<py::ssize_t>(i)) =
        unknown(cell_at(i)) ? std::numeric_limits<double>::quiet_NaN() : std::get<double>(cell_at(i));
    return std::move(values);
  }


  /// A list of (name, unit, values).
  template <typename Columns, typename Dimension, typename Rows>
  py::list table_of(const Columns &columns, const Dimension &dimension, const Rows &rows, const Units &units)
  {
    py::list result;
    for (std::size_t k = 0; k < columns.size(); ++k)
      result.append(py::make_tuple(columns[k].name, units.of(dimension(columns[k])),
                                   column_of(rows.size(), [&](const std::size_t i) { return rows[i][k]; })));
    return result;
  }


  py::list table_of(const MixedTable &table, const Units &units)
  {
    return table_of(
      table.columns, [](const CsvWriter::Column &column) { return column.unit; }, table.rows, units);
  }


  py::list table_of(const Table &table, const Units &units)
  {
    py::list result;
    for (std::size_t k = 0; k < table.names.size(); ++k)
      result.append(py::make_tuple(
        table.names[k], units.of(table.units[k]),
        column_of(table.rows.size(), [&](const std::size_t i) { return Columns::Cell(table.rows[i][k]); })));
    return result;
  }


  py::dict as_dictionary(const RunRecord &record)
  {
    const Units units(record.units);
    py::list states;
    for (const Snapshot &state : record.snapshots)
    {
      py::dict one;
      one["stage"] = state.stage;
      one["time"] = state.time;
      one["travel"] = state.travel;
      one["profile"] = table_of(state.profile, units);
      one["contact"] = table_of(state.contact, units);
      one["outlines"] = table_of(state.outlines, units);
      states.append(one);
    }
    py::dict result;
    result["title"] = record.title;
    result["units"] = record.units;
    result["axisymmetric"] = record.axisymmetric;
    result["exit_status"] = record.exit_status;
    result["message"] = record.message;
    result["history"] = table_of(
      record.columns, [](const Columns::Column &column) { return column.dimension; },
      record.history, units);
    result["states"] = states;
    result["summary"] = record.summary;
    result["log"] = record.log;
    return result;
  }


  /// Signals are looked at after every increment; what @p progress raises ends the run.
  AfterIncrement watch(const py::object &progress)
  {
    return [&progress](const std::vector<Columns::Column> &columns, const Columns::Row &row) {
      const py::gil_scoped_acquire python;
      if (PyErr_CheckSignals() != 0)
        throw py::error_already_set();
      if (progress.is_none())
        return;
      py::dict cells;
      for (std::size_t k = 0; k < columns.size(); ++k)
        cells[py::str(columns[k].name)] = py::cast(row[k]);
      progress(cells);
    };
  }


  py::dict run(const Source &source, const bool every_increment, const py::object &progress)
  {
    start_mpi();
    RunRecord record;
    {
      const py::gil_scoped_release others;
      const std::lock_guard<std::mutex> lock(one_at_a_time);
      const auto tree = source.tree();
      record = run_in_memory(*tree, every_increment ? Keep::every_increment : Keep::asked, watch(progress));
    }
    return as_dictionary(record);
  }


  /// Build the scene, which checks it, and look at it.
  template <typename Look>
  auto with_scene(const Source &source, const Look &look)
  {
    start_mpi();
    const py::gil_scoped_release others;
    const std::lock_guard<std::mutex> lock(one_at_a_time);
    const auto tree = source.tree();
    const Scene scene(*tree);
    return look(scene);
  }


  std::vector<std::pair<std::string, std::string>> entries(const Source &source)
  {
    return with_scene(source, [](const Scene &scene) {
      std::vector<std::pair<std::string, std::string>> result;
      for (const auto &value : scene.tree.values())
        result.emplace_back(to_string(value.path, value.name), value.text);
      return result;
    });
  }


  std::string completed(const Source &source)
  {
    return with_scene(source, [](const Scene &scene) {
      std::ostringstream out;
      scene.tree.print_prm(out);
      return out.str();
    });
  }


  std::vector<std::string> warnings(const Source &source)
  {
    return with_scene(source, [](const Scene &scene) { return input_warnings(scene); });
  }
} // namespace


PYBIND11_MODULE(_deltaform, module)
{
  module.doc() = "The compiled part of deltaform.";
  module.attr("version") = DELTAFORM_VERSION;
  py::register_exception<SceneError>(module, "SceneError", PyExc_ValueError);
  py::class_<Source>(module, "Source")
    .def(py::init([](const std::string &name, const std::optional<std::string> &text,
                     const std::vector<std::string> &sets) { return Source{name, text, sets}; }));
  module.def("read", [](const Source &source) { source.tree(); });
  module.def("entries", &entries);
  module.def("completed", &completed);
  module.def("warnings", &warnings);
  module.def("run", &run);
  module.def("mpi_started", []() { return session != nullptr; });
}
