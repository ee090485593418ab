#include <deltaform/app/mpi_session.h>

#include <deal.II/base/mpi.h>

#include <cstdlib>

namespace deltaform
{
  namespace
  {
    /// Opening a transport to processes that do not exist takes longer than a small run. Settings of the user prevail.
    void start_alone_unless_launched()
    {
      if (MpiSession::launched())
        return;
      setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
      setenv("OMPI_MCA_btl", "self", 0);
      setenv("OMPI_MCA_pml", "ob1", 0);
      // Its folder in /tmp is shared by all runs of a user: one that ends may remove it while another starts.
      setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
    }
  } // namespace


  struct MpiSession::Running
  {
    Running(int argc, char **argv)
      : mpi(argc, argv, 1)
    {
    }

    const dealii::Utilities::MPI::MPI_InitFinalize mpi;
  };


  bool MpiSession::launched()
  {
    return std::getenv("OMPI_COMM_WORLD_SIZE") || std::getenv("PMI_SIZE") || std::getenv("PMIX_RANK");
  }


  MpiSession::MpiSession(const int argc, char **argv)
  {
    start_alone_unless_launched();
    running_ = std::make_unique<Running>(argc, argv);
  }


  MpiSession::~MpiSession() = default;
} // namespace deltaform
