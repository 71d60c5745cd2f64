// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_FaultsSession_h
#define ahd_FaultsSession_h

// Everything the engine can do, in one run, for tests that end it in the middle.
#include "Crossings/Crossings.h"
#include "Merge/Merge.h"
#include "Sample/Sample.h"
#include "Voronoi/Voronoi.h"

#include "ConstrainedRun.h"
#include "ConstraintMakers.h"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace ahd
{
namespace test
{

/// One input, through every entry point: merged, split, triangulated, constrained, all written, and
/// the Voronoi diagram made. The outputs are allocated between the calls, in `prepare`.
class Session
{
public:
  Session(const ConstraintCase& given, const Options& options)
    : given_(given)
    , options_(options)
  {
    options_.keepOrder = options_.keepBoxes = true;
  }

  /// Calls an entry point; wrapped by tests that make it fail.
  using Call = std::function<Status()>;
  using Caller = std::function<Status(const Call&)>;

  /// @pre `t` has no result of a run before. Runs until a call does not return Ok, and returns its
  /// status.
  Status run(Engine& t, const Caller& caller, const Helpers& helpers)
  {
    Progress* const p = helpers.progress;
    Executor* const e = helpers.executor;
    const Call calls[] = {
      [&] { return mergeWithin(given_.view(), 1e-4, p, merged_); },
      [&] { return splitAtCrossings(points(), given_.constraints.view(), p, split_); },
      [&] { return t.run(points(), options_, p, e); },
      [&] { return t.writeTriangles(corners_.data(), p, e); },
      [&] { return t.writeNeighbors(neighbors_.data(), p, e); },
      [&] { return t.writePointStatus(pointStatus_.data(), p, e); },
      [&] {
        return voronoiCells(t.made, VoronoiClip::Bounds, cells_, { p, e });
      },
      [&] { return t.constrain(split_.view(), FillRule::EvenOdd, p); },
      [&] { return t.writeTriangles(triples_.data(), p, e); },
      [&] { return t.writeOrder(order_.data(), p, e); },
      [&] { return t.writeInsertionRanks(ranks_.data(), p, e); },
      [&] { return t.writeNeighbors(neighbors_.data(), p, e); },
      [&] { return t.writeConstraintEdges(edges_.data(), p, e); },
      [&] { return t.writeRegions(regions_.data(), p, e); },
      [&] {
        return sampler_.prepare(t.made, nullptr, SampleMethod::NaturalNeighbor, { p, e });
      },
      [&] {
        return sample(SamplePlaces(raster()), { p, e });
      },
      [&] {
        return sample(SamplePlaces(given_.view()), { p, e });
      },
    };
    gatherPoints();
    for (const Call& call : calls)
    {
      const Status status = caller(call);
      if (status != Status::Ok)
      {
        return status;
      }
      if (t.report().inserted == 0)
      {
        gatherPoints(); // not triangulated yet
      }
      prepare(t);
    }
    return Status::Ok;
  }

  /// All results as a string.
  std::string bytes() const
  {
    std::string all;
    const auto add = [&all](const auto& numbers)
    {
      all += std::to_string(numbers.size()) + ":";
      all.append(
        reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(*numbers.data()));
    };
    add(merged_.skip);
    add(split_.ids);
    add(split_.offsets);
    add(triples_);
    add(corners_);
    add(pointStatus_);
    add(order_);
    add(ranks_);
    add(neighbors_);
    add(edges_);
    add(regions_);
    add(cells_.points);
    add(cells_.offsets);
    add(cells_.corners);
    add(cells_.sites);
    add(sampled_);
    return all;
  }

private:
  static SampleRaster raster() { return { { 0.0, 0.0 }, { 0.05, 0.05 }, 21, 22 }; }

  Status sample(const SamplePlaces& places, const Context& context)
  {
    SampleReport report;
    const SampleArray array{ heights_.data(), 1, sampled_.data(), nullptr };
    return sampler_.values(places, &array, 1, nullptr, report, context);
  }

  /// Without those that were merged, with the crossings that were found.
  void gatherPoints()
  {
    all_ = given_.points;
    for (const CrossingPoint& crossing : split_.points)
    {
      all_.push_back(crossing.at);
    }
    skip_ = merged_.skip;
    skip_.resize(all_.size());
  }

  PointView points() const
  {
    PointView view(&all_[0].x, all_.size(), 2);
    view.skip = skip_.data();
    return view;
  }

  void prepare(const Engine& t)
  {
    const std::size_t triangles = t.report().triangles;
    corners_.resize(corners_.empty() ? 3 * triangles : corners_.size());
    triples_.resize(3 * triangles);
    neighbors_.resize(3 * triangles);
    edges_.resize(triangles);
    regions_.resize(triangles);
    pointStatus_.resize(all_.size());
    ranks_.resize(all_.size());
    order_.resize(t.report().inserted);
    heights_.resize(all_.size());
    for (std::size_t k = 0; k < all_.size(); ++k)
    {
      heights_[k] = double(k);
    }
    sampled_.resize(std::max(given_.points.size(), raster().columns * raster().rows));
  }

  const ConstraintCase& given_;
  Options options_;
  MergedPoints merged_;
  SplitConstraints split_;
  std::vector<Point> all_;
  std::vector<unsigned char> skip_;
  std::vector<std::int32_t> corners_; ///< before the constraints
  std::vector<std::int64_t> triples_, neighbors_, pointStatus_, order_, ranks_, regions_;
  std::vector<std::uint8_t> edges_;
  VoronoiCells cells_;
  Sampler sampler_;
  std::vector<double> heights_, sampled_;
};

} // namespace test
} // namespace ahd

#endif
