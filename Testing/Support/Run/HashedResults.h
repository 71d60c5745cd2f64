// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_HashedResults_h
#define ahd_HashedResults_h

#include "ConstraintMakers.h"
#include "Engine.h"
#include "Executors.h"
#include "HashFile.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace ahd
{
namespace test
{

/// Ways to make results, none of which may change a hash.
struct Way
{
  Options options;
  Executor* executor = nullptr; ///< threads; null: none
  Progress* progress = nullptr;
  Engine* engine = nullptr; ///< one for all runs; null: a new one for each
  std::function<Status(const std::function<Status()>&)> call = nullptr; ///< calls its argument
};

/// Points with a name.
struct NamedPoints
{
  std::string name;
  std::vector<Point> points;
};
/// Every distribution, with so many points at most: 200 where predicates need wide numbers.
std::vector<NamedPoints> pointsOfDistributions(std::size_t most);
/// Enough points for threads to share all phases.
std::vector<NamedPoints> manyPoints();
/// The files of a folder (Corpus.h).
std::vector<NamedPoints> pointsOfCorpus(const std::string& folder);

/// Points and constraints with a name: the large shapes of ConstraintMakers.h, and chains through
/// every distribution.
struct NamedCase
{
  std::string name;
  ConstraintCase given;
};
std::vector<NamedCase> constraintCases();

/// All outputs of the triangulation: report, triangles, pointStatus, neighbours.
std::string hashOfTriangles(const PointView& points, const Way& way);

/// The same of the triangulation in the plane, without ids: its corners' coordinates (-0 as 0) and
/// neighbours. Shuffled points have the same hash.
std::string hashOfPlaces(const PointView& points, const Way& way);

/// The same as the first with constraints, and their report, edges, regions.
std::string hashOfConstrained(const ConstraintCase& given, FillRule rule, const Way& way);

/// The insertion order, the ranks, the boxes, and the triangles after half of the points.
std::string hashOfOrder(const PointView& points, const Options& order, const Way& way);

/// All results of merging within 1/100 of the width of all points.
std::string hashOfMerged(const PointView& points, const Way& way);

/// The cells, corners with all bits, cut off at the hull and at the box.
std::string hashOfVoronoi(const PointView& points, const Way& way);

/// The constraints split where they cross, added points with all bits.
std::string hashOfSplit(const ConstraintCase& given, const Way& way);

/// Values, slopes, masks, weights and counts by every method, on a raster and at places on points,
/// on edges and anywhere; places outside filled by the nearest; of all points, and of the parts
/// that loops keep.
std::string hashOfSamples(const PointView& points, const Way& way);
std::string hashOfSamples(const ConstraintCase& given, const Way& way);

/// All of them, in the order in which they stand in Data/Hashes/Engine.txt: triangles of corpus
/// and distributions, ...
Hashes hashesOfTriangles(const std::string& corpus, const Way& way);
/// ... constrained results of each case by each rule, and of many small cases together, ...
Hashes hashesOfConstrained(const Way& way);
/// ... the rest, which Way::options does not affect; few points ...
Hashes hashesOfTheRest(const Way& way);
/// ... all that threads can share ...
Hashes hashesOfMany(const Way& way);
/// ... values between the points, and so many that threads share the work.
Hashes hashesOfSamples(const Way& way);
Hashes hashesOfManySamples(const Way& way);

} // namespace test
} // namespace ahd

#endif
