// Signals: no partial file, no damaged earlier file, death by the signal.

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "cli/process.hpp"

namespace delone::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// Bytes of what the run is writing beside the earlier files.
std::uintmax_t bytes_under_way(const Folder& folder) {
  std::uintmax_t bytes = 0;
  for (const std::string& name : folder.names()) {
    std::error_code gone;
    if (name.ends_with(".tmp"))
      bytes = std::max(bytes, fs::file_size(folder / name, gone));
    if (gone) return 0;
  }
  return bytes;
}

class Interrupt : public testing::TestWithParam<int> {};

// The grid is large enough that writing it takes a good while; the signal comes in the
// middle.
TEST_P(Interrupt, WhileWritingLeavesNoPartialFileAndTheEarlierOne) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y,z\n0,0,1\n1,0,2\n1,1,3\n0,1,4\n");
  folder.write("g.csv", "earlier");
  Process process({"grid", points, "-o", folder / "g.csv", "--size", "2000/2000"});
  while (process.is_running() && bytes_under_way(folder) < 1'000'000)
    std::this_thread::sleep_for(1ms);
  ASSERT_TRUE(process.is_running()) << "the run was over before it could be interrupted";
  process.send(GetParam());
  const Outcome outcome = process.wait();
  ASSERT_EQ(outcome.signal, GetParam());
  EXPECT_EQ(folder.read("g.csv"), "earlier");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"g.csv", "p.csv"}));
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, testing::Values(SIGINT, SIGTERM, SIGHUP));

}  // namespace
}  // namespace delone::test
