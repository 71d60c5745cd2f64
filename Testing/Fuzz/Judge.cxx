// SPDX-License-Identifier: BSD-3-Clause
#include "Judge.h"

#include "OwnMemory.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace ahd
{
namespace fuzz
{

void expectNone(const std::string& fault, const FuzzCase& given)
{
  if (!fault.empty())
  {
    std::fprintf(stderr, "%s\n%s", fault.c_str(), given.text().c_str());
    std::abort();
  }
}

void expect(bool isTrue, const char* what, const FuzzCase& given)
{
  expectNone(isTrue ? "" : std::string("not so: ") + what, given);
}

NoMemory::NoMemory(std::size_t from)
  : outerFailAt_(test::account.failAt)
  , outerAllocations_(test::account.allocations)
{
  test::account.allocations = 0;
  test::account.failAt = from;
}

NoMemory::~NoMemory()
{
  test::account.allocations = outerAllocations_;
  test::account.failAt = outerFailAt_;
}

void Watch::beginPhase(Phase phase)
{
  fault_ += cancelled() ? "a phase begins after cancelling; " : "";
  phase_ = phase;
  fraction_ = 0.0;
}

bool Watch::advance(Phase phase, double fraction)
{
  fault_ += cancelled() ? "asked after cancelling; " : "";
  fault_ += phase != phase_ ? "asked in a phase that did not begin; " : "";
  fault_ += !(fraction >= fraction_ && fraction <= 1.0) ? "the fraction falls or exceeds 1; " : "";
  fraction_ = fraction;
  ++askings_;
  return !cancelled();
}

void expectStops(const FuzzCase& given, const std::function<Status(Progress*)>& work)
{
  if (given.head[kCancelAt] != 0)
  {
    Watch watch(given.head[kCancelAt]);
    const Status status = work(&watch);
    expectNone(watch.fault(), given);
    expect(status == (watch.cancelled() ? Status::Cancelled : Status::Ok), "cancelled if told to",
      given);
  }
  if (given.head[kFailAt] != 0)
  {
    Status status = Status::Ok;
    {
      const NoMemory none(given.head[kFailAt]);
      status = work(nullptr);
    }
    expect(status == Status::Ok || status == Status::OutOfMemory, "out of memory or Ok", given);
  }
}

Layout::Layout(const FuzzCase& given, const std::vector<Point>& points)
  : skip_(given.skipMarks(points.size()))
  , count_(points.size())
  , stride_(2 + (given.head[kLayout] >> 1 & 3))
  , mask_(given.head[kSkipMask])
{
  const bool asFloats = given.layoutBit(0);
  // not a number more than needed: reading beyond is detected
  const std::size_t numbers = count_ == 0 ? 0 : (count_ - 1) * stride_ + 2;
  doubles_.assign(asFloats ? 0 : numbers, 7.0);
  floats_.assign(asFloats ? numbers : 0, 7.0F);
  for (std::size_t i = 0; i < count_; ++i)
  {
    const double xy[] = { points[i].x, points[i].y };
    for (std::size_t k = 0; k < 2; ++k)
    {
      asFloats ? void(floats_[i * stride_ + k] = float(xy[k]))
               : void(doubles_[i * stride_ + k] = xy[k]);
    }
  }
}

PointView Layout::view() const
{
  PointView result = floats_.empty() ? PointView(doubles_.data(), count_, stride_)
                                     : PointView(floats_.data(), count_, stride_);
  result.skip = skip_.empty() ? nullptr : skip_.data();
  result.skipMask = mask_;
  return result;
}

std::vector<std::size_t> shuffledIds(std::size_t n, unsigned seed)
{
  std::vector<std::size_t> ids(n);
  std::iota(ids.begin(), ids.end(), std::size_t(0));
  test::Random random(seed);
  for (std::size_t i = seed == 0 ? 0 : n; i > 1; --i)
  {
    std::swap(ids[i - 1], ids[random.below(i)]);
  }
  return ids;
}

Run runOf(const FuzzCase& given, std::size_t run)
{
  return { given.options(run), given.executor(run), nullptr };
}

test::Outcome triangulate(test::Engine& engine, const PointView& points, const Run& run)
{
  test::Outcome outcome;
  Status& status = outcome.status;
  status = engine.run(points, run.options, run.progress, run.executor);
  outcome.report = engine.report();
  if (status == Status::Ok)
  {
    const NoMemory pause(0); // of the test's own data
    outcome.triples.resize(3 * outcome.report.triangles, -7);
    outcome.pointStatus.resize(points.count, -7);
  }
  status = status != Status::Ok
    ? status
    : engine.writeTriangles(outcome.triples.data(), run.progress, run.executor);
  status = status != Status::Ok
    ? status
    : engine.writePointStatus(outcome.pointStatus.data(), run.progress, run.executor);
  return outcome;
}

} // namespace fuzz
} // namespace ahd
