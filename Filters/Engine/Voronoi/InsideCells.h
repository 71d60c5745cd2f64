// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_InsideCells_h
#define ahd_InsideCells_h

#include "../Core/Buffer.h"
#include "CellBorder.h"

#include <deque>

namespace ahd
{

/// The corners of the cells of some vertices in a row, as far as these do not touch the border: as
/// they are found by one thread, one cell after the other.
class InsideCells
{
public:
  InsideCells(const Diagram& diagram, const CellBorder& border)
    : diagram_(diagram)
    , border_(border)
  {
  }

  /// Makes room for the cells of so many vertices; it grows if needed. Throws std::bad_alloc, as
  /// does find().
  void reserve(std::size_t vertices) { corners_.allocate(vertices * kUsual / 4 + 64); }

  /// Finds the corners of one more cell: none if it is certainly outside. Where it touches the
  /// border or has too few, the vertex goes to others(). Returns false if cancelled.
  bool find(Index vertex, Ticker& ticker);

  /// Call when all are found: returns memory if most is not needed. Throws std::bad_alloc.
  void fit()
  {
    if (2 * end_ < corners_.size())
    {
      resize(end_);
    }
  }

  /// The cell found last.
  const CornerId* corners() const { return corners_.data() + begin_; }
  std::size_t size() const { return end_ - begin_; }

  /// All that were found, one after the other; and the vertices whose cells were not.
  const CornerId* all() const { return corners_.data(); }
  const std::deque<Index>& others() const { return others_; }

private:
  static constexpr std::size_t kUsual = 25; ///< corners of four cells: on average there are fewer

  void push(std::size_t corner)
  {
    if (end_ == corners_.size())
    {
      resize(end_ + end_ / 4 + 64);
    }
    corners_[end_++] = static_cast<CornerId>(corner);
  }
  void resize(std::size_t room);
  bool turn(Index vertex, Ticker& ticker, bool& isInside);
  bool isBeyond(Index vertex) const;

  const Diagram& diagram_;
  const CellBorder& border_;
  Buffer<CornerId> corners_;
  std::size_t begin_ = 0, end_ = 0;
  std::deque<Index> others_;
};

} // namespace ahd

#endif
