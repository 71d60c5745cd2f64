// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PaperOrder_h
#define ahd_PaperOrder_h

#include "Options.h"
#include "Points/Points.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace ahd
{
namespace test
{

// A literal and slow implementation of section 3 of Su et al. 2016: the oracle of the fast order.
// It shares with the engine only the quantisation of the coordinates to integers.

/// How the curve steps from one box to the next (the paper's Figure 7).
enum class Step
{
  None,
  LeftToRight,
  RightToLeft,
  BottomToTop,
  TopToBottom
};

enum class Turn
{
  WithoutChange,
  Clockwise90,
  Turn180,
  Counterclockwise90
};

/// A row of Table 1, rows 5 to 8 with the first column corrected.
struct GeneRow
{
  Step fromPrevious;
  Step toNext;
  Turn turn;
  bool reverse;
};

const std::vector<GeneRow>& geneTable();

using Column = std::uint32_t;
using Row = std::uint32_t;
using Curve = std::vector<std::pair<Column, Row>>;

/// The Hilbert curve of this order through 2^order x 2^order boxes, from bottom-left to
/// bottom-right (the paper's Figure 5).
Curve hilbertCurve(unsigned order);

/// The curve turned, then run through backwards if `reverse`.
Curve transformed(const Curve& curve, Turn turn, bool reverse);

/// The row of Table 1 for a box of a curve, by the boxes before and after it. @pre the curve
/// has two boxes or more.
const GeneRow& geneOfBox(const Curve& curve, std::size_t box);

/// An undivided box: (column, row) among the 2^levels x 2^levels boxes of the whole.
struct PaperBox
{
  Column column;
  Row row;
  unsigned levels;
  int divisions;          ///< that made it
  std::vector<Index> ids; ///< its points, control points left out
};

struct PaperOrder
{
  std::vector<PaperBox> boxes; ///< as visited, empty ones included
  std::vector<Index> sequence; ///< ids in the order of insertion
};

/// @pre distinct finite points.
PaperOrder paperOrder(const std::vector<Point>& points, const Options& options);

/// The canonical order of the distinct points, by the definition in Order/Rank.h: their smallest
/// ids. @pre finite points.
std::vector<Index> rankByDefinition(const std::vector<Point>& points);

} // namespace test
} // namespace ahd

#endif
