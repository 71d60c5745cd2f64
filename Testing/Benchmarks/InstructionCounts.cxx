// SPDX-License-Identifier: BSD-3-Clause
//
// To be run under valgrind --tool=callgrind: one run of the engine, whose cost is dumped at the end
// of each phase under the phase's name.
//   InstructionCounts <distribution> <points>
#include "Distributions.h"
#include "Triangulate.h"

#include <valgrind/callgrind.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>

namespace
{

using namespace ahd;
using namespace ahd::test;

class Phases : public Progress
{
public:
  void beginPhase(Phase phase) override
  {
    dump();
    phase_ = int(phase);
  }
  bool advance(Phase, double) override { return true; }

  /// The instructions since the phase began.
  void dump()
  {
    static const char* const kNames[] = { "merge", "split", "read", "sort", "insert", "constrain",
      "extract", "outputs" };
    static_assert(std::size(kNames) == kPhases, "a name for each phase");
    if (phase_ >= 0)
    {
      CALLGRIND_DUMP_STATS_AT(kNames[phase_]);
    }
    CALLGRIND_ZERO_STATS;
  }

private:
  int phase_ = -1;
};

} // namespace

int main(int argc, char** argv)
{
  std::vector<Point> points;
  for (const Distribution distribution : allDistributions())
  {
    if (argc == 3 && std::strcmp(argv[1], nameOf(distribution)) == 0)
    {
      points = makePoints(distribution, std::size_t(std::atof(argv[2])), 1);
    }
  }
  if (points.empty())
  {
    std::fprintf(stderr, "InstructionCounts <distribution> <points>\n");
    return 1;
  }
  std::vector<std::int32_t> triples(6 * points.size());
  Workspace workspace;
  Triangulation made;
  Phases phases;
  const PointView view(&points[0].x, points.size(), 2);
  const Status status = triangulate(view, Options(), workspace, { &phases, nullptr }, made);
  const bool ok = status == Status::Ok &&
    made.writeTriangles(triples.data(), { &phases, nullptr }) == Status::Ok;
  phases.dump();
  return ok ? 0 : 1;
}
