#include <deltaform/process/processes.h>
#include <deltaform/process/ranks.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <iostream>
#include <numeric>
#include <set>
#include <thread>

namespace deltaform::ranks
{
  namespace
  {
    bool started()
    {
      int flag = 0;
      MPI_Initialized(&flag);
      return flag != 0;
    }

    MPI_Comm &present()
    {
      static MPI_Comm communicator = MPI_COMM_SELF;
      return communicator;
    }

    // Number of this process, asked for once: a thread that writes files must not call MPI.
    constexpr int unknown = -1;
    std::atomic<int> known_rank{unknown};

    double reduce(double value, MPI_Op operation)
    {
      if (count() > 1)
        MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, operation, communicator());
      return value;
    }
  } // namespace


  MPI_Comm communicator()
  {
    return present();
  }


  Processes::Processes(MPI_Comm communicator)
  {
    present() = communicator;
    known_rank = unknown;
  }


  Processes::~Processes()
  {
    present() = MPI_COMM_SELF;
    known_rank = unknown;
  }


  unsigned int count()
  {
    int size = 1;
    if (started())
      MPI_Comm_size(communicator(), &size);
    return static_cast<unsigned int>(size);
  }


  unsigned int mine()
  {
    int rank = known_rank;
    if (rank == unknown && started())
    {
      MPI_Comm_rank(communicator(), &rank);
      known_rank = rank;
    }
    return static_cast<unsigned int>(std::max(rank, 0));
  }


  bool first()
  {
    return mine() == 0;
  }


  double sum(const double value)
  {
    return reduce(value, MPI_SUM);
  }


  double max(const double value)
  {
    return reduce(value, MPI_MAX);
  }


  double min(const double value)
  {
    return reduce(value, MPI_MIN);
  }


  bool decided_by_first(const bool value)
  {
    int flag = value ? 1 : 0;
    if (count() > 1)
      MPI_Bcast(&flag, 1, MPI_INT, 0, communicator());
    return flag != 0;
  }


  void sum(double *const values, const std::size_t n)
  {
    // A reduction gives every process the same bits, so that they go on to decide alike.
    if (count() > 1)
      MPI_Allreduce(MPI_IN_PLACE, values, static_cast<int>(n), MPI_DOUBLE, MPI_SUM, communicator());
  }


  std::vector<std::string> gather(std::string own)
  {
    if (count() == 1)
    {
      std::vector<std::string> result(1);
      result.front() = std::move(own);
      return result;
    }
    const int n = static_cast<int>(own.size());
    std::vector<int> sizes(count()), starts(count(), 0);
    MPI_Allgather(&n, 1, MPI_INT, sizes.data(), 1, MPI_INT, communicator());
    std::partial_sum(sizes.begin(), sizes.end() - 1, starts.begin() + 1);
    std::string all(static_cast<std::size_t>(starts.back() + sizes.back()), '\0');
    MPI_Allgatherv(own.data(), n, MPI_CHAR, &all[0], sizes.data(), starts.data(), MPI_CHAR, communicator());
    std::vector<std::string> result;
    for (unsigned int r = 0; r < count(); ++r)
      result.push_back(all.substr(static_cast<std::size_t>(starts[r]), static_cast<std::size_t>(sizes[r])));
    return result;
  }


  Status worst(const Status &own)
  {
    if (count() == 1)
      return own;
    const auto worst_outcome = static_cast<int>(max(static_cast<double>(static_cast<int>(own.outcome))));
    if (worst_outcome == static_cast<int>(Status().outcome))
      return {};
    // Causes are literals; one that arrives from elsewhere is kept for the rest of the run.
    static std::set<std::string> causes;
    const bool mine_is_worst = static_cast<int>(own.outcome) == worst_outcome;
    const auto texts = gather(mine_is_worst ? std::string(own.cause) : std::string());
    const auto places = gather(std::vector<unsigned int>{own.place});
    const auto outcomes = gather(std::vector<int>{static_cast<int>(own.outcome)});
    const auto who =
      static_cast<std::size_t>(std::find(outcomes.begin(), outcomes.end(), worst_outcome) - outcomes.begin());
    Status result;
    result.outcome = static_cast<decltype(result.outcome)>(worst_outcome);
    result.cause = causes.insert(texts[who]).first->c_str();
    result.place = places[who];
    return result;
  }


  bool end_together(const int exit_status, const bool failed, const std::string &message)
  {
    if (count() == 1)
      return true;
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibarrier(communicator(), &request);
    if (!failed)
    {
      MPI_Wait(&request, MPI_STATUS_IGNORE); // NOLINT(clang-analyzer-optin.mpi.MPI-Checker): a barrier is no call to it
      return first();
    }
    const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(2);
    int done = 0;
    for (; done == 0 && std::chrono::steady_clock::now() < patience;
         std::this_thread::sleep_for(std::chrono::milliseconds(5)))
      MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done == 0)
    {
      std::cerr << "process " << mine() << ": " << message << std::endl;
      MPI_Abort(communicator(), exit_status);
    }
    return first();
  }
} // namespace deltaform::ranks
