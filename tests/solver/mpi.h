#pragma once
// The linear solvers need MPI, which is started as the program starts it. To be included in one file of the executable.
#include <deltaform/app/mpi_session.h>

#include <boost/test/unit_test.hpp>

namespace
{
  struct Mpi
  {
    deltaform::MpiSession session{boost::unit_test::framework::master_test_suite().argc,
                                  boost::unit_test::framework::master_test_suite().argv};
  };
} // namespace

BOOST_TEST_GLOBAL_FIXTURE(Mpi);
