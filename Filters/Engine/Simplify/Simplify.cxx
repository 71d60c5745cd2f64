// SPDX-License-Identifier: BSD-3-Clause
#include "Simplify.h"

#include "../Core/Border.h"
#include "../Core/Loops.h"
#include "Rounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ahd
{
namespace
{

/// Rounds begin with every 16th point, where there are many: most points are then moved a few times
/// only. They end at four times the bound: only all points have the best for the rest.
constexpr Index kStep = 16;
constexpr double kCoarse = 4.0;
constexpr Index kFewPoints = 1 << 12;

/// One call of simplify().
class Simplification
{
public:
  Simplification(const SimplifyRequest& request, const Context& context, SimplifyResult& out)
    : request_(request)
    , context_(context)
    , out_(out)
  {
  }

  Status all();

private:
  bool choose(Ticker& ticker);
  bool keepEnough(LivingSurface& surface, Ticker& ticker);
  bool keepMoreAtCrossings(LivingSurface& surface, Rounds& rounds);
  bool keepFewer(LivingSurface& surface, Ticker& ticker);
  bool findLargest(LivingSurface& surface, Ticker& ticker);
  bool write(const LivingSurface* surface, Ticker& ticker);

  const SimplifyRequest& request_;
  const Context& context_;
  SimplifyResult& out_;
  Candidates candidates_;
  double bound_ = 0.0; ///< scaled, as the values are
};

Status Simplification::all()
{
  if (const Status read = candidates_.read(request_, context_); read != Status::Ok)
  {
    return read;
  }
  constexpr std::size_t kUnits = 1000;
  Ticker ticker(context_.progress, Phase::Insert, kUnits, context_.executor);
  return choose(ticker) ? Status::Ok : Status::Cancelled;
}

bool Simplification::choose(Ticker& ticker)
{
  bound_ = std::min(
    request_.maximumError * candidates_.scale(), std::numeric_limits<double>::max());
  if (candidates_.staying().empty())
  {
    return write(nullptr, ticker);
  }
  LivingSurface surface(candidates_, bound_, ticker);
  return surface.begin() && keepEnough(surface, ticker) &&
    (!request_.secondPass || keepFewer(surface, ticker)) && findLargest(surface, ticker) &&
    write(&surface, ticker);
}

bool Simplification::keepEnough(LivingSurface& surface, Ticker& ticker)
{
  const std::size_t limit = request_.maximumNumberOfVertices;
  const bool samples = limit == 0 && candidates_.count() >= kFewPoints;
  Rounds rounds(surface, limit, ticker);
  bool goesOn = surface.list(samples ? kStep : 1, true) &&
    rounds.run(samples ? kCoarse * bound_ : bound_, 500);
  if (goesOn && samples)
  {
    surface.touchAll();
    goesOn = surface.list(kStep, false) && rounds.run(bound_, 300);
  }
  if (goesOn && !rounds.isLimited())
  {
    surface.measureWide(bound_);
    goesOn = surface.settle() && rounds.run(bound_, 100) && keepMoreAtCrossings(surface, rounds);
  }
  if (goesOn && rounds.isLimited())
  {
    goesOn = surface.goBackTo(rounds.best()) && surface.list(1, true);
  }
  out_.isWithinBound = !rounds.isLimited();
  out_.rounds = rounds.count();
  return goesOn;
}

/// Where segments cross at a point that was kept on the way, constrain() takes what was left out:
/// then the surface is another one, and measured again.
bool Simplification::keepMoreAtCrossings(LivingSurface& surface, Rounds& rounds)
{
  std::vector<std::size_t> before;
  while (!surface.crossing().empty() && surface.crossing() != before && !rounds.isLimited())
  {
    before = surface.crossing();
    if (!surface.goBackTo(surface.kept()) || !surface.list(1, true) || !rounds.run(bound_, 0))
    {
      return false;
    }
  }
  return true;
}

bool Simplification::keepFewer(LivingSurface& surface, Ticker& ticker)
{
  if (!out_.isWithinBound && !findLargest(surface, ticker))
  {
    return false;
  }
  const double bound = out_.isWithinBound ? bound_ : out_.largestError;
  surface.measureWide(bound);
  return !std::isfinite(bound) || surface.dropWhatMayGo();
}

/// Scaled, as it stays until write().
bool Simplification::findLargest(LivingSurface& surface, Ticker& ticker)
{
  surface.clearTouched();
  const double bound = out_.isWithinBound ? bound_ : std::max(bound_, out_.largestError);
  surface.measureWide(bound);
  out_.measuredWithin = bound / candidates_.scale();
  if (!surface.settle())
  {
    return false;
  }
  out_.largestError = 0.0;
  return inSteps(0, surface.mesh().end() / Mesh::kSlotSize, ticker,
    [&](std::size_t k)
    {
      const LivingSurface::Worst& worst = surface.worst(Mesh::slotOfTriangle(k));
      out_.largestError = std::max(out_.largestError, worst.rank == kNoIndex ? 0.0 : worst.error);
    });
}

/// `surface`: none if there is no triangle.
bool Simplification::write(const LivingSurface* surface, Ticker& ticker)
{
  const std::size_t n = request_.points.count;
  out_.largestError /= candidates_.scale();
  out_.lots.allocate(n);
  out_.kept = surface ? surface->kept() : candidates_.count();
  out_.withinError = candidates_.count() - out_.kept;
  out_.leftOut = out_.withinError;
  const bool goesOn = inSteps(0, n, ticker,
    [&](std::size_t i)
    { out_.lots[i] = request_.points.skipped(i) ? PointLot::Skipped : PointLot::Kept; });
  if (!goesOn || !surface)
  {
    return goesOn;
  }
  const bool isWritten = inSteps(0, candidates_.count(), ticker,
    [&](std::size_t rank)
    {
      if (!surface->isKept(static_cast<Index>(rank)))
      {
        out_.lots[candidates_.id(static_cast<Index>(rank))] = PointLot::WithinError;
      }
    });
  return isWritten &&
    inSteps(0, candidates_.duplicates().size(), ticker,
      [&](std::size_t k)
      {
        const Duplicate& duplicate = candidates_.duplicates()[k];
        out_.lots[duplicate.id] = out_.lots[duplicate.keptId];
        out_.leftOut += std::size_t(out_.lots[duplicate.id] == PointLot::WithinError);
      });
}

} // namespace

bool isErrorBound(double maximumError)
{
  return maximumError >= 0.0 && std::isfinite(maximumError);
}

Status simplify(const SimplifyRequest& request, const Context& context, SimplifyResult& out)
{
  return withoutThrowing(
    [&]
    {
      out = SimplifyResult();
      return Simplification(request, context, out).all();
    });
}

std::size_t simplifyMemoryEstimate(const SimplifyRequest& request)
{
  const std::size_t n = request.points.count;
  const bool needsRanks = request.constraints.chains > 0 || request.mustStay;
  const std::size_t perPoint = std::max(Candidates::kBytesToRead,
    Candidates::kBytes + (request.weights.isGiven() ? 8 : 0) + (needsRanks ? 4 : 0) +
      LivingSurface::kBytes + 1);
  return n * perPoint + (std::size_t(1) << 16);
}

} // namespace ahd
