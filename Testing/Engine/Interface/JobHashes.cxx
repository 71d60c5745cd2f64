// SPDX-License-Identifier: BSD-3-Clause
//
// Results of the C interface, byte for byte the engine's: the hashes of
// Data/Hashes/Engine.txt, made from the job's arrays.
#include "Hash.h"
#include "HashedResults.h"
#include "JobRun.h"

#include <gtest/gtest.h>

#include <map>

namespace ahd
{
namespace test
{
namespace
{

/// The hashes of the file, by name.
const std::map<std::string, std::string>& expected()
{
  static const std::map<std::string, std::string> kHashes = []
  {
    std::map<std::string, std::string> hashes;
    for (const NamedHash& hash : readHashes(AHD_HASHES_DIRECTORY "/Engine.txt"))
    {
      hashes[hash.name] = hash.hash;
    }
    return hashes;
  }();
  return kHashes;
}

void expectHash(const std::string& name, const JobRun& run, const Hash& hash)
{
  ASSERT_EQ(run.status(), AHD_OK) << name << ": " << run.message();
  const auto found = expected().find(name);
  ASSERT_NE(found, expected().end()) << name;
  EXPECT_EQ(hash.text(), found->second) << name;
}

PointView viewOf(const std::vector<Point>& points)
{
  return PointView(points.empty() ? nullptr : &points[0].x, points.size(), 2);
}

void addStatuses(Hash& hash, int count)
{
  for (int k = 0; k < count; ++k)
  {
    hash.add(Status::Ok);
  }
}

/// Report, triangles, status of the points, neighbours.
void addWritten(Hash& hash, JobRun& run)
{
  addStatuses(hash, 3);
  for (const char* name : { "inserted", "beyond_limit", "duplicates", "not_finite", "skipped" })
  {
    hash.add(run.count(name));
  }
  hash.add(run.count("kept_triangles"));
  hash.add(run.shortIds("triangles"));
  hash.add(run.ids("point_status"));
  hash.add(run.ids("neighbors"));
}

Hash hashOfTriangles(JobRun& run)
{
  Hash hash;
  addStatuses(hash, 1);
  run.run();
  addWritten(hash, run);
  return hash;
}

void expectTriangles(const std::string& family, const std::vector<NamedPoints>& all, int threads)
{
  for (const NamedPoints& given : all)
  {
    JobRun run;
    run.set("threads", std::int64_t(threads));
    run.setPoints(viewOf(given.points));
    const Hash hash = hashOfTriangles(run);
    expectHash(family + "/" + given.name, run, hash);
  }
}

TEST(JobHashes, OfTrianglesAreTheEngines)
{
  expectTriangles("corpus", pointsOfCorpus(AHD_CORPUS_DIRECTORY), 1);
  expectTriangles("points", pointsOfDistributions(10000), 1);
}

TEST(JobHashes, OfManyPointsInThreadsAreTheEngines)
{
  expectTriangles("many", manyPoints(), 3);
}

TEST(JobHashes, OfConstraintsAreTheEngines)
{
  for (const std::int64_t rule : { AHD_FILL_ORIENTATION, AHD_FILL_EVEN_ODD })
  {
    const std::string family = rule == AHD_FILL_EVEN_ODD ? "constrained/EvenOdd/"
                                                         : "constrained/Orientation/";
    for (const NamedCase& made : constraintCases())
    {
      JobRun run;
      run.set("fill_rule", rule);
      run.setPoints(made.given.view());
      run.setConstraints(made.given.constraints.view());
      run.run();
      Hash hash;
      addStatuses(hash, 2);
      for (const char* name : { "segments", "segments_of_no_length", "segments_without_vertex",
             "segments_crossing", "unfilled_loops", "constraint_edges" })
      {
        hash.add(run.count(name));
      }
      for (const std::int64_t number : run.ids("left_out"))
      {
        hash.add(number);
      }
      addWritten(hash, run);
      addStatuses(hash, 2);
      hash.add(run.bytes("constraint_edges"));
      hash.add(run.ids("regions"));
      expectHash(family + made.name, run, hash);
    }
  }
}

TEST(JobHashes, OfOrdersAreTheEngines)
{
  for (const NamedPoints& given : pointsOfDistributions(2000))
  {
    JobRun run;
    run.setPoints(viewOf(given.points));
    run.set("want_boxes", std::int64_t(1));
    run.set("want_order", std::int64_t(1));
    run.run();
    Hash hash;
    addStatuses(hash, 3);
    hash.add(run.ids("order"));
    hash.add(run.ids("insertion_ranks"));
    const std::vector<double> bounds = run.doubles("box_bounds");
    const std::vector<std::int32_t> levels = run.shortIds("box_levels");
    const std::vector<std::int64_t> counts = run.ids("box_counts");
    for (std::size_t i = 0; i < counts.size(); ++i)
    {
      hash.add(Point{ bounds[4 * i], bounds[4 * i + 2] });
      hash.add(Point{ bounds[4 * i + 1], bounds[4 * i + 3] });
      hash.add(levels[i]);
      hash.add(counts[i]);
    }
    run.set("insertion_limit", static_cast<std::int64_t>(given.points.size() / 2 + 1));
    addStatuses(hash, 1);
    run.run();
    addWritten(hash, run);
    expectHash("order/default/" + given.name, run, hash);
  }
}

TEST(JobHashes, OfVoronoiCellsAreTheEngines)
{
  for (const NamedPoints& given : pointsOfDistributions(2000))
  {
    JobRun run;
    run.setPoints(viewOf(given.points));
    Hash hash;
    addStatuses(hash, 4);
    for (const std::int64_t clip : { AHD_CLIP_HULL, AHD_CLIP_BOUNDS })
    {
      run.set("want_voronoi", std::int64_t(1));
      run.set("voronoi_clip", clip);
      run.run();
      addStatuses(hash, 1);
      const std::vector<double> corners = run.doubles("voronoi_points");
      hash.add(corners.size() / 2);
      for (const double number : corners)
      {
        hash.add(number);
      }
      hash.add(run.ids("voronoi_offsets"));
      hash.add(run.ids("voronoi_corners"));
      hash.add(run.ids("voronoi_sites"));
    }
    expectHash("voronoi/" + given.name, run, hash);
  }
}

} // namespace
} // namespace test
} // namespace ahd
