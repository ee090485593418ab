// What deltaform cannot be faster than: a program that is linked to the same libraries, starts MPI with the same
// settings as a single deltaform process, and ends it. scripts/studies/benchmark.py compares the two.
#include <deal.II/base/mpi.h>

#include <cstdlib>

int
main(int argc, char *argv[])
{
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  setenv("OMPI_MCA_btl", "self", 0);
  setenv("OMPI_MCA_pml", "ob1", 0);
  // Its folder in /tmp is shared by all runs of a user: one that ends may remove it while another starts.
  setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  return 0;
}
