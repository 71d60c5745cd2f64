// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PieceSearch_h
#define ahd_PieceSearch_h

#include "BoxTree.h"
#include "Hubs.h"
#include "Pieces.h"

#include <cstddef>
#include <vector>

namespace ahd
{

/// Pairs that cross.
struct FoundCrossings
{
  /// Each pair once, in no particular order; but of the pieces through a hub (Hubs.h) only as many
  /// pairs as name all of them, one pair of the first two positions among them.
  std::vector<Crossing> listed;
  std::size_t unlisted = 0; ///< so many more

  std::size_t count() const { return listed.size() + unlisted; }
};

/// Finds what crosses, round after round.
class PieceSearch
{
public:
  explicit PieceSearch(Ticker& ticker)
    : ticker_(ticker)
    , listed_(ticker)
  {
  }

  /// Adds `more` to the pieces, in an order of its own, and finds what crosses. @pre the
  /// pieces are those that the calls before left, some of them dead by now, and those that are not
  /// dead do not cross each other. Stops as soon as there are more than `most` pairs, and
  /// lists more. Returns false if cancelled. Throws std::bad_alloc.
  ///
  /// Cost: mostly the new pieces and those near them, and m log^2 m for m pieces through a hub.
  /// Where boxes tell too little apart, as among long segments side by side, all pieces are
  /// searched by strips (SplitFind.h).
  bool find(const Pieces& more, Pieces& pieces, std::size_t most, FoundCrossings& found);

private:
  bool findAll(const Pieces& more, Pieces& pieces, std::size_t most, FoundCrossings& found);
  BoxSearch::Outcome searchTrees(
    const Pieces& pieces, const BoxSearchLimits& limits, std::vector<Crossing>& crossings);
  bool findHubs(const Pieces& pieces, const std::vector<Crossing>& crossings, Hubs& hubs) const;
  bool findAmongParts(
    const std::vector<Hubs::Part>& parts, std::size_t most, std::vector<Crossing>& crossings);
  bool findByStrips(const Pieces& pieces, std::size_t most, Hubs& hubs, FoundCrossings& found);

  Ticker& ticker_;
  TakenMemory listed_;         ///< for the list
  std::vector<BoxTree> trees_; ///< one for each call
};

} // namespace ahd

#endif
