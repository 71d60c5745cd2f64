// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ConstrainedRun_h
#define ahd_ConstrainedRun_h

#include "ConstraintCertifier.h"
#include "ConstraintMakers.h"
#include "EngineRun.h"
#include "Executors.h"

#include <string>

namespace ahd
{
namespace test
{

/// Executor and progress; all may be null.
struct Helpers
{
  Progress* progress = nullptr;
  Executor* executor = nullptr;
};

/// run(), constrain() and all outputs, in one call. `status` is that of the first call that was not
/// Ok; outputs not written by then stay empty.
ConstrainedOutcome constrain(Engine& engine, const PointView& points,
  const ConstraintView& constraints, FillRule rule, const Options& options = Options(),
  const Helpers& helpers = Helpers());
ConstrainedOutcome constrain(const ConstraintCase& given, FillRule rule);

/// Runs twice, filled and not, and certifies both (certifyConstrained). Empty if all is correct.
std::string faultsOfConstraining(const ConstraintCase& given, FillRule rule);

/// The first difference, in words; empty if all is the same to the byte.
std::string difference(const ConstrainedOutcome& a, const ConstrainedOutcome& b);

/// The differences with this executor instead of this thread; empty if none.
/// `expected` is constrain(given, rule).
std::string differenceByThreads(const ConstraintCase& given, FillRule rule,
  const ConstrainedOutcome& expected, Executor& executor);

const char* nameOf(FillRule rule);
constexpr FillRule kFillRules[] = { FillRule::Orientation, FillRule::EvenOdd };

} // namespace test
} // namespace ahd

#endif
