// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_HilbertCurve_h
#define ahd_HilbertCurve_h

#include <array>
#include <cstddef>
#include <cstdint>

namespace ahd
{

// The paper's gene rule as a state machine. Su et al. 2016, section 3.2, Table 1 (rows 5 to 8
// corrected: the words "top to bottom" and "bottom to top" are exchanged in their first column).

/// Where a neighbour on the curve lies, seen from a box.
enum class Side
{
  None, ///< there is none: the box is the first (or last) of its grid
  Left,
  Right,
  Below,
  Above
};

/// A gene: the isometry of the square that turns the curve in a divided box. The four that occur
/// are their own inverses, and doing one after the other is the exclusive or of their bits.
enum Gene : unsigned
{
  kAsIs = 0,       ///< bottom-left -> bottom-right; the paper's "without change"
  kTransposed = 1, ///< bottom-left -> top-left; "rotate 90 degrees clockwise, reverse"
  kTurned = 2,     ///< top-right -> top-left; "rotate 180 degrees"
  kTurnedTransposed =
    3 ///< top-right -> bottom-right; "rotate 90 degrees counterclockwise, reverse"
};

constexpr Side opposite(Side s)
{
  return s == Side::Left ? Side::Right
    : s == Side::Right   ? Side::Left
    : s == Side::Below   ? Side::Above
    : s == Side::Above   ? Side::Below
                         : Side::None;
}

/// The gene of a box from where the curve comes and where it goes: it enters at the bottom-left
/// corner if the previous box is left or below, else at the top-right; it leaves at the
/// bottom-right corner if the next box is right or below, else at the top-left; where there is no
/// previous or no next box it goes straight. @pre one of the two is not None.
constexpr Gene geneOf(Side previous, Side next)
{
  const Side from = previous == Side::None ? opposite(next) : previous;
  const Side to = next == Side::None ? opposite(previous) : next;
  const bool fromBottomLeft = from == Side::Left || from == Side::Below;
  const bool toBottomRight = to == Side::Right || to == Side::Below;
  return fromBottomLeft ? (toBottomRight ? kAsIs : kTransposed)
                        : (toBottomRight ? kTurnedTransposed : kTurned);
}

/// Place 0 to 3 on the curve of the quarter (x, y), x, y in {0, 1}, of a box with this gene. The
/// unturned cell is bottom-left, top-left, top-right, bottom-right.
constexpr unsigned digitOf(unsigned gene, unsigned x, unsigned y)
{
  const unsigned flip = gene >> 1;
  const unsigned u = (gene & kTransposed ? y : x) ^ flip;
  const unsigned v = (gene & kTransposed ? x : y) ^ flip;
  return 2 * u + (u ^ v);
}

/// The gene of that quarter: by the rule, its neighbours being the quarters before and after it.
constexpr unsigned geneOfQuarter(unsigned gene, unsigned digit)
{
  constexpr Gene kQuarter[4] = { geneOf(Side::None, Side::Above), geneOf(Side::Below, Side::Right),
    geneOf(Side::Left, Side::Below), geneOf(Side::Above, Side::None) };
  return gene ^ kQuarter[digit];
}

/// Four levels of the machine per step. Entry [gene << 8 | x << 4 | y], x and y of four bits:
/// the four digits in the low 8 bits, the gene below in bits 8 and 9.
struct HilbertTable
{
  std::array<std::uint16_t, 1024> entry{};

  constexpr HilbertTable()
  {
    for (unsigned i = 0; i < 1024; ++i)
    {
      unsigned gene = i >> 8;
      unsigned digits = 0;
      for (unsigned level = 4; level-- > 0;)
      {
        const unsigned digit = digitOf(gene, (i >> (4 + level)) & 1u, (i >> level) & 1u);
        digits = digits << 2 | digit;
        gene = geneOfQuarter(gene, digit);
      }
      entry[i] = static_cast<std::uint16_t>(gene << 8 | digits);
    }
  }
};

inline constexpr HilbertTable kHilbertTable{};

/// Place of the box (column, row) of the finest grid on the Hilbert curve of 32 levels. The most
/// significant pair of bits is the coarsest level, so boxes of r levels share their top 2 r bits.
inline std::uint64_t hilbertKey(std::uint32_t column, std::uint32_t row)
{
  std::uint64_t key = 0;
  std::uint32_t gene = 0;
  for (int shift = 28; shift >= 0; shift -= 4)
  {
    const std::uint32_t quarters = (column >> shift & 15u) << 4 | (row >> shift & 15u);
    const std::uint32_t entry = kHilbertTable.entry[gene | quarters];
    key = key << 8 | (entry & 0xFFu);
    gene = entry & 0x300u;
  }
  return key;
}

struct GridPlace
{
  std::uint32_t column;
  std::uint32_t row;
};

/// The inverse of hilbertKey.
inline GridPlace placeOfKey(std::uint64_t key)
{
  GridPlace place{ 0, 0 };
  unsigned gene = 0;
  for (int shift = 62; shift >= 0; shift -= 2)
  {
    const unsigned digit = static_cast<unsigned>(key >> shift) & 3u;
    const unsigned u = (digit >> 1) ^ (gene >> 1);
    const unsigned v = (digit >> 1) ^ (digit & 1u) ^ (gene >> 1);
    place.column = place.column << 1 | (gene & kTransposed ? v : u);
    place.row = place.row << 1 | (gene & kTransposed ? u : v);
    gene = geneOfQuarter(gene, digit);
  }
  return place;
}

} // namespace ahd

#endif
