// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_CellBorder_h
#define ahd_CellBorder_h

#include "../Core/Loops.h"
#include "Diagram.h"

#include <cstddef>
#include <deque>
#include <unordered_map>
#include <vector>

namespace ahd
{

/// Number of a corner of cells: that of a triangle for its centre, the triangles and more for a
/// point of the border.
using CornerId = std::uint32_t;
constexpr CornerId kNoCorner = 0xFFFFFFFFu;

/// A stretch of the border, as each border numbers them counterclockwise; or none.
using Stretch = std::uint32_t;
constexpr Stretch kNoStretch = 0xFFFFFFFFu;

constexpr std::size_t kNoTriangle = std::size_t(-1); ///< beyond the hull

/// The part of an edge of the diagram inside the border: nothing, or from one corner to
/// another. The edge between the cells of p and q is followed counterclockwise around
/// p.
struct ClippedEdge
{
  CornerId from = kNoCorner;
  CornerId to = kNoCorner;
  Stretch entry = kNoStretch; ///< where it enters, or kNoStretch if it begins at a centre
  Stretch exit = kNoStretch;  ///< where it leaves, or kNoStretch if it ends at a centre

  bool isEmpty() const { return from == kNoCorner; }
};

inline ClippedEdge turned(const ClippedEdge& piece)
{
  return { piece.to, piece.from, piece.exit, piece.entry };
}

/// Where a cell follows the border: from where one edge leaves to where the next enters.
struct Gap
{
  Stretch exit;
  Stretch entry;
};

/// One more corner of a cell, unless it is the last one again.
inline void addTo(std::vector<CornerId>& cell, CornerId corner)
{
  if (cell.empty() || cell.back() != corner)
  {
    cell.push_back(corner);
  }
}

/// The convex border where cells are cut off. Each edge of the diagram is cut once, for both of its
/// cells, so these share the corners on the border too.
///
/// Inside, crossings of edges and corners of cells are decided for the exact diagram, by
/// exact signs. Only then is each corner rounded, and are centres that coincide by rounding
/// (Diagram::standIn) joined into one corner: cells keep their shape, whatever rounding does.
class CellBorder
{
public:
  explicit CellBorder(Diagram& diagram)
    : diagram_(diagram)
  {
  }
  virtual ~CellBorder() = default;
  CellBorder(const CellBorder&) = delete;
  CellBorder& operator=(const CellBorder&) = delete;

  /// Returns false if cancelled; throws std::bad_alloc, as everything here does.
  virtual bool build(Ticker& ticker) = 0;

  /// Is the centre of the triangle inside? For HullBorder also if it lies on the border. @pre
  /// build().
  bool isInside(std::size_t triangle) const { return places_[triangle] == kInside; }

  /// Bits of the sides of the border's bounds that the centre lies beyond, as far as they are
  /// noted.
  unsigned sidesBeyond(std::size_t triangle) const
  {
    return places_[triangle] & ~unsigned(kInside);
  }

  /// The edge that is dual to h, counterclockwise around the origin of h.
  ClippedEdge piece(HalfEdge h)
  {
    const HalfEdge twin = diagram_.twin(h);
    const bool isOwn = twin == kNoHalfEdge || h < twin;
    const HalfEdge own = isOwn ? h : twin;
    if (twin != kNoHalfEdge && isInside(h / 3) && isInside(twin / 3))
    {
      return { centre(twin / 3), centre(h / 3) };
    }
    const auto found = cut_.find(own);
    const ClippedEdge result = found != cut_.end() ? found->second : cut(own);
    if (found == cut_.end() && !result.isEmpty()) // most edges outside are quickly found to be
    {
      cut_.emplace(own, result);
    }
    return isOwn ? result : turned(result);
  }

  /// Adds the corners that the cell of `site` has in the gap, in counterclockwise direction.
  /// `isOpen`: there the cell has no end.
  virtual void follow(Index site, const Gap& gap, bool isOpen, std::vector<CornerId>& cell) = 0;

  /// Adds corners to a cell that has fewer than three, as the rest of it is smaller than the
  /// coordinates resolve: its vertex stands for those that are missing.
  virtual void fill(Index site, std::vector<CornerId>& cell)
  {
    fillWith(diagram_.point(site), cell);
  }

  Point corner(CornerId id) const
  {
    const std::size_t triangles = diagram_.triangles();
    return id < triangles ? diagram_.centre(id) : points_[id - triangles];
  }
  std::size_t corners() const { return diagram_.triangles() + points_.size(); }

  /// One more corner.
  CornerId add(const Point& p)
  {
    points_.push_back(p);
    return static_cast<CornerId>(diagram_.triangles() + points_.size() - 1);
  }

  /// All cells are known: only corner() will be called.
  void forget()
  {
    places_.reset();
    std::unordered_map<HalfEdge, ClippedEdge>().swap(cut_);
    forgetOwn();
  }

protected:
  virtual void forgetOwn() {}

  static constexpr std::uint8_t kInside = 1;

  /// Notes for each triangle placeOf(triangle): kInside, or bits above it. Returns false if
  /// cancelled.
  template <typename PlaceOf>
  bool notePlaces(Ticker& ticker, PlaceOf placeOf)
  {
    places_.allocate(diagram_.triangles());
    return inShares(places_.size(), ticker, 8, 1 << 14,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t t = a; t != b; ++t)
        {
          places_[t] = placeOf(t);
        }
      });
  }
  void noteOutside(std::size_t triangle) { places_[triangle] = 0; }

  void fillWith(const Point& p, std::vector<CornerId>& cell)
  {
    while (cell.size() < 3)
    {
      cell.push_back(add(p));
    }
  }

  /// Moves the centres that stand for others inside into the bounds, which are the border's.
  /// Returns false if cancelled.
  bool settleInside(const Bounds& bounds, Ticker& ticker)
  {
    const auto settle = [&](std::size_t a, std::size_t b)
    {
      for (std::size_t t = a; t != b; ++t)
      {
        if (isInside(t) && diagram_.standIn(t) != t)
        {
          diagram_.settle(diagram_.standIn(t), bounds);
        }
      }
    };
    return !diagram_.hasJoined() || inChunks(0, places_.size(), ticker, settle);
  }

  /// The part inside of the dual of h, which is not wholly inside. @pre h is the smaller of
  /// the two half-edges.
  virtual ClippedEdge cut(HalfEdge h) = 0;

  CornerId centre(std::size_t triangle) const
  {
    return static_cast<CornerId>(diagram_.standIn(triangle));
  }

  Diagram& diagram_;
  std::deque<Point> points_; ///< never takes twice its size, unlike a growing vector

private:
  Buffer<std::uint8_t> places_; ///< of each triangle's centre
  std::unordered_map<HalfEdge, ClippedEdge> cut_;
};

} // namespace ahd

#endif
