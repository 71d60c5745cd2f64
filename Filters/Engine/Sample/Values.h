// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Values_h
#define ahd_Values_h

#include "../Core/Chunks.h"
#include "../Triangulation/State.h"
#include "Sample.h"
#include "Spots.h"
#include "Weights.h"

#include <vector>

namespace ahd
{

/// An array to interpolate, as it is read: by vertex, through ids or gathered before.
struct SampledColumn
{
  double at(Index vertex, std::size_t component) const
  {
    return values[std::size_t(ids ? ids[vertex] : vertex) * components + component];
  }

  const double* values;
  const Index* ids; ///< of the vertices; null if the values come by vertices
  std::size_t components;
  double* out;
  double* gradients;
};

/// The arrays of one call of Sampler::values().
class SampledColumns
{
public:
  /// Gathers the values by vertices where so many places make it worth its while. Returns false if
  /// cancelled; throws std::bad_alloc.
  bool build(const TriangulationAccess::State* state, const SampleArray* arrays, std::size_t count,
    std::size_t places, Ticker& ticker);

  const SampledColumn* begin() const { return columns_.data(); }
  const SampledColumn* end() const { return columns_.data() + columns_.size(); }

private:
  std::vector<SampledColumn> columns_;
  std::vector<Buffer<double>> gathered_;
};

/// Writes values, and counts.
class ValueSink
{
public:
  /// Borrows all. `leavesOut`: a NaN is left out if there are other values.
  ValueSink(const SampledColumns& columns, const SampledSurface& surface, unsigned char* mask,
    bool leavesOut)
    : columns_(&columns)
    , surface_(surface)
    , mask_(mask)
    , leavesOut_(leavesOut)
  {
  }

  /// Returns false if cancelled.
  bool put(std::size_t place, const Weights& weights, Ticker& ticker);
  /// There is no value.
  void putNone(std::size_t place, bool isFinite);

  const SampleReport& report() const { return report_; }

private:
  bool addUp(const SampledColumn& column, std::size_t component, const Weights& weights,
    Ticker& ticker, double& sum) const;
  bool sumOfOthers(const SampledColumn& column, std::size_t component, const Weights& weights,
    Ticker& ticker, double& sum) const;
  Point slopeOf(const SampledColumn& column, std::size_t component, const Weights& weights) const;

  const SampledColumns* columns_;
  SampledSurface surface_;
  unsigned char* mask_;
  bool leavesOut_;
  SampleReport report_;
};

/// Notes how many weights there are; the offset behind that of each place.
class CountSink
{
public:
  explicit CountSink(std::uint64_t* offsets)
    : counts_(offsets + 1)
  {
  }

  bool put(std::size_t place, const Weights& weights, Ticker& ticker)
  {
    counts_[place] = weights.count;
    ++report_.valued;
    return ticker.step();
  }
  void putNone(std::size_t place, bool isFinite)
  {
    counts_[place] = 0;
    ++(isFinite ? report_.outside : report_.notFinite);
  }
  const SampleReport& report() const { return report_; }

private:
  std::uint64_t* counts_;
  SampleReport report_;
};

/// Writes weights where they belong.
class WeightSink
{
public:
  /// `ids`: of the vertices.
  WeightSink(SampleWeights& out, const Index* ids)
    : out_(&out)
    , ids_(ids)
  {
  }

  bool put(std::size_t place, const Weights& weights, Ticker& ticker)
  {
    const std::uint64_t begin = out_->offsets[place];
    const auto write = [&](std::size_t a, std::size_t b)
    {
      for (std::size_t k = a; k != b; ++k)
      {
        out_->points[begin + k] = static_cast<std::int32_t>(ids_[weights.vertices[k]]);
        out_->weights[begin + k] = weights.weights[k];
      }
    };
    return inChunks(0, weights.count, ticker, write);
  }
  void putNone(std::size_t, bool) {}
  SampleReport report() const { return {}; }

private:
  SampleWeights* out_;
  const Index* ids_;
};

} // namespace ahd

#endif
