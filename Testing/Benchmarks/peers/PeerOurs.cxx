// SPDX-License-Identifier: BSD-3-Clause
//
// PeerOurs POINTS TRIANGLES [THREADS]: the engine with its default settings, in a process of its
// own, on the calling thread or on this many. Timed: coordinates in, triangles in the caller's ids
// out, the memory for both the work and the triangles.
#include "Executors.h"
#include "PeerFiles.h"
#include "Triangulate.h"

#include <cstdio>
#include <cstdlib>
#include <memory>

namespace
{
using namespace ahd;
using namespace ahd::test;

std::vector<std::int32_t> triangulate(const std::vector<Point>& points, Executor* executor)
{
  Workspace workspace;
  Triangulation made;
  const PointView view(points.empty() ? nullptr : &points[0].x, points.size(), 2);
  std::vector<std::int32_t> triples;
  Status status = triangulate(view, Options(), workspace, { nullptr, executor }, made);
  if (status == Status::Ok)
  {
    triples.resize(3 * made.report().triangles);
    status = made.writeTriangles(triples.data(), { nullptr, executor });
  }
  if (status != Status::Ok)
  {
    std::fprintf(stderr, "the engine's status is %d\n", int(status));
    std::exit(3);
  }
  return triples;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 3 && argc != 4)
  {
    std::fprintf(stderr, "PeerOurs POINTS TRIANGLES [THREADS]\n");
    return 1;
  }
  const unsigned threads = argc == 4 ? unsigned(std::atoi(argv[3])) : 1;
  const std::unique_ptr<Executor> executor(threads > 1 ? new ThreadExecutor(threads) : nullptr);
  const std::vector<Point> points = readPoints(argv[1]);
  std::vector<std::int32_t> triples;
  return timeCall([&] { triples = triangulate(points, executor.get()); },
    [&] { writeTriples(argv[2], triples); });
}
