// SPDX-License-Identifier: BSD-3-Clause
//
// Available memory, by the machine and the limits on the process.
#include "Core/Memory.h"
#include "Job/Job.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#if defined(__linux__)
#include <sys/resource.h>
#endif

namespace ahd
{
namespace test
{
namespace
{

TEST(AvailableMemory, IsSome)
{
  EXPECT_GT(availableMemory(), std::size_t(1) << 20);
}

/// Files in Linux's format, in a temporary folder.
class MemoryFiles
{
public:
  MemoryFiles()
    : folder_(std::filesystem::path(testing::TempDir()) /
        ("ahd_memory_files" + std::to_string(std::random_device{}()))) // tests run side by side
  {
    std::filesystem::create_directories(folder_ / "memory");
  }
  ~MemoryFiles() { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const
  {
    std::ofstream(folder_ / name) << text;
  }
  void remove(const std::string& name) const { std::filesystem::remove(folder_ / name); }

  std::size_t available() const
  {
    return availableMemoryBy((folder_ / "meminfo").string(), folder_.string());
  }

private:
  std::filesystem::path folder_;
};

constexpr std::size_t kGibibyte = std::size_t(1) << 30;

TEST(AvailableMemory, IsThatOfTheMachine)
{
  const MemoryFiles files;
  files.write(
    "meminfo", "MemTotal:  9 kB\nMemFree: 7 kB\nMemAvailable:    5000 kB\nBuffers: 3 kB\n");
  EXPECT_EQ(files.available(), 5000u * 1024);
  files.write("meminfo", "MemTotal:       9 kB\n");
  EXPECT_GE(files.available(), std::size_t(1) << 48) << "nobody tells";
}

#if defined(__linux__)
/// Of either version of control groups: what the limit leaves, less what this process has taken.
TEST(AvailableMemory, KeepsToTheLimitOfAContainer)
{
  const MemoryFiles files;
  files.write("meminfo", "MemAvailable: 99999999999 kB\n");
  const std::size_t unlimited = files.available();
  for (const char* name : { "memory.max", "memory/memory.limit_in_bytes" })
  {
    SCOPED_TRACE(name);
    files.write(name, std::to_string(64 * kGibibyte) + "\n");
    const std::size_t left = files.available();
    EXPECT_LT(left, 64 * kGibibyte) << "this process has taken some";
    EXPECT_GT(left, 60 * kGibibyte);
    files.write(name, "4096\n"); // less than is taken already
    EXPECT_EQ(files.available(), 0u);
    files.write("meminfo", "MemAvailable: 4 kB\n");
    files.write(name, std::to_string(64 * kGibibyte) + "\n");
    EXPECT_EQ(files.available(), 4096u) << "the machine has less";
    files.write("meminfo", "MemAvailable: 99999999999 kB\n");
    files.write(name, "max\n");
    EXPECT_EQ(files.available(), unlimited);
    files.write(name, "9223372036854771712\n"); // the first version's value for no limit
    EXPECT_EQ(files.available(), unlimited);
    files.remove(name);
    EXPECT_EQ(files.available(), unlimited);
  }
  files.write("memory.max", std::to_string(8 * kGibibyte));
  files.write("memory/memory.limit_in_bytes", std::to_string(64 * kGibibyte));
  EXPECT_LT(files.available(), 8 * kGibibyte) << "the second version's comes first";
}
#endif

#if defined(__linux__)
/// What a run of two segments that cross may take: more than they, as crossings do.
std::size_t allowedToSplit()
{
  static const double xy[] = { 0, 0, 1, 1, 0, 1, 1, 0 };
  static const std::int32_t ids[] = { 0, 1, 2, 3 };
  const GivenArray points = { xy, kFloat64, 2, 4, 16, 8 }, lines = { ids, kInt32, 2, 2, 8, 4 };
  Job job;
  job.settings.set(IntSetting::Threads, 1);
  job.setArray("points", &points);
  job.setArray("line_ids", &lines);
  job.run();
  return job.report().allowed;
}

TEST(AvailableMemory, KeepsToTheAddressSpace)
{
  constexpr std::size_t kRoom = std::size_t(200) << 20;
  rlimit before;
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  // The least limit that is above what is taken: no more is left under it than it was raised by.
  rlimit limit = before;
  limit.rlim_cur = kRoom;
  while (setrlimit(RLIMIT_AS, &limit) == 0 && availableMemory() == 0)
  {
    limit.rlim_cur += kRoom;
  }
  const std::size_t left = availableMemory();
  setrlimit(RLIMIT_AS, &before);
  EXPECT_GT(availableMemoryFor(kRoom), kRoom) << "a new reading that is kept";
  setrlimit(RLIMIT_AS, &limit);
  const std::size_t toSplit = allowedToSplit();
  const std::size_t forMany = availableMemoryFor(kRoom), forFew = availableMemoryFor(1);
  setrlimit(RLIMIT_AS, &before);
  EXPECT_GT(left, 0u);
  EXPECT_LE(left, kRoom);
  EXPECT_LE(toSplit, kRoom) << "read anew, however little is known to be needed";
  EXPECT_LE(forMany, kRoom) << "read anew, however old the one before is";
  EXPECT_LE(forFew, kRoom) << "that is kept, as it is little";
  EXPECT_GT(availableMemory(), kRoom) << "the limit is gone";
}
#endif

} // namespace
} // namespace test
} // namespace ahd
