// SPDX-License-Identifier: BSD-3-Clause
//
// What the engine does, counted: nothing here depends on the machine or on what else it does.
// Prints one JSON object a line:
//   EngineCounts [--sizes=1e6] [--distributions=paper] [--threads=1,2,64]
// Numbers of threads beyond those of the machine are said, not had: what is counted is the same.
#include "BenchmarkFlags.h"
#include "Executors.h"
#include "OwnNew.h"
#include "Triangulate.h"

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <thread>

namespace
{

std::atomic<std::size_t> held{ 0 };
std::atomic<std::size_t> peak{ 0 };

} // namespace

void* ahd::test::ownAllocate(std::size_t size, std::size_t alignment)
{
  void* const block = alignment == alignof(std::max_align_t)
    ? std::malloc(size)
    : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (!block)
  {
    throw std::bad_alloc();
  }
  const std::size_t now = held += malloc_usable_size(block);
  if (now > peak)
  {
    peak = now;
  }
  return block;
}

void ahd::test::ownRelease(void* block)
{
  held -= block ? malloc_usable_size(block) : 0;
  std::free(block);
}

namespace
{

using namespace ahd;
using namespace ahd::test;

/// Runs and prints what was counted; false if the engine did not get through.
bool count(Distribution distribution, const std::vector<Point>& points, unsigned threads)
{
  const unsigned there = std::max(1u, std::thread::hardware_concurrency());
  ThreadExecutor executor(std::min(there, threads), threads);
  std::vector<std::int32_t> triples(6 * points.size() + 6);
  const PointView view(&points[0].x, points.size(), 2);
  const std::size_t before = held;
  peak = before;
  Triangulator triangulator;
  Options options;
  Status status = triangulator.run(view, options, nullptr, threads == 1 ? nullptr : &executor);
  const Report shared = triangulator.report();
  if (status == Status::Ok)
  {
    status = triangulator.writeTriangles(
      triples.data(), nullptr, threads == 1 ? nullptr : &executor);
  }
  const std::size_t most = peak - before;
  Report work;
  if (threads == 1 && status == Status::Ok)
  {
    options.countWork = true; // which does without threads
    status = triangulator.run(view, options, nullptr);
    work = triangulator.report();
  }
  std::printf("{\"distribution\": \"%s\", \"points\": %zu, \"threads\": %u, \"ok\": %s, "
              "\"inserted\": %zu, \"attempts\": %llu, \"deferred\": %llu, \"criticalPath\": %llu, "
              "\"peakBytes\": %zu, \"np\": %.4f, \"nr\": %.4f}\n",
    nameOf(distribution), points.size(), threads, status == Status::Ok ? "true" : "false",
    shared.inserted, static_cast<unsigned long long>(shared.insertionAttempts),
    static_cast<unsigned long long>(shared.deferredPoints),
    static_cast<unsigned long long>(shared.criticalPath), most, work.np(), work.nr());
  std::fflush(stdout);
  return status == Status::Ok;
}

/// Takes --threads=1,2,64 out of the command line.
std::vector<unsigned> takeThreads(int& argc, char** argv)
{
  const std::string prefix = "--threads=";
  std::vector<unsigned> threads;
  int kept = 1;
  for (int i = 1; i < argc; ++i)
  {
    if (std::string(argv[i]).rfind(prefix, 0) != 0)
    {
      argv[kept++] = argv[i];
      continue;
    }
    std::stringstream list(argv[i] + prefix.size());
    for (std::string word; std::getline(list, word, ',');)
    {
      threads.push_back(unsigned(std::max(1, std::atoi(word.c_str()))));
    }
  }
  argc = kept;
  return threads.empty() ? std::vector<unsigned>{ 1 } : threads;
}

} // namespace

int main(int argc, char** argv)
{
  std::string error;
  const std::vector<unsigned> threads = takeThreads(argc, argv);
  const BenchmarkFlags flags = takeFlags(argc, argv, error);
  if (!error.empty() || argc > 1)
  {
    std::fprintf(stderr, "%s", error.empty() ? "unknown argument\n" : error.c_str());
    return 1;
  }
  bool ok = true;
  for (const std::size_t n : flags.sizes)
  {
    for (const Distribution distribution : flags.distributions)
    {
      const std::vector<Point> points = makePoints(distribution, n, 1);
      for (const unsigned t : threads)
      {
        ok = count(distribution, points, t) && ok;
      }
    }
  }
  return ok ? 0 : 1;
}
