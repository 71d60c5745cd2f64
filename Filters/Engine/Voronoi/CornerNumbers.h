// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_CornerNumbers_h
#define ahd_CornerNumbers_h

#include "CellBorder.h"
#include "Voronoi.h"

#include <algorithm>
#include <vector>

namespace ahd
{

/// Numbers the corners by their first use, cell after cell, without going through the cells in
/// their order: these lie anywhere in memory, while vertices lie along the curve.
///
/// A centre is a corner of the cells of its triangle's vertices, and those of the triangles that it
/// stands for: the first of them is known at once. Each cell counts the corners that it is the
/// first to have, in its order; sums of these counts give the first number of each cell.
class CornerNumbers
{
public:
  CornerNumbers(const Diagram& diagram, const CellBorder& border)
    : diagram_(diagram)
    , border_(border)
  {
  }

  /// Finds the first cell of each centre. @pre the border has found the inside. Returns false
  /// if cancelled, as all below; throws std::bad_alloc.
  bool begin(const Buffer<Index>& cellOf, Ticker& ticker);

  /// All on the border are known. Throws std::bad_alloc.
  void beginBorder();
  /// If the corner is on the border: this cell has it. @pre beginBorder().
  void noteBorder(CornerId id, Index cell)
  {
    if (isOnBorder(id))
    {
      Index& first = borderFirst_[id - centres_];
      first = cell < first ? cell : first;
    }
  }

  /// Numbers a corner of the cell if that is the first to have it, after `count` that have numbers
  /// already, and returns how many there are then. @pre all on the border were noted.
  std::uint32_t count(Index cell, CornerId corner, std::uint32_t count)
  {
    const bool isNew = firstCell(corner) == cell && number(corner) == kNoCorner;
    if (isNew)
    {
      number(corner) = count;
    }
    return count + (isNew ? 1u : 0u);
  }

  /// The same for corners in a row that are all centres. Several cells may do so at the same time.
  std::uint32_t countCentres(
    Index cell, const CornerId* corners, std::size_t size, std::uint32_t count)
  {
    std::uint32_t ofOthers = 0;
    for (std::size_t i = 0; i != size; ++i)
    {
      // No branch, which would be unpredictable.
      std::uint32_t& its = first_[corners[i]] == cell ? number_[corners[i]] : ofOthers;
      const bool isNew = its == kNoCorner;
      its = isNew ? count : its;
      count += isNew ? 1u : 0u;
    }
    return count;
  }

  /// Adds the first number of the first cell, beginOf(cell), and writes to `places` the coordinates
  /// of each corner that a cell has.
  template <typename BeginOf>
  bool finish(Ticker& ticker, BeginOf beginOf, VoronoiCorner* places)
  {
    const auto put = [places](std::uint32_t number, const Point& at) {
      places[number] = { at.x, at.y, 0.0 };
    };
    const auto centres = [&](std::size_t a, std::size_t b)
    {
      for (std::size_t t = a; t != b; ++t)
      {
        prefetchForRead(&beginOf(first_[std::min(t + 2 * kAhead, b - 1)]));
        const std::size_t next = std::min(t + kAhead, b - 1);
        const std::uint32_t number = number_[next];
        prefetchForWrite(places + (number == kNoCorner ? 0 : number + beginOf(first_[next])));
        if (number_[t] != kNoCorner)
        {
          number_[t] += beginOf(first_[t]);
          put(number_[t], diagram_.centre(t));
        }
      }
    };
    const auto others = [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i != b; ++i)
      {
        if (borderNumber_[i] != kNoCorner)
        {
          borderNumber_[i] += beginOf(borderFirst_[i]);
          put(borderNumber_[i], border_.corner(static_cast<CornerId>(centres_ + i)));
        }
      }
    };
    return inShares(centres_, ticker, 8, 1 << 14, centres) &&
      inChunks(0, borderNumber_.size(), ticker, others);
  }

  /// @pre finish(). kNoCorner if no cell has it.
  std::uint32_t operator[](CornerId id) const
  {
    return isOnBorder(id) ? borderNumber_[id - centres_] : number_[id];
  }
  /// Of a triangle's centre.
  std::uint32_t ofCentre(std::size_t triangle) const { return number_[triangle]; }

private:
  static constexpr std::size_t kAhead = 32;

  bool joinFirst(Ticker& ticker);

  bool isOnBorder(CornerId id) const { return id >= centres_; }
  Index firstCell(CornerId id) const
  {
    return isOnBorder(id) ? borderFirst_[id - centres_] : first_[id];
  }
  std::uint32_t& number(CornerId id)
  {
    return isOnBorder(id) ? borderNumber_[id - centres_] : number_[id];
  }

  const Diagram& diagram_;
  const CellBorder& border_;
  std::size_t centres_ = 0;
  Buffer<Index> first_;          ///< of each triangle, the first cell that has its centre
  Buffer<std::uint32_t> number_; ///< of each triangle's centre; kNoCorner if no cell has it
  std::vector<Index> borderFirst_;
  std::vector<std::uint32_t> borderNumber_;
};

} // namespace ahd

#endif
