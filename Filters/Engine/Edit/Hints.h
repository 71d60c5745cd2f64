// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Hints_h
#define ahd_Hints_h

#include "../Points/Points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ahd
{

/// Where searches start: a grid of boxes, each with the vertex that was last put into it. Hints
/// change the time, never a result.
class Hints
{
public:
  void clear() { boxes_.clear(); }

  /// Has it too few boxes for so many vertices?
  bool isDue(std::size_t vertices) const { return vertices > kMostPerBox * boxes_.size() + kFew; }

  /// A grid for so many vertices, empty. Throws std::bad_alloc.
  void build(const Bounds& bounds, std::size_t vertices)
  {
    side_ = static_cast<std::size_t>(std::sqrt(double(vertices / kPerBox))) + 1;
    xmin_ = bounds.xmin;
    ymin_ = bounds.ymin;
    perX_ = double(side_) / (bounds.xmax - bounds.xmin);
    perY_ = double(side_) / (bounds.ymax - bounds.ymin);
    boxes_.assign(side_ * side_, kNoIndex);
  }

  void put(const Point& p, Index vertex)
  {
    if (!boxes_.empty())
    {
      boxes_[boxOf(p)] = vertex;
    }
  }

  /// A vertex for which isThere(vertex), from the box of the place or one of the next around it;
  /// else kNoIndex.
  template <typename IsThere>
  Index near(const Point& p, const IsThere& isThere) const
  {
    if (boxes_.empty())
    {
      return kNoIndex;
    }
    const std::size_t row = along(ymin_, perY_, p.y), column = along(xmin_, perX_, p.x);
    for (std::size_t r = 0; r <= kMostAround; ++r)
    {
      for (std::size_t y = row - std::min(r, row); y <= std::min(row + r, side_ - 1); ++y)
      {
        for (std::size_t x = column - std::min(r, column); x <= std::min(column + r, side_ - 1);
             ++x)
        {
          const Index vertex = boxes_[y * side_ + x];
          if (vertex != kNoIndex && isThere(vertex))
          {
            return vertex;
          }
        }
      }
    }
    return kNoIndex;
  }

  static constexpr std::size_t bytesFor(std::size_t vertices)
  {
    return 2 * vertices * sizeof(Index);
  }

private:
  // Few boxes are empty: a walk from far away costs more than one within a box.
  static constexpr std::size_t kPerBox = 3, kMostPerBox = 12, kFew = 64, kMostAround = 3;

  /// Places outside count as at the border; a product that is no number as at the first box.
  std::size_t along(double from, double perUnit, double at) const
  {
    const double box = (at - from) * perUnit;
    return box >= double(side_) ? side_ - 1 : box > 0.0 ? static_cast<std::size_t>(box) : 0;
  }
  std::size_t boxOf(const Point& p) const
  {
    return along(ymin_, perY_, p.y) * side_ + along(xmin_, perX_, p.x);
  }

  std::vector<Index> boxes_;
  std::size_t side_ = 0;
  double xmin_ = 0.0, ymin_ = 0.0, perX_ = 0.0, perY_ = 0.0;
};

} // namespace ahd

#endif
