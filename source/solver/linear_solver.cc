// The choice of a linear solver, and the matrix that all of them work on.
#include "trilinos_matrix.h"

#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>
#include <deltaform/process/ranks.h>
#include <deltaform/solver/linear_method.h>

#include <Epetra_MpiComm.h>

#include <numeric>
#include <utility>

namespace deltaform
{
  namespace
  {
    std::vector<std::string> choices()
    {
      std::vector<std::string> result = Registry<LinearMethod>::names();
      result.insert(result.begin(), "automatic");
      return result;
    }
  } // namespace


  std::shared_ptr<const LinearMethod> LinearSolverSettings::method_called(const std::string &name)
  {
    // A method has no entries of its own: tolerances are those of all.
    ParameterTree none = ParameterTree::parse("", "no scene");
    Section section = none.root();
    return Registry<LinearMethod>::make(name, section);
  }


  LinearSolverSettings::LinearSolverSettings(Section &section)
    : name(section.choice("Linear solver",
                          "automatic",
                          choices(),
                          "automatic: klu or mumps, by the size and shape of the mesh. Direct: klu for thin strips, "
                          "mumps for blocks. Iterative, for large solids: conjugate gradients (cg, no friction) or "
                          "GMRES, preconditioned by algebraic multigrid (amg), by the blocks of the nodes or by the "
                          "diagonal.")),
      automatic(name == "automatic"),
      method(method_called(automatic ? "klu" : name)),
      tolerance(section.number("Linear solver tolerance",
                               1e-10,
                               Range::inside(0, 1),
                               "1",
                               "Residual of an iterative linear solver over the right side.")),
      max_iterations(section.integer("Maximal linear iterations",
                                     2000,
                                     1,
                                     1000000,
                                     "Largest number of iterations of an iterative linear solver in a solve; with more "
                                     "the increment fails.")),
      linear_path(section.choice("Linear path",
                                 "automatic",
                                 {"automatic", "off"},
                                 "automatic: assemble and factorize the stiffness of a linear elastic solid of small "
                                 "strain once, and condense contact to its unknowns; off: as for any other "
                                 "blank.") == "automatic")
  {
  }


  LinearSolverSettings::LinearSolverSettings(std::string the_name)
    : name(std::move(the_name)), method(method_called(name))
  {
  }


  TrilinosMatrix::TrilinosMatrix(const dealii::DynamicSparsityPattern &pattern)
  {
    whole.reinit(pattern);
    // The wrapper only hands out a const reference to the matrix that it owns.
    crs = &const_cast<Epetra_CrsMatrix &>(whole.trilinos_matrix());
    make_vectors();
  }


  TrilinosMatrix::TrilinosMatrix(const dealii::DynamicSparsityPattern &pattern,
                                 const DofIndex first,
                                 const DofIndex end)
    : is_distributed(true)
  {
    std::vector<int> own(end - first), lengths;
    std::iota(own.begin(), own.end(), static_cast<int>(first));
    for (DofIndex i = first; i < end; ++i)
      lengths.push_back(static_cast<int>(pattern.row_length(i)));
    const Epetra_Map map(static_cast<int>(pattern.n_rows()),
                         static_cast<int>(own.size()),
                         own.data(),
                         0,
                         Epetra_MpiComm(ranks::communicator()));
    part = std::make_unique<Epetra_CrsMatrix>(Copy, map, lengths.data(), true);
    std::vector<int> columns;
    std::vector<double> zeros;
    for (DofIndex i = first; i < end; ++i)
    {
      columns.clear();
      for (auto column = pattern.begin(i); column != pattern.end(i); ++column)
        columns.push_back(static_cast<int>(column->column()));
      zeros.resize(columns.size(), 0.);
      part->InsertGlobalValues(static_cast<int>(i), static_cast<int>(columns.size()), zeros.data(), columns.data());
    }
    part->FillComplete();
    part->OptimizeStorage();
    crs = part.get();
    make_vectors();
  }


  void TrilinosMatrix::make_vectors()
  {
    solution = std::make_unique<Epetra_Vector>(crs->DomainMap());
    right_side = std::make_unique<Epetra_Vector>(crs->RangeMap());
    problem = std::make_unique<Epetra_LinearProblem>(crs, solution.get(), right_side.get());
  }


  bool TrilinosMatrix::all(const bool good) const
  {
    return is_distributed ? ranks::min(good ? 1. : 0.) > 0 : good;
  }


  bool LinearSolverSettings::iterative() const
  {
    return method->iterative();
  }


  std::unique_ptr<LinearSolver> LinearSolver::local(const LinearSolverSettings &settings,
                                                    const dealii::DynamicSparsityPattern &pattern)
  {
    return settings.method->make(settings, std::make_unique<TrilinosMatrix>(pattern));
  }


  std::unique_ptr<LinearSolver> LinearSolver::distributed(const LinearSolverSettings &settings,
                                                          const dealii::DynamicSparsityPattern &pattern,
                                                          const DofIndex first,
                                                          const DofIndex end)
  {
    return settings.method->make(settings, std::make_unique<TrilinosMatrix>(pattern, first, end));
  }
} // namespace deltaform
