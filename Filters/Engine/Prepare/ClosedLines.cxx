// SPDX-License-Identifier: BSD-3-Clause
#include "ClosedLines.h"

#include "../Core/SortAsking.h"

#include <algorithm>
#include <utility>

namespace ahd
{
namespace
{

/// An end of a line: 2 * line where it begins, 2 * line + 1 where it ends.
using End = std::size_t;
constexpr End kNoEnd = End(-1);

struct PlacedEnd
{
  Point at;
  End end;
};

/// Lines that are a loop together.
struct Loop
{
  std::size_t cell;         ///< the first of them
  std::size_t begin, count; ///< among the ends
};

class Closer
{
public:
  Closer(const std::vector<LineEnds>& lines, Chains& chains, Ticker& ticker)
    : lines_(lines)
    , chains_(chains)
    , ticker_(ticker)
    , mates_(2 * lines.size(), kNoEnd)
    , isPassed_(lines.size(), 0)
  {
  }

  bool findLoops() { return pairEnds() && follow(kEndsOnly) && follow(kAll); }
  bool hasLoops() const { return !loops_.empty(); }
  bool write();

private:
  enum From
  {
    kEndsOnly, ///< from ends that are not joined
    kAll
  };

  const Point& at(End end) const
  {
    const LineEnds& line = lines_[end / 2];
    return end % 2 == 0 ? line.first : line.last;
  }
  std::int64_t segmentsOf(std::size_t line) const
  {
    return chains_.offsets[line + 1] - chains_.offsets[line] - 1;
  }
  bool pairEnds();
  bool follow(From from);
  bool followFrom(End begin);
  void addLoop(std::size_t begin);
  bool addChain(std::size_t chain);
  bool addToLoop(End enteredAt);
  bool endChain(std::size_t cell);

  const std::vector<LineEnds>& lines_;
  Chains& chains_;
  Ticker& ticker_;
  std::vector<End> mates_;     ///< of each end the one that it is joined to
  std::vector<char> isPassed_; ///< of each line
  std::vector<End> entered_;   ///< of each line of a loop, in order, where the loop enters it
  std::vector<Loop> loops_;
  Chains made_;
};

/// Joins ends that are the only two at a place.
bool Closer::pairEnds()
{
  std::vector<PlacedEnd> ends;
  ends.reserve(mates_.size());
  for (End end = 0; end != mates_.size(); ++end)
  {
    if (!lines_[end / 2].areOne && isFinite(at(end)))
    {
      ends.push_back({ at(end), end });
    }
    if (!ticker_.step())
    {
      return false;
    }
  }
  if (!sortAsking(ends, ticker_,
        [](const PlacedEnd& a, const PlacedEnd& b) { return lexicographicallyLess(a.at, b.at); }))
  {
    return false;
  }
  for (std::size_t i = 0, next = 0; i != ends.size(); i = next)
  {
    for (next = i + 1; next != ends.size() && ends[next].at == ends[i].at; ++next)
    {
    }
    if (next - i == 2)
    {
      mates_[ends[i].end] = ends[i + 1].end;
      mates_[ends[i + 1].end] = ends[i].end;
    }
    if (!ticker_.step())
    {
      return false;
    }
  }
  return true;
}

bool Closer::follow(From from)
{
  for (End end = 0; end != mates_.size(); ++end)
  {
    const bool begins = from == kAll || mates_[end] == kNoEnd;
    if ((begins && isPassed_[end / 2] == 0 && !followFrom(end)) || !ticker_.step())
    {
      return false;
    }
  }
  return true;
}

/// The joined line that begins there. @pre it has not been passed; all of it is joined there, or
/// the end is not
bool Closer::followFrom(End begin)
{
  const std::size_t first = entered_.size();
  End end = begin, out = kNoEnd;
  std::int64_t segments = 0;
  for (; end != kNoEnd && isPassed_[end / 2] == 0; end = mates_[out])
  {
    isPassed_[end / 2] = 1;
    entered_.push_back(end);
    segments += segmentsOf(end / 2);
    out = end ^ 1;
    if (!ticker_.step())
    {
      return false;
    }
  }
  if (segments > 2 && (lines_[begin / 2].areOne || end == begin || at(begin) == at(out)))
  {
    addLoop(first);
  }
  else
  {
    entered_.resize(first);
  }
  return true;
}

/// Of the ends from there on: in the direction and from the line where it is to run.
void Closer::addLoop(std::size_t begin)
{
  const auto from = entered_.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto leads = [this](End a, End b)
  {
    const LineEnds &one = lines_[a / 2], &other = lines_[b / 2];
    const auto less = lexicographicallyLess;
    return less(one.first, other.first) ||
      (one.first == other.first &&
        (less(one.last, other.last) || (one.last == other.last && a / 2 < b / 2)));
  };
  if (*std::min_element(from, entered_.end(), leads) % 2 == 1)
  {
    std::reverse(from, entered_.end());
    std::for_each(from, entered_.end(), [](End& end) { end ^= 1; });
  }
  const auto first = std::min_element(
    from, entered_.end(), [](End a, End b) { return a / 2 < b / 2; });
  loops_.push_back({ *first / 2, begin, entered_.size() - begin });
  std::rotate(from, first, entered_.end());
}

bool Closer::addChain(std::size_t chain)
{
  const auto begin = chains_.ids.begin();
  made_.ids.insert(
    made_.ids.end(), begin + chains_.offsets[chain], begin + chains_.offsets[chain + 1]);
  return endChain(chain);
}

bool Closer::endChain(std::size_t cell)
{
  made_.offsets.push_back(static_cast<std::int64_t>(made_.ids.size()));
  made_.cells.push_back(chains_.cells[cell]);
  return ticker_.step();
}

/// The ids of a line from the end on where its loop, the last chain, enters it; but for one that
/// the line before it ends with.
bool Closer::addToLoop(End enteredAt)
{
  const std::int64_t begin = chains_.offsets[enteredAt / 2];
  const std::int64_t last = chains_.offsets[enteredAt / 2 + 1] - 1;
  const auto loop = static_cast<std::size_t>(made_.offsets.back());
  for (std::int64_t i = begin; i <= last; ++i)
  {
    const std::int64_t at = enteredAt % 2 == 0 ? i : last - (i - begin);
    const std::int64_t id = chains_.ids[static_cast<std::size_t>(at)];
    if (i != begin || made_.ids.size() == loop || made_.ids.back() != id)
    {
      made_.ids.push_back(id);
    }
    if (!ticker_.step())
    {
      return false;
    }
  }
  return true;
}

bool Closer::write()
{
  made_.ids.reserve(chains_.ids.size());
  made_.offsets.push_back(0);
  std::vector<char> isInLoop(lines_.size(), 0);
  bool all = sortAsking(
    loops_, ticker_, [](const Loop& a, const Loop& b) { return a.cell < b.cell; });
  std::for_each(entered_.begin(), entered_.end(), [&](End end) { isInLoop[end / 2] = 1; });
  for (std::size_t line = 0; all && line != lines_.size(); ++line)
  {
    all = isInLoop[line] != 0 || addChain(line);
  }
  made_.lines = made_.cells.size();
  for (const Loop& loop : loops_)
  {
    for (std::size_t k = loop.begin; all && k != loop.begin + loop.count; ++k)
    {
      all = addToLoop(entered_[k]);
    }
    all = all && endChain(loop.cell);
  }
  for (std::size_t chain = lines_.size(); all && chain != chains_.cells.size(); ++chain)
  {
    all = addChain(chain);
  }
  chains_ = std::move(made_);
  return all;
}

} // namespace

bool closeLines(const std::vector<LineEnds>& ends, Chains& chains, Ticker& ticker, bool& found)
{
  Closer closer(ends, chains, ticker);
  const bool all = closer.findLoops();
  found = closer.hasLoops();
  return all && (!found || closer.write());
}

std::size_t closingMemoryEstimate(std::size_t lines)
{
  // Per line: its ends; those that may be joined, sorted; what they are joined to; a loop's end as
  // a list grows, and a loop; two marks.
  return lines *
    (sizeof(LineEnds) + 2 * 2 * sizeof(PlacedEnd) + 2 * sizeof(End) + 3 * sizeof(End) +
      3 * sizeof(Loop) + 2);
}

} // namespace ahd
