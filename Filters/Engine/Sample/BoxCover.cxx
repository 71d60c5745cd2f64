// SPDX-License-Identifier: BSD-3-Clause
#include "BoxNeighbors.h"

#include "../Core/Border.h"
#include "../Core/Chunks.h"
#include "../Core/Progress.h"

#include <algorithm>
#include <utility>

namespace ahd
{

namespace
{

/// Some places and the box around them.
struct Covered
{
  std::size_t begin, end; ///< in the list of places
  Bounds box;
};

/// Places, halved again and again.
class BoxCover
{
public:
  explicit BoxCover(const PointView& places)
    : places_(places)
  {
  }

  /// Returns false if cancelled; throws std::bad_alloc.
  bool run(std::size_t most, Ticker& ticker, std::vector<Bounds>& boxes)
  {
    const auto list = [this](std::size_t a, std::size_t b)
    {
      for (std::size_t k = a; k != b; ++k)
      {
        if (isFinite(places_[k]))
        {
          list_.push_back(places_[k]);
        }
      }
    };
    if (!inChunks(0, places_.count, ticker, list) || list_.empty())
    {
      return list_.empty() && ticker.ask();
    }
    parts_.assign(1, { 0, list_.size(), Bounds() });
    if (!measure(parts_[0], ticker))
    {
      return false;
    }
    while (parts_.size() < most)
    {
      const auto largest = std::max_element(parts_.begin(), parts_.end(),
        [](const Covered& a, const Covered& b) { return weight(a) < weight(b); });
      if (weight(*largest) < 2)
      {
        break;
      }
      if (!halve(static_cast<std::size_t>(largest - parts_.begin()), ticker))
      {
        return false;
      }
    }
    for (const Covered& part : parts_)
    {
      boxes.push_back(part.box);
    }
    return true;
  }

private:
  /// None if it cannot be halved.
  static std::size_t weight(const Covered& part)
  {
    const bool isPoint = part.box.xmin == part.box.xmax && part.box.ymin == part.box.ymax;
    return isPoint ? 0 : part.end - part.begin;
  }

  bool measure(Covered& part, Ticker& ticker) const
  {
    const Point first = list_[part.begin];
    part.box.xmin = part.box.xmax = first.x;
    part.box.ymin = part.box.ymax = first.y;
    return inChunks(part.begin, part.end, ticker,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t k = a; k != b; ++k)
        {
          part.box.xmin = std::min(part.box.xmin, list_[k].x);
          part.box.xmax = std::max(part.box.xmax, list_[k].x);
          part.box.ymin = std::min(part.box.ymin, list_[k].y);
          part.box.ymax = std::max(part.box.ymax, list_[k].y);
        }
      });
  }

  /// At the middle of the longer side: either half has places, as the box is tight.
  bool halve(std::size_t part, Ticker& ticker)
  {
    const Bounds box = parts_[part].box;
    const bool isAcrossX = 0.5 * box.xmax - 0.5 * box.xmin >= 0.5 * box.ymax - 0.5 * box.ymin;
    const double low = isAcrossX ? box.xmin : box.ymin;
    const double at = 0.5 * low + 0.5 * (isAcrossX ? box.xmax : box.ymax);
    std::size_t middle = parts_[part].begin;
    const auto move = [&](std::size_t a, std::size_t b)
    {
      for (std::size_t k = a; k != b; ++k)
      {
        const double v = isAcrossX ? list_[k].x : list_[k].y;
        if (v < at || v == low) // the middle of neighbouring numbers may be the lower one
        {
          std::swap(list_[k], list_[middle++]);
        }
      }
    };
    if (!inChunks(parts_[part].begin, parts_[part].end, ticker, move))
    {
      return false;
    }
    Covered above{ middle, parts_[part].end, Bounds() };
    parts_[part].end = middle;
    if (!measure(parts_[part], ticker) || !measure(above, ticker))
    {
      return false;
    }
    parts_.push_back(above);
    return true;
  }

  const PointView& places_;
  std::vector<Point> list_;
  std::vector<Covered> parts_;
};

} // namespace

Status coverByBoxes(
  const PointView& places, std::size_t most, const Context& context, std::vector<Bounds>& boxes)
{
  boxes.clear();
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0);
      return ticker.ask() && BoxCover(places).run(most, ticker, boxes);
    });
}

} // namespace ahd
