// SPDX-License-Identifier: BSD-3-Clause
//
// The steps of a preparation that deal with constraints.
#include "LineLayer.h"
#include "Preparation.h"

#include <limits>
#include <numeric>
#include <utility>

namespace ahd
{
namespace
{

/// Of PreparedInput::crossingCells.
constexpr std::size_t kMostCrossingCells = 1000;

} // namespace

Status Preparation::readConstraints()
{
  if (segmentsOf(request_) == 0)
  {
    return Status::Ok;
  }
  Ticker ticker(&phases_, Phase::Split, 0); // begins the phase
  const bool own = request_.idsAreOfInput;
  firstId_ = own ? 0 : static_cast<std::int64_t>(out_.inputCount_);
  idCount_ = static_cast<std::int64_t>(own ? out_.inputCount_ : out_.sourceCount_);
  const bool arePoints = arePointsLine(request_);
  out_.firstCell_ = arePoints ? 0 : request_.firstCell;
  out_.lines_ = arePoints ? 1 : request_.lines.cells;
  out_.ids_.reserve(segmentsOf(request_));
  out_.offsets_.reserve(out_.lines_ + request_.polygons.cells + 1);
  out_.offsets_.push_back(0);
  const bool all = ticker.ask() &&
    (arePoints ? readPoints(ticker)
               : readCells(request_.lines, ticker) && readCells(request_.polygons, ticker)) &&
    countFlatChains(ticker) && followMerged(ticker) &&
    (!request_.closedLinesAreLoops || closeLines(ticker));
  return all ? Status::Ok : Status::Cancelled;
}

/// Of the source, as one line.
bool Preparation::readPoints(Ticker& ticker)
{
  for (std::int64_t id = 0; id < idCount_; ++id)
  {
    readId(id);
    if (!ticker.step())
    {
      return false;
    }
  }
  out_.offsets_.push_back(idCount_);
  return true;
}

/// Of the source's own heights. Most have a first point that is none at 0.
bool Preparation::countFlatChains(Ticker& ticker)
{
  const bool areOwn = out_.sourceCount_ > 0 && !request_.idsAreOfInput && !out_.isProjected_ &&
    (request_.heights == SourceHeights::Own ||
      (request_.heights == SourceHeights::Mixed && !request_.zeroIsMissing));
  const auto isFlat = [this](std::int64_t id)
  {
    const auto i = static_cast<std::size_t>(id);
    return id >= 0 && out_.points_.z(i) == 0.0 && isFinite(out_.points_[i]);
  };
  for (std::size_t chain = 0; areOwn && chain + 1 < out_.offsets_.size(); ++chain)
  {
    const std::int64_t end = out_.offsets_[chain + 1];
    std::int64_t i = out_.offsets_[chain];
    bool isLine = end - i > 1;
    for (; isLine && i < end && ticker.step(); ++i)
    {
      isLine = isFlat(out_.ids_[static_cast<std::size_t>(i)]);
    }
    out_.sourceBounds_.flatChains += isLine ? 1 : 0;
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

bool Preparation::readCells(const CellsView& cells, Ticker& ticker)
{
  return cells.offsets64 ? readCells(cells.offsets64, cells.ids64, cells.cells, ticker)
                         : readCells(cells.offsets32, cells.ids32, cells.cells, ticker);
}

template <typename Number>
bool Preparation::readCells(
  const Number* offsets, const Number* ids, std::size_t cells, Ticker& ticker)
{
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    for (Number i = offsets[cell]; i < offsets[cell + 1]; ++i)
    {
      readId(ids[i]);
      if (!ticker.step())
      {
        return false;
      }
    }
    out_.offsets_.push_back(static_cast<std::int64_t>(out_.ids_.size()));
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

/// Of the cell that is being read.
void Preparation::readId(std::int64_t id)
{
  const bool fits = id >= 0 && id < idCount_;
  if (!fits && out_.unfit_.count++ == 0)
  {
    out_.unfit_.firstId = id;
    out_.unfit_.firstCell = out_.cellOf(out_.offsets_.size() - 1);
  }
  out_.ids_.push_back(fits ? firstId_ + id : -1);
}

/// Replaces each merged point by the kept one. Returns false if cancelled.
bool Preparation::followMerged(Ticker& ticker)
{
  const std::vector<MergedPoint>& merged = out_.merged_;
  if (merged.empty())
  {
    return true;
  }
  for (std::int64_t& id : out_.ids_)
  {
    const auto found = std::lower_bound(merged.begin(), merged.end(), id,
      [](const MergedPoint& m, std::int64_t i) { return std::int64_t(m.id) < i; });
    if (found != merged.end() && std::int64_t(found->id) == id)
    {
      id = found->keptId;
    }
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

LineEnds PreparedInput::endsOf(std::size_t chain) const
{
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto begin = static_cast<std::size_t>(offsets_[chain]);
  const auto end = static_cast<std::size_t>(offsets_[chain + 1]);
  const std::int64_t first = begin == end ? -1 : ids_[begin];
  const std::int64_t last = begin == end ? -1 : ids_[end - 1];
  const auto at = [&](std::int64_t id) {
    return id < 0 ? Point{ kNone, kNone } : points_[static_cast<std::size_t>(id)];
  };
  return { at(first), at(last), (first == last && first >= 0) || at(first) == at(last) };
}

/// Puts the closed lines behind the open ones, where they are loops. Returns false if cancelled.
bool Preparation::closeLines(Ticker& ticker)
{
  std::vector<LineEnds> ends;
  ends.reserve(out_.lines_);
  for (std::size_t line = 0; line < out_.lines_; ++line)
  {
    ends.push_back(out_.endsOf(line));
    if (!ticker.step())
    {
      return false;
    }
  }
  Chains chains{ std::move(out_.ids_), std::move(out_.offsets_), {}, out_.lines_ };
  chains.cells.resize(chains.offsets.size() - 1);
  std::iota(chains.cells.begin(), chains.cells.end(), std::int64_t(0));
  bool found = false;
  const bool all = ahd::closeLines(ends, chains, ticker, found);
  out_.areLinesUnclosed_ = !found && chains.haveSegments();
  out_.ids_ = std::move(chains.ids);
  out_.offsets_ = std::move(chains.offsets);
  if (found)
  {
    out_.lines_ = chains.lines;
    out_.cells_ = std::move(chains.cells);
  }
  return all;
}

/// On the surface that heights come from, and where they are to be divided.
Status Preparation::layLines()
{
  const bool laysThem = request_.linesOnSurface && surface_;
  if (!out_.hasConstraints() || !(laysThem || request_.maximumSegmentLength > 0.0))
  {
    return Status::Ok;
  }
  LinesToLay lines;
  lines.points = out_.points_;
  lines.chains = out_.constraints();
  lines.surface = laysThem ? surface_.get() : nullptr;
  lines.firstOfSource = out_.inputCount_;
  lines.isOnSurface = [this](Index from, Index to) { return isOnSurface(from, to); };
  lines.maximumLength = request_.maximumSegmentLength;
  lines.mostPoints = request_.mostCrossings;
  Ticker ticker(&phases_, Phase::Split, request_.split ? 0 : out_.ids_.size());
  LineLayer layer(lines, ticker);
  const Status status = layer.run();
  if (status != Status::Ok || (!layer.origins.empty() && !copy(Phase::Split)))
  {
    return status != Status::Ok ? status : Status::Cancelled;
  }
  out_.addedToLines_ = layer.origins.size();
  out_.ids_ = std::move(layer.ids);
  out_.offsets_ = std::move(layer.offsets);
  areOnSurface_ = std::move(layer.areOnSurface);
  out_.surfacePlaces_.resize(out_.sourceCount_);
  out_.surfacePlaces_.insert(out_.surfacePlaces_.end(), layer.origins.begin(), layer.origins.end());
  double* to = out_.addedToLines_ > 0 ? add(out_.addedToLines_) : nullptr;
  for (const Vector3& place : layer.places)
  {
    to = std::copy(place.begin(), place.end(), to);
  }
  return Status::Ok;
}

Status Preparation::split()
{
  if (!out_.hasConstraints() || !request_.split)
  {
    return Status::Ok;
  }
  SplitConstraints split;
  const Status status = splitAtCrossings(
    out_.points_, out_.constraints(), &phases_, split, request_.mostCrossings - out_.addedToLines_);
  if (status != Status::Ok || split.rounds == 0)
  {
    return status;
  }
  out_.bentCount_ = split.bent.size();
  out_.firstBentCell_ = split.bent.empty() ? 0 : out_.cellOf(split.bent.front().chain);
  if (!split.points.empty())
  {
    if (!copy(Phase::Split))
    {
      return Status::Cancelled;
    }
    addCrossings(split.points);
  }
  out_.ids_ = std::move(split.ids);
  out_.offsets_ = std::move(split.offsets);
  return status;
}

/// Adds the points, and records the points that they lie between. @pre the constraints are those
/// that were split.
void Preparation::addCrossings(const std::vector<CrossingPoint>& points)
{
  double* place = add(points.size());
  out_.crossings_.reserve(points.size());
  for (const CrossingPoint& p : points)
  {
    // Where one of the two has its heights from a surface, and the other its own, these count.
    const bool areAlike = isOnSurface(p.lower) == isOnSurface(p.upper);
    const CrossingPoint::Side &lower = areAlike || !isOnSurface(p.lower) ? p.lower : p.upper,
                              &upper = areAlike || !isOnSurface(p.upper) ? p.upper : p.lower;
    const auto a = endsOf(lower.chain, lower.segment), b = endsOf(upper.chain, upper.segment);
    out_.crossings_.push_back({ { { a[0], a[1], b[0], b[1] } }, { { lower.along, upper.along } } });
    if (out_.crossingCells_.size() < kMostCrossingCells)
    {
      out_.crossingCells_.push_back({ { out_.cellOf(p.chainB), out_.cellOf(p.chainA) } });
    }
    *place++ = p.at.x;
    *place++ = p.at.y;
    *place++ = 0.0;
  }
  out_.findCrossingHeights();
}

/// Of one of two pieces that cross.
bool Preparation::isOnSurface(const CrossingPoint::Side& side) const
{
  if (!areOnSurface_.empty())
  {
    return areOnSurface_[static_cast<std::size_t>(out_.offsets_[side.chain]) + side.segment] != 0;
  }
  const auto ends = endsOf(side.chain, side.segment);
  return isOnSurface(ends[0], ends[1]);
}

/// The points at the ends of a segment, the lexicographically smaller end first. @pre there is
/// such a segment, between points.
std::array<Index, 2> Preparation::endsOf(std::size_t chain, std::size_t segment) const
{
  const std::size_t begin = static_cast<std::size_t>(out_.offsets_[chain]);
  const std::size_t end = static_cast<std::size_t>(out_.offsets_[chain + 1]);
  const std::size_t first = begin + segment;
  const std::size_t second = first + 1 < end ? first + 1 : begin; // of a loop
  const auto a = static_cast<Index>(out_.ids_[first]), b = static_cast<Index>(out_.ids_[second]);
  const bool isForward = lexicographicallyLess(out_.points_[a], out_.points_[b]);
  return { { isForward ? a : b, isForward ? b : a } };
}

} // namespace ahd
