// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BlockTree_h
#define ahd_BlockTree_h

#include "Distribute/BlockCuts.h"
#include "Distribute/BlockFronts.h"
#include "Distribute/Part.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <numeric>
#include <vector>

namespace ahd
{
namespace test
{

/// CPU time of this thread.
inline double secondsOfThread()
{
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

inline void require(bool isSo, const char* what)
{
  if (!isSo)
  {
    std::cerr << "BlockCounts: " << what << "\n";
    std::exit(1);
  }
}

/// Many of the same kind: blocks, or parts of one level.
struct Many
{
  double sum = 0.0, most = 0.0;
  std::size_t count = 0;

  void add(double value)
  {
    sum += value;
    most = std::max(most, value);
    ++count;
  }
  double mean() const { return count == 0 ? 0.0 : sum / double(count); }
};

/// The boxes that kd-cuts of uniform points make, and the points in them.
class Boxes
{
public:
  Boxes(std::size_t blocks, std::size_t each)
    : boxes_(blocks)
    , each_(each)
  {
    const double side = std::sqrt(double(blocks));
    cut(0, blocks, { 0.0, side, 0.0, side });
  }

  std::size_t blocks() const { return boxes_.size(); }
  std::size_t each() const { return each_; }

  /// Always the same ones.
  void draw(std::size_t block, std::vector<Point>& points) const
  {
    const Bounds& box = boxes_[block];
    points.resize(each_);
    std::uint64_t number = block * each_;
    for (Point& p : points)
    {
      p.x = box.xmin + drawn(2 * number) * (box.xmax - box.xmin);
      p.y = box.ymin + drawn(2 * number + 1) * (box.ymax - box.ymin);
      ++number;
    }
  }

private:
  static double drawn(std::uint64_t i)
  {
    i = (i + 1) * 0x9E3779B97F4A7C15u;
    i = (i ^ i >> 30) * 0xBF58476D1CE4E5B9u;
    i = (i ^ i >> 27) * 0x94D049BB133111EBu;
    return double((i ^ i >> 31) >> 11) * 0x1p-53;
  }

  void cut(std::size_t begin, std::size_t end, const Bounds& box)
  {
    if (end - begin == 1)
    {
      boxes_[begin] = box;
      return;
    }
    const std::size_t middle = middleBlock(begin, end);
    const double part = double(middle - begin) / double(end - begin);
    Bounds low = box, high = box;
    if (box.xmax - box.xmin >= box.ymax - box.ymin)
    {
      low.xmax = high.xmin = box.xmin + part * (box.xmax - box.xmin);
    }
    else
    {
      low.ymax = high.ymin = box.ymin + part * (box.ymax - box.ymin);
    }
    cut(begin, middle, low);
    cut(middle, end, high);
  }

  std::vector<Bounds> boxes_;
  std::size_t each_;
};

/// Counts and times of one level of the tree; level 0 are the blocks.
struct Level
{
  Many points;                            ///< that a part is made of
  Many borderPoints, borderEdges;         ///< that it sends up
  Many seconds;                           ///< of the common work: the search, or the whole part
  Many secondsDown;                       ///< listing the data for blocks
  std::size_t bytesUp = 0, bytesDown = 0; ///< messages, those to the sender itself as well
  std::size_t mostBytesIn = 0, mostBytesOut = 0; ///< of one part
  std::size_t triangles = 0;                     ///< that have become final
};

struct Counts
{
  Many own; ///< seconds of the blocks' own triangulations
  std::vector<Level> levels;
  std::size_t hull = 0;
};

/// The size of messages, as BlockTriangulation writes them.
inline std::size_t bytesOf(const PartBorder& border)
{
  return 16 + border.points.size() * sizeof(BorderPoint) + border.edges.size() * sizeof(BorderEdge);
}

inline std::size_t bytesOf(const OwnedTriangles& some)
{
  return some.corners.empty() ? 0
                              : 1 + 4 * 8 + some.points.size() * sizeof(BorderPoint) +
      some.corners.size() * sizeof(Index) + some.flags.size();
}

/// The tree of parts over the blocks, from the bottom up.
class Tree
{
public:
  explicit Tree(const Boxes& boxes)
    : boxes_(boxes)
    , borders_(boxes.blocks())
  {
  }

  Counts run()
  {
    findBounds();
    counts_.levels.emplace_back();
    for (std::size_t block = 0; block != boxes_.blocks(); ++block)
    {
      makeBlock(block);
    }
    BlockFront below = BlockFront::ofBlocks(boxes_.blocks());
    do
    {
      const BlockFront front = below.rows() == 1 ? below.gatheredTo(0) : below.above(3);
      counts_.levels.emplace_back();
      std::vector<PartBorder> next(front.rows());
      for (std::size_t k = 0; k != front.rows(); ++k)
      {
        makePart(front, below, k, next[k]);
      }
      borders_.swap(next);
      below = front;
    } while (below.rows() != 1);
    return counts_;
  }

private:
  void findBounds()
  {
    std::vector<Bounds> bounds;
    for (std::size_t block = 0; block != boxes_.blocks(); ++block)
    {
      boxes_.draw(block, points_);
      Bounds box{ points_[0].x, points_[0].x, points_[0].y, points_[0].y };
      for (const Point& p : points_)
      {
        box = { std::min(box.xmin, p.x), std::max(box.xmax, p.x), std::min(box.ymin, p.y),
          std::max(box.ymax, p.y) };
      }
      bounds.push_back(box);
    }
    around_.boxes.set(std::move(bounds));
  }

  void makeBlock(std::size_t block)
  {
    Level& level = counts_.levels[0];
    boxes_.draw(block, points_);
    ids_.resize(points_.size());
    std::iota(ids_.begin(), ids_.end(), std::int64_t(block * boxes_.each()));
    const PointView view(&points_[0].x, points_.size(), 2);
    const BlockRow row{ block, block + 1 };
    const double begun = secondsOfThread();
    Part part;
    const Status status = part.makeOwn(
      view, ids_.data(), std::uint32_t(block), Options(), Context());
    require(status == Status::Ok, "a block's own triangulation");
    const double made = secondsOfThread();
    Ticker ticker(nullptr, Phase::Outputs, 0);
    require(part.findFinal(row, around_, ticker) && part.makeBorder(borders_[block], ticker),
      "a block's border");
    counts_.own.add(made - begun);
    level.points.add(double(points_.size()));
    finish(level, borders_[block], part, secondsOfThread() - made);
  }

  static void finish(Level& level, const PartBorder& border, const Part& part, double seconds)
  {
    level.seconds.add(seconds);
    level.borderPoints.add(double(border.points.size()));
    level.borderEdges.add(double(border.edges.size()));
    level.triangles += part.finalTriangles();
  }

  void makePart(const BlockFront& front, const BlockFront& below, std::size_t k, PartBorder& border)
  {
    Level& level = counts_.levels.back();
    const BlockRow row = front.row(k);
    const bool isTop = front.rows() == 1;
    std::vector<PartBorder> children;
    std::size_t in = 0;
    for (std::size_t child = below.rowOf(row.begin);
         child != below.rows() && below.row(child).begin < row.end; ++child)
    {
      in += bytesOf(borders_[child]);
      children.push_back(std::move(borders_[child]));
    }
    level.bytesUp += in;
    level.mostBytesIn = std::max(level.mostBytesIn, in);
    const double begun = secondsOfThread();
    Part part;
    Ticker ticker(nullptr, Phase::Outputs, 0);
    require(part.makeOf(children, Context()) == Status::Ok, "a part's triangulation");
    require(part.findBelow(ticker), "what is final below");
    require(isTop ? part.finishAll(ticker)
                  : part.findFinal(row, around_, ticker) && part.makeBorder(border, ticker),
      "a part's border");
    level.points.add(double(part.given().size()));
    finish(level, border, part, secondsOfThread() - begun);
    giveDown(part, row, level);
    counts_.hull = isTop ? hullOf(part.triangulation()) : 0;
  }

  /// Without loops no message from above is needed first.
  static void giveDown(const Part& part, const BlockRow& row, Level& level)
  {
    const double begun = secondsOfThread();
    std::vector<OwnedTriangles> owned;
    Ticker ticker(nullptr, Phase::Outputs, 0);
    require(part.listOwned(row, owned, ticker), "the triangles of a part");
    level.secondsDown.add(secondsOfThread() - begun);
    std::size_t out = 0;
    for (const OwnedTriangles& some : owned)
    {
      out += bytesOf(some);
    }
    level.bytesDown += out;
    level.mostBytesOut = std::max(level.mostBytesOut, out);
  }

  /// By Euler: of n vertices and t triangles.
  static std::size_t hullOf(const Triangulation& made)
  {
    return 2 * made.report().inserted - 2 - made.report().triangles;
  }

  const Boxes& boxes_;
  std::vector<PartBorder> borders_;
  Surroundings around_;
  std::vector<Point> points_;
  std::vector<std::int64_t> ids_;
  Counts counts_;
};

/// The result must be a triangulation of all points. They are all distinct, or few are not.
inline void requireWhole(const Counts& counts, std::size_t points)
{
  std::size_t triangles = 0;
  for (const Level& level : counts.levels)
  {
    triangles += level.triangles;
  }
  require(triangles == 2 * points - 2 - counts.hull, "triangles are missing, or too many");
}

} // namespace test
} // namespace ahd

#endif
