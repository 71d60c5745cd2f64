// SPDX-License-Identifier: BSD-3-Clause
//
// The steps of a preparation that deal with constraints.
#include "Preparation.h"

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
  out_.firstCell_ = request_.firstCell;
  out_.lines_ = request_.lines.cells;
  out_.ids_.reserve(segmentsOf(request_));
  out_.offsets_.reserve(request_.lines.cells + request_.polygons.cells + 1);
  out_.offsets_.push_back(0);
  const bool all = ticker.ask() && readCells(request_.lines, ticker) &&
    readCells(request_.polygons, ticker) && followMerged(ticker) &&
    (!request_.closedLinesAreLoops || closeLines(ticker));
  return all ? Status::Ok : Status::Cancelled;
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

/// Does a line of three segments or more end where it begins?
bool Preparation::isClosed(std::size_t chain) const
{
  const std::int64_t begin = out_.offsets_[chain], end = out_.offsets_[chain + 1];
  if (end - begin < 4)
  {
    return false;
  }
  const std::int64_t first = out_.ids_[static_cast<std::size_t>(begin)];
  const std::int64_t last = out_.ids_[static_cast<std::size_t>(end - 1)];
  if (first < 0 || last < 0 || first == last)
  {
    return first == last && first >= 0;
  }
  const auto a = out_.place(static_cast<std::size_t>(first));
  const auto b = out_.place(static_cast<std::size_t>(last));
  return a[0] == b[0] && a[1] == b[1];
}

/// Puts the closed lines behind the open ones, where they are loops. Returns false if cancelled.
bool Preparation::closeLines(Ticker& ticker)
{
  const std::size_t chains = out_.offsets_.size() - 1;
  std::vector<std::int64_t> order, closed;
  order.reserve(chains);
  for (std::size_t chain = 0; chain < out_.lines_; ++chain)
  {
    (isClosed(chain) ? closed : order).push_back(static_cast<std::int64_t>(chain));
    if (!ticker.step())
    {
      return false;
    }
  }
  if (closed.empty())
  {
    return true;
  }
  const std::size_t lines = order.size();
  order.insert(order.end(), closed.begin(), closed.end());
  for (std::size_t chain = out_.lines_; chain < chains; ++chain)
  {
    order.push_back(static_cast<std::int64_t>(chain));
  }
  out_.lines_ = lines;
  return reorderChains(order, ticker);
}

/// Chain k becomes the one that is `order[k]` now. Returns false if the work is cancelled.
bool Preparation::reorderChains(const std::vector<std::int64_t>& order, Ticker& ticker)
{
  std::vector<std::int64_t> ids, offsets;
  ids.reserve(out_.ids_.size());
  offsets.reserve(out_.offsets_.size());
  offsets.push_back(0);
  for (const std::int64_t chain : order)
  {
    const auto* const range = out_.offsets_.data() + chain;
    for (std::int64_t i = range[0]; i < range[1]; ++i)
    {
      ids.push_back(out_.ids_[static_cast<std::size_t>(i)]);
      if (!ticker.step())
      {
        return false;
      }
    }
    offsets.push_back(static_cast<std::int64_t>(ids.size()));
  }
  out_.ids_ = std::move(ids);
  out_.offsets_ = std::move(offsets);
  out_.cells_ = order;
  return ticker.step();
}

Status Preparation::split()
{
  if (!out_.hasConstraints() || !request_.split)
  {
    return Status::Ok;
  }
  SplitConstraints split;
  const Status status = splitAtCrossings(
    out_.points_, out_.constraints(), &phases_, split, request_.mostCrossings);
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
    const auto a = endsOf(p.lower.chain, p.lower.segment);
    const auto b = endsOf(p.upper.chain, p.upper.segment);
    out_.crossings_.push_back(
      { { { a[0], a[1], b[0], b[1] } }, { { p.lower.along, p.upper.along } } });
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
