// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_RasterTask_h
#define ahd_RasterTask_h

#include "Methods.h"
#include "Values.h"

namespace ahd
{

/// Where the cells of a raster are.
struct RasterGrid
{
  const double* x; ///< of each column, ascending, between minus infinity and infinity
  const double* y; ///< of each row, likewise
  std::size_t columns;
  std::size_t rows;
  Point origin;
  Point perUnit; ///< columns and rows per unit of length, rounded
  double error;  ///< most that a crossing is wrong by
};

/// One task of a RasterScan: the cells of one triangle after the other.
class RasterTask
{
public:
  /// The most that the crossing of an edge and a row is wrong by, over the largest x of all, M.
  ///
  /// Proof. It is computed as from.x + (y - from.y) * slope, the slope being a quotient of two
  /// rounded differences. y lies between the ends of the edge, so the product is at most 2 M, and
  /// has five roundings: it is wrong by less than 5.01 u 2 M, and the sum by u M (1 + 11 u) more. A
  /// slope that underflows loses 2^-1075 times 2^301 at most. 11.1 u M in all; compared with it is
  /// a rounded difference. Where the slope overflows, the quotient is that of the heights, at most
  /// 1: the same five roundings, and the same loss if it underflows.
  static constexpr double kCrossingError = 12.0 * 0x1p-53;

  /// Borrows all.
  RasterTask(const SampledSurface& surface, const RasterGrid& grid, const SampledColumns& columns,
    unsigned char* mask);

  /// Writes the cells that the triangle owns. Returns false if cancelled.
  bool scan(std::size_t triangle, Ticker& ticker);

  /// Of the cells with a value.
  SampleReport report() const;

private:
  /// An edge, upwards.
  struct Edge
  {
    Point from, to;
    double slope; ///< x over y; may be infinite
    HalfEdge halfEdge;
  };
  /// The columns [first, last) of a row.
  struct Columns
  {
    std::size_t first, last;
  };

  static constexpr std::size_t kFew = 1024; ///< cells

  void load(std::size_t triangle);
  Edge edgeBetween(unsigned from, unsigned to) const;
  static double crossingAt(const Edge& edge, double y);
  std::size_t firstRow(double y) const;
  std::size_t columnNear(double x) const;
  int sideOf(const Edge& edge, const Point& place) const;
  std::size_t firstBeyond(const Edge& edge, std::size_t row, std::size_t guess, int side) const;
  Columns crossed(const Edge& edge, std::size_t row) const;

  bool scanCorner(const Edge& longEdge, double y, std::size_t& row, Ticker& ticker);
  bool scanRows(const Edge& longEdge, unsigned from, unsigned to, std::size_t& row, std::size_t end,
    Ticker& ticker);
  bool scanRowOfCorner(const Edge& longEdge, std::size_t row, Ticker& ticker);
  bool putCell(std::size_t column, std::size_t row, Ticker& ticker);
  bool putOnEdge(HalfEdge h, Columns columns, std::size_t row, Ticker& ticker);
  bool putInside(Columns columns, std::size_t row, Ticker& ticker);
  bool putAny(Columns columns, std::size_t row, Ticker& ticker);
  void putFast(Columns columns, std::size_t row);

  Point placeOf(std::size_t column, std::size_t row) const
  {
    return { grid_.x[column], grid_.y[row] };
  }
  std::size_t cellOf(std::size_t column, std::size_t row) const
  {
    return row * grid_.columns + column;
  }

  SampledSurface surface_;
  RasterGrid grid_;
  SpotOwner owner_;
  RimWeights rim_;
  ValueSink sink_;
  const SampledColumn* single_; ///< if there is one component alone, and no slopes
  unsigned char* mask_;
  SampleReport fast_; ///< of what the sink does not see

  // The triangle at work.
  HalfEdge halfEdge_ = 0; ///< its first
  Point corners_[3];
  unsigned low_ = 0, middle_ = 0, high_ = 0; ///< its corners by y
  bool isEasy_ = false;
  bool isFast_ = false; ///< and `values_` are all that there is, and finite
  double values_[3];    ///< of the single component, at the corners
};

} // namespace ahd

#endif
