#pragma once
// The linear solvers need MPI, which is started as the program starts it. To be included in one file of the executable.
#include <deal.II/base/mpi.h>

#include <boost/test/unit_test.hpp>

#include <cstdlib>
#include <memory>

namespace
{
  struct Mpi
  {
    Mpi()
    {
      setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
      setenv("OMPI_MCA_btl", "self", 0);
      setenv("OMPI_MCA_pml", "ob1", 0);
      auto &suite = boost::unit_test::framework::master_test_suite();
      argc = suite.argc;
      argv = suite.argv;
      mpi = std::make_unique<dealii::Utilities::MPI::MPI_InitFinalize>(argc, argv, 1);
    }

    int argc;
    char **argv;
    std::unique_ptr<dealii::Utilities::MPI::MPI_InitFinalize> mpi;
  };
} // namespace

BOOST_TEST_GLOBAL_FIXTURE(Mpi);
