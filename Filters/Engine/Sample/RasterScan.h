// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_RasterScan_h
#define ahd_RasterScan_h

#include "RimTree.h"
#include "Values.h"

#include <vector>

namespace ahd
{

/// Linear values on a raster, triangle after triangle: each finds its cells row by row. The same
/// bytes as from cell to cell by a LinearMethod.
///
/// Where a row crosses an edge is computed in double precision; if the cells next to that place are
/// farther from it than it may be wrong, they are on the sides that they seem to be, else the exact
/// predicate tells. A cell on an edge or a vertex is written by the triangle that owns it
/// (SpotOwner), so by one thread.
class RasterScan
{
public:
  /// Borrows all. @pre triangles.
  RasterScan(const SampledSurface& surface, const RimTree& rim, const SampleRaster& raster,
    const SampledColumns& columns, unsigned char* mask)
    : surface_(surface)
    , rim_(rim)
    , raster_(raster)
    , columns_(columns)
    , mask_(mask)
  {
  }

  /// Does it pay, and are all numbers such that the bounds of errors hold? `bounds`: of the
  /// vertices.
  bool isApplicable(const Bounds& bounds);

  /// Writes all cells. Returns false if cancelled; throws std::bad_alloc.
  bool run(SampleReport& report, Ticker& ticker);

private:
  class RimTask;
  bool clear(Ticker& ticker);
  bool scanTriangles(SampleReport& report, Ticker& ticker);
  bool scanRim(SampleReport& report, Ticker& ticker);
  template <typename Work>
  bool inTasks(std::size_t tasks, SampleReport& report, Ticker& ticker, const Work& work);

  SampledSurface surface_;
  const RimTree& rim_;
  SampleRaster raster_;
  const SampledColumns& columns_;
  unsigned char* mask_;
  Buffer<double> x_;   ///< of each column, between infinities
  Buffer<double> y_;   ///< of each row, likewise
  double error_ = 0.0; ///< most that a crossing is wrong by
};

} // namespace ahd

#endif
