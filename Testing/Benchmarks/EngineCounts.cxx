// SPDX-License-Identifier: BSD-3-Clause
//
// Counts of the engine's work: nothing here depends on the machine or its load.
// Prints one JSON object a line:
//   EngineCounts [--sizes=1e6] [--distributions=paper] [--threads=1,2,64]
// Numbers of threads beyond those of the machine are reported, not started: the counts are the
// same.
#include "BenchmarkFlags.h"
#include "Executors.h"
#include "OwnMemory.h"
#include "Triangulate.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <thread>

namespace
{

using namespace ahd;
using namespace ahd::test;

/// Runs and prints the counts; false if the engine failed.
bool count(Distribution distribution, const std::vector<Point>& points, unsigned threads)
{
  const unsigned there = std::max(1u, std::thread::hardware_concurrency());
  ThreadExecutor executor(std::min(there, threads), threads);
  std::vector<std::int32_t> triples(6 * points.size() + 6);
  const PointView view(&points[0].x, points.size(), 2);
  const std::size_t before = account.held;
  account.peak = before;
  Workspace workspace;
  Triangulation made;
  const Context context{ nullptr, threads == 1 ? nullptr : &executor };
  Options options;
  Status status = triangulate(view, options, workspace, context, made);
  const Report shared = made.report();
  if (status == Status::Ok)
  {
    status = made.writeTriangles(triples.data(), context);
  }
  const std::size_t most = account.peak - before;
  Report work;
  if (threads == 1 && status == Status::Ok)
  {
    options.countWork = true; // which does without threads
    status = triangulate(view, options, workspace, {}, made);
    work = made.report();
  }
  std::printf("{\"distribution\": \"%s\", \"points\": %zu, \"threads\": %u, \"ok\": %s, "
              "\"inserted\": %zu, \"attempts\": %llu, \"deferred\": %llu, \"criticalPath\": %llu, "
              "\"peakBytes\": %zu, \"np\": %.4f, \"nr\": %.4f, "
              "\"exactInCircle\": %.4f, \"exactOrient\": %.4f}\n",
    nameOf(distribution), points.size(), threads, status == Status::Ok ? "true" : "false",
    shared.inserted, static_cast<unsigned long long>(shared.insertionAttempts),
    static_cast<unsigned long long>(shared.deferredPoints),
    static_cast<unsigned long long>(shared.criticalPath), most, work.np(), work.nr(),
    double(work.exactInCircle) / double(points.size()),
    double(work.exactOrient) / double(points.size()));
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
