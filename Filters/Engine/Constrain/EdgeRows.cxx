// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeRows.h"

#include "../Predicates/Predicates.h"

namespace ahd
{

/// The row that it has become a part of; shortens the path to it.
std::uint32_t EdgeRows::rootOf(std::uint32_t row) const
{
  while (rows_[row].parent != row)
  {
    rows_[row].parent = rows_[rows_[row].parent].parent;
    row = rows_[row].parent;
  }
  return row;
}

Index EdgeRows::aheadInRow(Index from, Mesh::Halfedge edge, Index end) const
{
  const Index to = mesh_.destination(edge);
  const std::uint32_t* const found = rowOf_.find(from, to);
  if (found == nullptr)
  {
    return to;
  }
  const Row& row = rows_[rootOf(*found)];
  const bool isUp = isBefore(from, to);
  const Index last = isUp ? row.high : row.low;
  return isBefore(last, end) == isUp && last != end ? last : end;
}

/// The row reaches from u to v, at least.
void EdgeRows::reach(std::uint32_t row, Index u, Index v)
{
  Row& known = rows_[row];
  for (const Index w : { u, v })
  {
    known.low = isBefore(w, known.low) ? w : known.low;
    known.high = isBefore(known.high, w) ? w : known.high;
  }
}

/// One edge in kStride.
bool EdgeRows::addEdges(const WalkPiece* pieces, std::size_t count, std::uint32_t row)
{
  for (std::size_t k = 0; k < count; k += kStride)
  {
    const bool isNew = !isRow(pieces[k]);
    if ((isNew && rowOf_.add(pieces[k].from, pieces[k].to, row) == nullptr) || !ticker_.step())
    {
      return false;
    }
  }
  return true;
}

bool EdgeRows::rememberRow(const WalkPiece* begin, const WalkPiece* end, bool isLong)
{
  std::uint32_t row = kNoIndex;
  for (const WalkPiece* piece = begin; piece != end; ++piece)
  {
    if (isRow(*piece))
    {
      const std::uint32_t other = rootOf(*rowOf_.find(piece->from, mesh_.destination(piece->edge)));
      row = row == kNoIndex ? other : row;
      rows_[other].parent = row;
      reach(row, rows_[other].low, rows_[other].high);
    }
    if (!ticker_.step())
    {
      return false;
    }
  }
  if (row == kNoIndex && isLong)
  {
    if (rows_.empty() && !rowOf_.begin(0))
    {
      return false;
    }
    row = static_cast<std::uint32_t>(rows_.size());
    rows_.push_back({ begin->from, begin->from, row });
  }
  if (row != kNoIndex)
  {
    reach(row, begin->from, end[-1].to);
  }
  return !isLong || addEdges(begin, static_cast<std::size_t>(end - begin), row);
}

} // namespace ahd
