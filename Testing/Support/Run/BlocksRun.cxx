// SPDX-License-Identifier: BSD-3-Clause
#include "BlocksRun.h"

#include "Engine.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

namespace ahd
{
namespace test
{

BlockInput OwnPoints::input(std::size_t block, std::size_t blocks) const
{
  BlockInput result;
  result.block = block;
  result.blocks = blocks;
  result.points = PointView(xyz.data(), ids.size(), 3);
  result.points.skip = skip.data();
  result.ids = ids.data();
  return result;
}

std::vector<OwnPoints> deal(const PointView& points, const BlocksWay& way)
{
  BlockCuts cuts;
  std::vector<Point> samples;
  samplePoints(points, way.blocks * way.samples, samples);
  cutIntoBlocks(samples, way.blocks, Context(), cuts);
  std::vector<OwnPoints> blocks(way.blocks);
  for (std::size_t i = 0; i < points.count; ++i)
  {
    const std::size_t owner = way.owner ? way.owner(points[i]) : cuts.ownerOf(points[i]);
    OwnPoints& own = blocks.at(owner);
    for (const double v : { points[i].x, points[i].y, points.z(i) })
    {
      own.xyz.push_back(v);
    }
    own.ids.push_back(std::int64_t(i));
    own.skip.push_back(points.skipped(i) ? 1 : 0);
  }
  return blocks;
}

namespace
{

/// From the smallest id on, sorted by triples; flags go with them.
void normalise(BlocksOutcome& outcome)
{
  const std::size_t count = outcome.flags.size();
  struct Row
  {
    std::array<std::int32_t, 3> ids;
    unsigned flags;
    bool operator<(const Row& other) const { return ids < other.ids; }
  };
  std::vector<Row> rows(count);
  for (std::size_t t = 0; t < count; ++t)
  {
    const std::int32_t* const ids = outcome.triples.data() + 3 * t;
    const std::size_t first = std::size_t(std::min_element(ids, ids + 3) - ids);
    rows[t].flags = 0;
    for (std::size_t e = 0; e < 3; ++e)
    {
      rows[t].ids[e] = ids[(first + e) % 3];
      rows[t].flags |= (unsigned(outcome.flags[t]) >> (first + e) % 3 & 1u) << e;
    }
  }
  std::sort(rows.begin(), rows.end());
  for (std::size_t t = 0; t < count; ++t)
  {
    std::copy(
      rows[t].ids.begin(), rows[t].ids.end(), outcome.triples.begin() + std::ptrdiff_t(3 * t));
    outcome.flags[t] = std::uint8_t(rows[t].flags);
  }
}

/// One run of all blocks.
class Simulation
{
public:
  Simulation(const PointView& points, const BlocksWay& way)
    : points_(points)
    , way_(way)
    , dealt_(deal(points, way))
    , blocks_(way.blocks)
  {
  }

  BlocksOutcome run(const ConstraintView& constraints, FillRule rule)
  {
    using Waiting = BlockTriangulation::Waiting;
    bool isGoing = each([&](std::size_t b) { return begin(b, constraints, rule); });
    while (isGoing && blocks_[0].waiting() != Waiting::ForNothing)
    {
      isGoing = blocks_[0].waiting() == Waiting::ForAll ? stepAll() : stepSome();
    }
    if (isGoing)
    {
      collect();
    }
    return result_;
  }

private:
  template <typename Step>
  bool each(Step step)
  {
    for (std::size_t b = 0; b < blocks_.size(); ++b)
    {
      result_.status = step(b);
      if (result_.status != Status::Ok)
      {
        return false;
      }
    }
    return true;
  }

  Status begin(std::size_t b, const ConstraintView& constraints, FillRule rule)
  {
    BlockInput input = dealt_[b].input(b, blocks_.size());
    input.points.isFlat = points_.isFlat;
    input.constraints = constraints;
    input.rule = rule;
    input.options = way_.options;
    input.blocksPerNode = way_.blocksPerNode;
    result_.own.push_back(dealt_[b].ids.size());
    return blocks_[b].begin(input, way_.context);
  }

  bool stepAll()
  {
    std::vector<BlockBytes> all;
    for (const BlockTriangulation& block : blocks_)
    {
      expect(block.waiting() == BlockTriangulation::Waiting::ForAll, "a block waits otherwise");
      all.push_back(block.toAll());
    }
    return each([&](std::size_t b) { return blocks_[b].takeAll(all, way_.context); });
  }

  bool stepSome()
  {
    const std::vector<BorderCount> borders = blocks_[0].borders();
    if (!borders.empty() && result_.border.empty())
    {
      for (const BorderCount& count : borders)
      {
        result_.border.push_back(count.points);
      }
    }
    levels_ += borders.empty() ? 0 : 1;
    if (!borders.empty() && levels_ - 1 == way_.gatherLevel)
    {
      for (BlockTriangulation& block : blocks_)
      {
        block.gatherTo(way_.gatherBlock);
      }
    }
    std::vector<std::vector<BlockMessage>> in(blocks_.size());
    const bool isGoing = each([&](std::size_t b) { return send(b, in); });
    return isGoing && each([&](std::size_t b) { return blocks_[b].takeSome(in[b], way_.context); });
  }

  Status send(std::size_t b, std::vector<std::vector<BlockMessage>>& in)
  {
    std::vector<BlockMessage> out;
    const Status status = blocks_[b].giveSome(out, way_.context);
    for (BlockMessage& message : out)
    {
      result_.bytesSent += message.bytes.size();
      std::vector<BlockMessage>& to = in.at(message.block);
      message.block = b;
      to.push_back(std::move(message));
    }
    return status;
  }

  void collect()
  {
    result_.report = blocks_[0].report();
    result_.pointStatus.resize(points_.count);
    around_.assign(points_.count, 0);
    each([&](std::size_t b) { return collectFrom(b); });
    compareAround();
    expect(ghosts_ == shared_, "ghosts that are not as their owner has them, in its order");
    expect(result_.flags.size() == result_.report.counts.triangles, "the sum of the triangles");
    normalise(result_);
  }

  Status collectFrom(std::size_t b)
  {
    BlockTriangulation& block = blocks_[b];
    const OwnPoints& own = dealt_[b];
    std::vector<std::int32_t> triples(3 * block.triangles());
    std::vector<std::uint8_t> flags(block.triangles());
    std::vector<std::int64_t> statuses(own.ids.size());
    expect(block.writeTriangles(triples.data(), way_.context) == Status::Ok, "triangles");
    const std::vector<std::int32_t> first = triples;
    expect(block.writeTriangles(triples.data(), way_.context) == Status::Ok, "triangles");
    expect(first == triples, "triangles that are written twice");
    expect(block.writeConstraintEdges(flags.data(), way_.context) == Status::Ok, "edges");
    expect(block.writePointStatus(statuses.data(), way_.context) == Status::Ok, "statuses");
    for (std::size_t i = 0; i < statuses.size(); ++i)
    {
      result_.pointStatus[std::size_t(own.ids[i])] = statuses[i];
    }
    const std::vector<ForeignPoint>& others = block.foreignPoints();
    const auto isAfter = [](const ForeignPoint& p, const ForeignPoint& q) { return p.id >= q.id; };
    expect(std::adjacent_find(others.begin(), others.end(), isAfter) == others.end(),
      "foreign points that are there twice");
    std::size_t lowest = 0;
    for (std::size_t i = 0; i < triples.size(); ++i)
    {
      const auto number = std::size_t(triples[i]);
      const bool isOwn = number < own.ids.size();
      const std::int64_t id = isOwn ? own.ids[number]
                                    : block.foreignPoints().at(number - own.ids.size()).id;
      if (!isOwn)
      {
        const ForeignPoint& foreign = block.foreignPoints()[number - own.ids.size()];
        const std::vector<std::int64_t>& theirs = dealt_.at(foreign.block).ids;
        expect(foreign.block != b && points_[std::size_t(id)] == foreign.at &&
            std::binary_search(theirs.begin(), theirs.end(), id),
          "a foreign point");
      }
      result_.triples.push_back(std::int32_t(id));
      lowest = i % 3 == 0 ||
          lexicographicallyLess(points_[std::size_t(id)],
            points_[std::size_t(result_.triples[result_.triples.size() - 1 - i % 3 + lowest])])
        ? i % 3
        : lowest;
      if (i % 3 == 2)
      {
        const std::size_t corner = std::size_t(triples[i - 2 + lowest]);
        expect(corner < own.ids.size(), "a triangle on another block than its lowest corner");
      }
    }
    result_.flags.insert(result_.flags.end(), flags.begin(), flags.end());
    listShared(b, triples, flags, shared_);
    countAround(b, triples);
    return Status::Ok;
  }

  /// Triangles by their block and one that owns another corner: ids, flags.
  using SharedRows =
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::array<std::int64_t, 4>>>;

  /// Lists triangles of block b, or ghosts there, that others own a corner of.
  void listShared(std::size_t b, const std::vector<std::int32_t>& triples,
    const std::vector<std::uint8_t>& flags, SharedRows& rows) const
  {
    const std::vector<std::int64_t>& own = dealt_[b].ids;
    for (std::size_t t = 0; t < flags.size(); ++t)
    {
      std::array<std::int64_t, 4> row = { { 0, 0, 0, flags[t] } };
      std::array<std::size_t, 3> owners;
      for (std::size_t e = 0; e < 3; ++e)
      {
        const auto number = std::size_t(triples[3 * t + e]);
        const bool isOwn = number < own.size();
        const ForeignPoint* const foreign = isOwn
          ? nullptr
          : &blocks_[b].foreignPoints()[number - own.size()];
        row[e] = isOwn ? own[number] : foreign->id;
        owners[e] = isOwn ? b : foreign->block;
      }
      if (owners[0] != b)
      {
        rows[{ owners[0], b }].push_back(row);
        continue;
      }
      for (std::size_t e = 1; e < 3; ++e)
      {
        if (owners[e] != b && (e == 1 || owners[e] != owners[1]))
        {
          rows[{ b, owners[e] }].push_back(row);
        }
      }
    }
  }

  /// Counts the triangles around each own vertex, ghosts included.
  void countAround(std::size_t b, std::vector<std::int32_t> triples)
  {
    const std::size_t own = triples.size(), points = dealt_[b].ids.size();
    triples.resize(own + 3 * blocks_[b].ghostTriangles());
    expect(
      blocks_[b].writeGhostTriangles(triples.data() + own, way_.context) == Status::Ok, "ghosts");
    std::vector<std::uint8_t> flags(blocks_[b].ghostTriangles());
    expect(blocks_[b].writeGhostConstraintEdges(flags.data(), way_.context) == Status::Ok,
      "edges of ghosts");
    listShared(b, { triples.begin() + std::ptrdiff_t(own), triples.end() }, flags, ghosts_);
    for (std::size_t t = 0; t < triples.size(); t += 3)
    {
      std::size_t owned = 0;
      for (std::size_t e = 0; e < 3; ++e)
      {
        const auto number = std::size_t(triples[t + e]);
        owned += number < points ? 1 : 0;
        expect(number < points + blocks_[b].foreignPoints().size(), "a corner's number");
        if (number < points)
        {
          ++around_[std::size_t(dealt_[b].ids[number])];
        }
      }
      expect(owned > 0, "a triangle without own corner");
      expect(t < own || std::size_t(triples[t]) >= points, "a ghost with the lowest corner");
    }
  }

  /// Each vertex has all of its triangles on its block.
  void compareAround()
  {
    for (const std::int32_t id : result_.triples)
    {
      --around_[std::size_t(id)];
    }
    expect(std::count(around_.begin(), around_.end(), 0) == std::ptrdiff_t(around_.size()),
      "the triangles around own vertices");
  }

  void expect(bool isRight, const char* what)
  {
    if (!isRight && result_.fault.empty())
    {
      result_.fault = what;
    }
  }

  const PointView& points_;
  const BlocksWay& way_;
  std::vector<OwnPoints> dealt_;
  std::vector<BlockTriangulation> blocks_;
  std::size_t levels_ = 0;
  std::vector<std::int32_t> around_; ///< by id: triangles on the own block
  SharedRows shared_, ghosts_;
  BlocksOutcome result_;
};

} // namespace

BlocksOutcome runBlocks(
  const PointView& points, const ConstraintView& constraints, FillRule rule, const BlocksWay& way)
{
  return Simulation(points, way).run(constraints, rule);
}

BlocksOutcome runWhole(
  const PointView& points, const ConstraintView& constraints, FillRule rule, const Options& options)
{
  Engine engine;
  BlocksOutcome result;
  result.status = engine.run(points, options);
  if (result.status == Status::Ok && constraints.chains > 0)
  {
    result.status = engine.constrain(constraints, rule);
  }
  const Report& report = engine.report();
  result.report.counts = report;
  result.report.constraints = engine.constraints();
  result.triples.resize(3 * report.triangles);
  result.flags.resize(report.triangles);
  result.pointStatus.resize(points.count);
  engine.writeTriangles(result.triples.data());
  if (constraints.chains > 0)
  {
    engine.writeConstraintEdges(result.flags.data());
  }
  engine.writePointStatus(result.pointStatus.data());
  normalise(result);
  return result;
}

std::string difference(const BlocksOutcome& whole, const BlocksOutcome& blocks)
{
  const auto counts = [](const BlocksReport& r)
  {
    return std::vector<std::size_t>{ r.counts.inserted, r.counts.duplicates, r.counts.notFinite,
      r.counts.skipped, r.counts.triangles, r.constraints.segments, r.constraints.points,
      r.constraints.withoutVertex, r.constraints.crossing, r.constraints.unfilledLoops,
      r.constraints.edges };
  };
  const auto rows = [](const BlocksReport& r)
  {
    std::vector<std::size_t> result;
    for (const LeftOut& row : r.constraints.leftOut)
    {
      for (const std::size_t v : { row.chain, row.segment, row.otherChain, row.otherSegment })
      {
        result.push_back(v);
      }
    }
    return result;
  };
  return blocks.status != whole.status ? "statuses differ"
    : !blocks.fault.empty()            ? "fault: " + blocks.fault
    : blocks.triples != whole.triples  ? "triangles differ: " + std::to_string(whole.flags.size()) +
      " and " + std::to_string(blocks.flags.size())
    : blocks.flags != whole.flags                   ? "constraint edges differ"
    : blocks.pointStatus != whole.pointStatus       ? "point statuses differ"
    : counts(blocks.report) != counts(whole.report) ? "counts differ"
    : rows(blocks.report) != rows(whole.report)     ? "other segments are left out"
                                                    : "";
}

} // namespace test
} // namespace ahd
