// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Rounds_h
#define ahd_Rounds_h

#include "LivingSurface.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace ahd
{

/// Keeps points, round by round, until none is wrong by more than the bound.
///
/// A round keeps the worst point of every triangle whose error beats those of all triangles that
/// share a corner with it; of equal errors that of the lexicographically smaller point. The largest
/// error of all is among them, so rounds end. Only triangles at touched vertices are looked at
/// again: a vertex remembers the best of its triangles.
class Rounds
{
public:
  /// `limit`: of vertices; 0: none.
  Rounds(LivingSurface& surface, std::size_t limit, Ticker& ticker);

  /// Until all listed points are within the bound, or the limit is reached. Returns false if
  /// cancelled; throws std::bad_alloc. @pre all triangles are touched if the bound is another one
  ///
  /// @param units of the phase for this; they pass with the logarithm of the largest error
  bool run(double bound, std::size_t units);

  std::size_t count() const { return count_; }
  /// Did the limit end them?
  bool isLimited() const { return isLimited_; }
  /// How many points were kept when the largest error was least: keeping one may uncover larger
  /// ones around it.
  std::size_t best() const { return best_; }

private:
  using Slot = LivingSurface::Slot;
  using Vertex = LivingSurface::Vertex;

  bool isAbove(Slot s) const { return surface_.worst(s).error > bound_; }
  bool beats(Slot s, Slot t) const;
  bool isLocalMaximum(Slot s) const;
  bool refresh();
  void lookAt(Slot s);
  Slot bestAround(Vertex v) const;
  void select();
  std::size_t chosen() const;
  bool keepMaxima(std::size_t count);
  void remember();
  void report(std::size_t units);

  LivingSurface& surface_;
  const std::size_t limit_;
  Ticker& ticker_;
  double bound_ = 0.0;
  std::size_t count_ = 0;
  bool isLimited_ = false;
  std::size_t best_ = 0;
  double least_ = std::numeric_limits<double>::infinity(); ///< the largest error then
  double first_ = 0.0;                                     ///< largest error of this run,
  std::size_t passed_ = 0;                                 ///< and units of it that passed
  std::vector<Slot> bestAt_; ///< by vertex: the slot of the best triangle above the bound, or none
  std::vector<Vertex> touched_;
  std::vector<unsigned char> look_; ///< by vertex: which triangles are looked at
  std::vector<Slot> maxima_;        ///< local maxima, the largest error first
};

} // namespace ahd

#endif
