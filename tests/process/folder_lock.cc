#include <deltaform/parameters/scene_error.h>
#include <deltaform/process/child_process.h>
#include <deltaform/process/folder_lock.h>

#include "../messages.h"

#include <csignal>
#include <limits>

using namespace deltaform;

namespace
{
  std::string refusal(const std::string &folder)
  {
    return message_of<SceneError>([&]() { const FolderLock lock(folder, false); });
  }
} // namespace

BOOST_AUTO_TEST_SUITE(folder_lock)

BOOST_AUTO_TEST_CASE(one_owner_at_a_time)
{
  const TemporaryFolder folder;
  const std::string name = folder.path.string();
  {
    const FolderLock lock(name, false);
    const std::string owner = "process " + std::to_string(getpid()) + " on ";
    check_contains(content_of(FolderLock::path(name)), {owner.c_str()});
    check_contains(refusal(name), {"in use by", owner.c_str(), "--force"});
    // The one that was refused has not taken the owner's file away.
    BOOST_TEST(std::filesystem::exists(FolderLock::path(name)));
    BOOST_CHECK_NO_THROW(FolderLock(name, true));
  }
  BOOST_TEST(!std::filesystem::exists(FolderLock::path(name)));
  BOOST_CHECK_NO_THROW(FolderLock(name, false));
}

BOOST_AUTO_TEST_CASE(what_a_killed_process_leaves_is_recognized)
{
  const TemporaryFolder folder;
  const std::string name = folder.path.string();
  const int process = start_process(
    [&]() {
      const FolderLock lock(name, false);
      return std::raise(SIGKILL);
    },
    "/dev/null");
  BOOST_TEST(wait_for_process(std::numeric_limits<double>::infinity())->exit_status == 128 + 9);
  check_contains(content_of(FolderLock::path(name)), {("process " + std::to_string(process)).c_str()});
  BOOST_CHECK_NO_THROW(FolderLock(name, false));
}

BOOST_AUTO_TEST_CASE(of_another_machine_nothing_is_known)
{
  const TemporaryFolder folder;
  const std::string name = folder.path.string();
  folder.file("deltaform.lock", "process 4711 on another.machine\n");
  check_contains(refusal(name), {"belongs to process 4711 on another.machine", "--force"});
  BOOST_TEST(content_of(FolderLock::path(name)) == "process 4711 on another.machine\n");
  BOOST_CHECK_NO_THROW(FolderLock(name, true));
  BOOST_TEST(!std::filesystem::exists(FolderLock::path(name)));
}

BOOST_AUTO_TEST_CASE(a_folder_that_cannot_be_written)
{
  check_contains(refusal("/proc"), {"The folder '/proc'", "deltaform.lock"});
}

BOOST_AUTO_TEST_SUITE_END()
