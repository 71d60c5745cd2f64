// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SpacePoints_h
#define ahd_SpacePoints_h

#include "../Surface/Means.h"
#include "Run.h"

#include <functional>
#include <utility>
#include <vector>

namespace ahd
{

/// The output points in space, added ones included, coinciding points at their mean if
/// requested.
///
/// Without added points and means they are the input's own, read in place; without added
/// points a copy of the same type; else doubles. Interpolated points follow the others:
/// source points laid on the surface and crossings, in PlaneKind::Xy in z only.
class SpacePoints
{
public:
  /// Gives memory for so many numbers.
  template <typename Number>
  using Lend = std::function<Number*(std::size_t count)>;

  /// Copies of either type lie in the lent memory, if not null; else in memory of its own.
  explicit SpacePoints(Lend<double> doubles = {}, Lend<float> floats = {})
    : doubles_{ std::move(doubles), nullptr, {} }
    , floats_{ std::move(floats), nullptr, {} }
  {
  }
  SpacePoints(const SpacePoints&) = delete;
  SpacePoints& operator=(const SpacePoints&) = delete;

  /// `input` and `source`: the prepared ones. Returns Ok, Cancelled or OutOfMemory; unless Ok,
  /// this must not be used.
  Status make(const PointView& input, const PointView& source, const PreparedInput& points,
    const Context& context);
  /// Moves coinciding points to their mean. Makes the tables that it needs.
  Status showMeans(RunResult& made, const Context& context);

  const PointView& view() const { return view_; }

  /// The same points as doubles, with unrounded means. `xyz`:
  /// the output of view().
  void writeMeans(double* xyz) const;

private:
  template <typename Number>
  struct Room
  {
    Lend<Number> lend;
    Number* numbers;
    std::vector<Number> own;

    Number* take(std::size_t count)
    {
      own.resize(lend ? 0 : count);
      return numbers = lend ? lend(count) : own.data();
    }
  };

  template <typename Number>
  bool copy(Room<Number>& room, const Context& context);

  PointView view_;
  bool isCopy_ = false;
  Room<double> doubles_;
  Room<float> floats_;
  std::vector<Mean> rounded_; ///< means, if floats_ has them
};

/// Replaces `columns` values of points between others by linear interpolation.
void interpolateAtSurface(const PreparedInput& points, double* values, std::size_t columns);
void interpolateAtCrossings(
  const PreparedInput& points, double* values, std::size_t columns, std::size_t firstColumn);

} // namespace ahd

#endif
