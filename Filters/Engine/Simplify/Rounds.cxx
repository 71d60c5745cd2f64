// SPDX-License-Identifier: BSD-3-Clause
#include "Rounds.h"

#include <algorithm>
#include <cmath>

namespace ahd
{
namespace
{

/// With a limit of vertices a round takes maxima of at least this part of the largest, so that what
/// is left at the limit is about as wrong everywhere.
constexpr double kLeastOfLargest = 0.75;

/// Where the bound is 0, progress is measured to this part of the first error.
constexpr double kSmall = 1e-6;

/// About the binary logarithm, growing with x > 0.
double roughLog2(double x)
{
  int exponent = 0;
  return 2.0 * std::frexp(x, &exponent) + exponent;
}

/// Which triangles of a vertex are looked at.
enum Look : unsigned char
{
  kNotYet,
  kAtTouched,
  kAtAll
};

} // namespace

Rounds::Rounds(LivingSurface& surface, std::size_t limit, Ticker& ticker)
  : surface_(surface)
  , limit_(limit)
  , ticker_(ticker)
{
}

/// Is the worst point of s before that of t?
bool Rounds::beats(Slot s, Slot t) const
{
  const LivingSurface::Worst &a = surface_.worst(s), &b = surface_.worst(t);
  const Candidates& points = surface_.candidates();
  return a.error != b.error ? a.error > b.error
                            : lexicographicallyLess(points.place(a.rank), points.place(b.rank));
}

bool Rounds::isLocalMaximum(Slot s) const
{
  const LivingMesh& mesh = surface_.mesh();
  return bestAt_[mesh.apex(s)] == s && bestAt_[mesh.apex(s + 1)] == s &&
    bestAt_[mesh.apex(s + 2)] == s;
}

Rounds::Slot Rounds::bestAround(Vertex v) const
{
  const LivingMesh& mesh = surface_.mesh();
  Slot best = kNoIndex;
  const LivingMesh::Halfedge first = mesh.leaving(v);
  LivingMesh::Halfedge h = first;
  do
  {
    const Slot s = Mesh::slotOf(h);
    best = isAbove(s) && (best == kNoIndex || beats(s, best)) ? s : best;
    h = mesh.around(h);
  } while (h != first);
  return best;
}

/// What is best at the corners of a touched triangle. Where the best so far was touched, too, all
/// triangles there are looked at afterwards.
void Rounds::lookAt(Slot s)
{
  for (Slot corner = s; corner < s + 3; ++corner)
  {
    const Vertex v = surface_.mesh().apex(corner);
    Slot& best = bestAt_[v];
    if (look_[v] == kNotYet)
    {
      look_[v] = best != kNoIndex && surface_.isTouched(best) ? kAtAll : kAtTouched;
      touched_.push_back(v);
    }
    if (look_[v] == kAtTouched && isAbove(s) && (best == kNoIndex || beats(s, best)))
    {
      best = s;
    }
  }
}

/// Looks at the vertices of the touched triangles again; what is best there may be a maximum.
bool Rounds::refresh()
{
  const LivingMesh& mesh = surface_.mesh();
  bestAt_.resize(mesh.vertexCount() + 1, kNoIndex);
  look_.resize(mesh.vertexCount() + 1, kNotYet);
  for (const Slot s : surface_.touched())
  {
    if (!mesh.isGhost(s))
    {
      lookAt(s);
    }
  }
  surface_.clearTouched();
  bool goesOn = true;
  for (const Vertex v : touched_)
  {
    bestAt_[v] = look_[v] == kAtAll ? bestAround(v) : bestAt_[v];
    look_[v] = kNotYet;
    if (bestAt_[v] != kNoIndex)
    {
      maxima_.push_back(bestAt_[v]);
    }
    goesOn = goesOn && ticker_.step();
  }
  touched_.clear();
  return goesOn;
}

/// The maxima among the candidates, the first to be kept first.
void Rounds::select()
{
  const auto isNone = [this](Slot s)
  { return !surface_.mesh().isUsed(s) || !isAbove(s) || !isLocalMaximum(s); };
  maxima_.erase(std::remove_if(maxima_.begin(), maxima_.end(), isNone), maxima_.end());
  std::sort(
    maxima_.begin(), maxima_.end(), [this](Slot s, Slot t) { return s != t && beats(s, t); });
  maxima_.erase(std::unique(maxima_.begin(), maxima_.end()), maxima_.end());
}

/// How many of the maxima this round keeps.
std::size_t Rounds::chosen() const
{
  if (limit_ == 0)
  {
    return maxima_.size();
  }
  const double least = kLeastOfLargest * surface_.worst(maxima_.front()).error;
  std::size_t n = 0;
  while (n < maxima_.size() && surface_.worst(maxima_[n]).error >= least)
  {
    ++n;
  }
  return surface_.kept() >= limit_ ? 0 : std::min(n, limit_ - surface_.kept());
}

/// The fraction moves with the logarithm of the largest error. It reports, and decides nothing.
void Rounds::report(std::size_t units)
{
  const double largest = surface_.worst(maxima_.front()).error;
  first_ = std::max(first_, largest);
  const double last = std::max(bound_, kSmall * first_);
  const double part = std::isfinite(first_) && first_ > last
    ? (roughLog2(first_) - roughLog2(std::max(largest, last))) /
      (roughLog2(first_) - roughLog2(last))
    : 0.0;
  const auto passed = static_cast<std::size_t>(part * double(units));
  if (passed > passed_)
  {
    ticker_.finished(passed - passed_);
    passed_ = passed;
  }
}

void Rounds::remember()
{
  const double largest = surface_.worst(maxima_.front()).error;
  if (largest < least_ || best_ == 0)
  {
    least_ = largest;
    best_ = surface_.kept();
  }
}

/// Keeps the first of the maxima.
bool Rounds::keepMaxima(std::size_t count)
{
  surface_.expect(count);
  std::vector<Index> ranks; // those of the slots change
  for (std::size_t k = 0; k < count; ++k)
  {
    ranks.push_back(surface_.worst(maxima_[k]).rank);
  }
  for (std::size_t k = 0; k < count; ++k)
  {
    surface_.keep(ranks[k], maxima_[k]);
  }
  maxima_.erase(maxima_.begin(), maxima_.begin() + static_cast<std::ptrdiff_t>(count));
  ++count_;
  return surface_.settle();
}

bool Rounds::run(double bound, std::size_t units)
{
  bound_ = bound;
  first_ = 0.0;
  passed_ = 0;
  while (!isLimited_)
  {
    if (!refresh() || !ticker_.ask())
    {
      return false;
    }
    select();
    if (maxima_.empty())
    {
      break;
    }
    remember();
    report(units);
    const std::size_t n = chosen();
    isLimited_ = n == 0;
    if (!isLimited_ && !keepMaxima(n))
    {
      return false;
    }
  }
  ticker_.finished(units - passed_);
  return true;
}

} // namespace ahd
