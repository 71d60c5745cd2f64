// SPDX-License-Identifier: BSD-3-Clause
#include "Sample.h"

#include "../Core/Border.h"
#include "../Core/Loops.h"
#include "../Triangulation/State.h"
#include "Methods.h"
#include "NaturalWeights.h"
#include "RasterScan.h"
#include "RimTree.h"
#include "Values.h"
#include "Visits.h"

#include <utility>

namespace ahd
{

struct Sampler::State
{
  SampleMethod method = SampleMethod::Linear;
  const TriangulationAccess::State* made = nullptr; ///< null if it is that of no points
  SampledSurface surface{ nullptr, nullptr, nullptr };
  VertexLine line; ///< if there are no triangles
  VertexTree tree; ///< for Nearest
  RimTree edges;   ///< for Nearest the walls, else the rim

  bool hasTriangles() const { return made && made->allTriangles != 0; }
  Bounds bounds() const { return made ? made->ranked.bounds : Bounds(); }

  /// Finds the weights at all places, hands them to copies of the sink and adds up its reports.
  /// Returns false if cancelled; throws std::bad_alloc.
  template <typename Sink>
  bool visitAll(
    const SamplePlaces& places, const Sink& sink, SampleReport& report, Ticker& ticker) const
  {
    const auto run = [&](const auto& byMethod)
    { return Visits(places, byMethod, sink, report).run(bounds(), ticker); };
    if (method == SampleMethod::Nearest ? tree.empty() : !made)
    {
      return run(NoMethod());
    }
    if (method == SampleMethod::Nearest)
    {
      return run(NearestMethod(tree, edges));
    }
    if (!hasTriangles())
    {
      return run(LineMethod(line, edges));
    }
    return method == SampleMethod::Linear
      ? run(LinearMethod(surface, edges))
      : run(NaturalMethod(surface, edges, method == SampleMethod::Laplace));
  }
};

Sampler::Sampler() = default;
Sampler::~Sampler() = default;
Sampler::Sampler(Sampler&&) noexcept = default;
Sampler& Sampler::operator=(Sampler&&) noexcept = default;

Status Sampler::prepare(
  Triangulation& surface, const unsigned char* kept, SampleMethod method, const Context& context)
{
  state_.reset();
  Status status = surface.makeNeighbors(context);
  if (status != Status::Ok)
  {
    return status;
  }
  status = unlessCancelled(
    [&]
    {
      auto state = std::make_unique<State>();
      state->method = method;
      state->made = TriangulationAccess::stateOf(std::as_const(surface));
      bool done = true;
      if (state->made)
      {
        const TriangulationAccess::State& made = *state->made;
        state->surface = { &made.tables, made.ranked.xy.data(), kept };
        Ticker ticker(context.progress, Phase::Outputs, made.ranked.count, context.executor);
        const bool isNearest = method == SampleMethod::Nearest;
        done = (isNearest                  ? state->tree.build(made, ticker)
                   : state->hasTriangles() ? ticker.ask()
                                           : state->line.build(made, ticker)) &&
          state->edges.build(
            state->surface, state->line, isNearest ? RimTree::Walls : RimTree::Rim, ticker);
      }
      state_ = std::move(state);
      return done;
    });
  if (status != Status::Ok)
  {
    state_.reset();
  }
  return status;
}

bool Sampler::isNearest() const
{
  return state_ && state_->method == SampleMethod::Nearest;
}

/// work(state, columns, sink, ticker) for these arrays.
template <typename Visit>
Status Sampler::visit(const SamplePlaces& places, const SampleArray* arrays, std::size_t count,
  unsigned char* mask, const Context& context, const Visit& work) const
{
  return unlessCancelled(
    [&]
    {
      const State none;
      const State& state = state_ ? *state_ : none;
      Ticker ticker(context.progress, Phase::Outputs, places.count(), context.executor);
      SampledColumns columns;
      const bool leavesOut = state.method == SampleMethod::NaturalNeighbor ||
        state.method == SampleMethod::Laplace;
      return ticker.ask() && columns.build(state.made, arrays, count, places.count(), ticker) &&
        work(state, columns, ValueSink(columns, state.surface, mask, leavesOut), ticker) &&
        ticker.ask();
    });
}

Status Sampler::values(const SamplePlaces& places, const SampleArray* arrays, std::size_t count,
  unsigned char* mask, SampleReport& report, const Context& context) const
{
  report = SampleReport();
  return visit(places, arrays, count, mask, context,
    [&](const State& state, const SampledColumns& columns, const ValueSink& sink, Ticker& ticker)
    {
      if (places.isRaster() && state.method == SampleMethod::Linear && state.hasTriangles())
      {
        RasterScan scan(state.surface, state.edges, places.raster(), columns, mask);
        if (scan.isApplicable(state.bounds()))
        {
          return scan.run(report, ticker);
        }
      }
      return state.visitAll(places, sink, report, ticker);
    });
}

Status Sampler::valuesAtRim(const SamplePlaces& places, const SampleArray* arrays,
  std::size_t count, SampleReport& report, const Context& context) const
{
  report = SampleReport();
  return visit(places, arrays, count, nullptr, context,
    [&](const State& state, const SampledColumns&, const ValueSink& sink, Ticker& ticker)
    {
      const auto run = [&](const auto& method)
      { return Visits(places, method, sink, report).run(state.bounds(), ticker); };
      return state.made ? run(BoundaryMethod(state.surface, state.line, state.edges))
                        : run(NoMethod());
    });
}

namespace
{

/// From how many weights each place has to where they begin.
bool sumUp(SampleWeights& out, std::size_t places, Ticker& ticker)
{
  std::uint64_t sum = 0;
  const auto add = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      out.offsets[k] = sum += out.offsets[k];
    }
  };
  out.offsets[0] = 0;
  if (!inChunks(0, places + 1, ticker, add))
  {
    return false;
  }
  out.points.allocate(sum);
  out.weights.allocate(sum);
  return true;
}

} // namespace

Status Sampler::weights(const SamplePlaces& places, SampleWeights& out, SampleReport& report,
  const Context& context) const
{
  report = SampleReport();
  const Status status = unlessCancelled(
    [&]
    {
      const State none;
      const State& state = state_ ? *state_ : none;
      const std::size_t all = places.count();
      Ticker ticker(context.progress, Phase::Outputs, 2 * all, context.executor);
      out.offsets.allocate(all + 1);
      SampleReport again;
      const Index* const ids = state.made ? state.made->ranked.id.data() : nullptr;
      return ticker.ask() &&
        state.visitAll(places, CountSink(out.offsets.data()), report, ticker) &&
        sumUp(out, all, ticker) && state.visitAll(places, WeightSink(out, ids), again, ticker) &&
        ticker.ask();
    });
  if (status != Status::Ok)
  {
    out = SampleWeights();
  }
  return status;
}

std::size_t sampleMemoryEstimate(
  std::size_t pointCount, const SamplePlaces& places, std::size_t components)
{
  // Per component: what its array is read by. Per point: its values; the list of vertices (4), a
  // node for eight of them (32 / 7), and while the list is made a mark (1) and a list more (4), or
  // later at most three edges of rim or walls (4), and a node for 16 of them (16 / 7). Per
  // place that is not on a raster: key and number, twice, of a block of places; for a raster
  // nothing but where its columns and rows are.
  constexpr std::size_t kPerPoint = 28, kPerPlace = 32, kPlacesOfBlock = std::size_t(1) << 22;
  const std::size_t ofPlaces = places.isRaster()
    ? (places.raster().columns + places.raster().rows) * sizeof(double)
    : std::min(places.count(), kPlacesOfBlock) * kPerPlace;
  constexpr std::size_t kPerComponent = sizeof(SampledColumn) + sizeof(Buffer<double>);
  return components * kPerComponent + pointCount * (kPerPoint + components * sizeof(double)) +
    ofPlaces + 16384;
}

} // namespace ahd
