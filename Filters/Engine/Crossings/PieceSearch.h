// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PieceSearch_h
#define ahd_PieceSearch_h

#include "BoxTree.h"
#include "Pieces.h"

#include <cstddef>
#include <vector>

namespace ahd
{

/// Finds what crosses, round after round.
class PieceSearch
{
public:
  explicit PieceSearch(Ticker& ticker)
    : ticker_(ticker)
  {
  }

  /// Adds `more` to the pieces, in an order of its own, and finds all pairs that cross, each once, in
  /// no particular order. REQUIRES: the pieces are those that the calls before left, some of them
  /// dead by now, and those that are not dead do not cross each other. Returns false if the work is
  /// to be cancelled. Throws std::bad_alloc.
  ///
  /// Cost: mostly the new pieces and those near them. Where boxes tell too little apart, as among
  /// long segments side by side, all pieces are searched by strips (SplitFind.h).
  bool find(const Pieces& more, Pieces& pieces, std::vector<Crossing>& crossings);

private:
  bool findByStrips(const Pieces& pieces, std::vector<Crossing>& crossings);

  Ticker& ticker_;
  std::vector<BoxTree> trees_; ///< one for each call
};

} // namespace ahd

#endif
