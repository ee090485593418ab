#define BOOST_TEST_MODULE deltaform
#include <boost/test/unit_test.hpp>

#include <deal.II/base/multithread_info.h>

namespace
{
  struct SingleThreaded
  {
    SingleThreaded()
    {
      dealii::MultithreadInfo::set_thread_limit(1);
    }
  };
} // namespace

BOOST_TEST_GLOBAL_FIXTURE(SingleThreaded);
