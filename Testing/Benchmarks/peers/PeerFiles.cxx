// SPDX-License-Identifier: BSD-3-Clause
#include "PeerFiles.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>

namespace ahd
{
namespace test
{
namespace
{

struct Closer
{
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closer>;

[[noreturn]] void giveUp(const char* what, const std::string& file)
{
  std::fprintf(stderr, "cannot %s %s\n", what, file.c_str());
  std::exit(2);
}

File open(const std::string& name, const char* mode)
{
  File file(std::fopen(name.c_str(), mode));
  if (!file)
  {
    giveUp("open", name);
  }
  return file;
}

template <typename Number>
std::vector<Number> readAll(const std::string& name)
{
  const File file = open(name, "rb");
  std::fseek(file.get(), 0, SEEK_END);
  std::vector<Number> numbers(std::size_t(std::ftell(file.get())) / sizeof(Number));
  std::rewind(file.get());
  if (std::fread(numbers.data(), sizeof(Number), numbers.size(), file.get()) != numbers.size())
  {
    giveUp("read", name);
  }
  return numbers;
}

template <typename Number>
void writeAll(const std::string& name, const std::vector<Number>& numbers)
{
  File file = open(name, "wb");
  const bool written = std::fwrite(numbers.data(), sizeof(Number), numbers.size(), file.get()) ==
    numbers.size();
  if (std::fclose(file.release()) != 0 || !written)
  {
    giveUp("write", name);
  }
}

double secondsOf(clockid_t clock)
{
  timespec t;
  clock_gettime(clock, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

/// A line of /proc/self/status, in bytes.
double memory(const char* name)
{
  const File status = open("/proc/self/status", "r");
  char line[256];
  while (std::fgets(line, sizeof line, status.get()))
  {
    if (std::strncmp(line, name, std::strlen(name)) == 0)
    {
      return 1024.0 * std::strtod(line + std::strlen(name) + 1, nullptr);
    }
  }
  return 0.0;
}

/// Resets VmHWM, the peak.
void forgetPeak()
{
  if (const File file{ std::fopen("/proc/self/clear_refs", "w") })
  {
    std::fputs("5", file.get());
  }
}

} // namespace

std::vector<Point> readPoints(const std::string& file)
{
  static_assert(sizeof(Point) == 2 * sizeof(double), "points are read as pairs of doubles");
  return readAll<Point>(file);
}

void writePoints(const std::string& file, const std::vector<Point>& points)
{
  writeAll(file, points);
}

std::vector<std::int32_t> readTriples(const std::string& file)
{
  return readAll<std::int32_t>(file);
}

void writeTriples(const std::string& file, const std::vector<std::int32_t>& triples)
{
  writeAll(file, triples);
}

int timeCall(const std::function<void()>& call, const std::function<void()>& write)
{
  const double peakBefore = memory("VmHWM:");
  forgetPeak();
  const double held = memory("VmRSS:");
  std::puts("call");
  std::fflush(stdout);
  const double wall = secondsOf(CLOCK_MONOTONIC);
  const double cpu = secondsOf(CLOCK_PROCESS_CPUTIME_ID);
  call();
  const double cpuTaken = secondsOf(CLOCK_PROCESS_CPUTIME_ID) - cpu;
  const double wallTaken = secondsOf(CLOCK_MONOTONIC) - wall;
  const double peak = memory("VmHWM:");
  std::puts("called");
  std::fflush(stdout);
  write();
  std::printf("done {\"cpu\": %.9f, \"wall\": %.9f, \"held\": %.0f, \"peak\": %.0f, "
              "\"peakBefore\": %.0f}\n",
    cpuTaken, wallTaken, held, peak, peakBefore);
  return 0;
}

} // namespace test
} // namespace ahd
