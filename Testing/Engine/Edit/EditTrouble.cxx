// SPDX-License-Identifier: BSD-3-Clause
//
// An Edit that is cancelled, or has no memory, at any time is as before or as far as it says, and
// goes on. This program's operator new fails on demand.
#include "Core/Progress.h"
#include "Distributions.h"
#include "EditCase.h"
#include "Executors.h"
#include "OwnMemory.h"

#include <limits>

namespace ahd
{
namespace test
{
namespace
{

/// Cancels at one poll, from 1; counts them.
class CancelAt : public Progress
{
public:
  explicit CancelAt(std::size_t poll)
    : poll_(poll)
  {
  }
  bool advance(Phase, double) override { return ++polls != poll_; }

  std::size_t polls = 0;

private:
  std::size_t poll_;
};

Edit made(const std::vector<Point>& points)
{
  Edit edit;
  std::int64_t first = -1;
  EXPECT_EQ(edit.insert(viewOf(points), Context(), first), Status::Ok);
  EXPECT_EQ(first, 0);
  const std::int64_t count = std::int64_t(points.size());
  for (std::int64_t id = 0; id + 7 < count && id < 200; id += 10)
  {
    constrainOne(edit, id, id + 7);
  }
  return edit;
}

void expectSame(const EditedInput& a, const EditedInput& b)
{
  EXPECT_TRUE(a.places == b.places && a.ids == b.ids);
  EXPECT_TRUE(a.segments == b.segments && a.offsets == b.offsets);
}

/// An insertion of many: triangulated with the others, or one by one.
void expectCancelled(std::size_t before, std::size_t more)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, before, 1);
  const std::vector<Point> added = makePoints(Distribution::Utm, more, 2);
  Edit edit = made(points);
  const EditedInput expected = inputOf(edit);
  std::int64_t first = -1;
  for (std::size_t poll = 1;; poll += 1 + poll / 2)
  {
    CancelAt progress(poll);
    const Status status = edit.insert(viewOf(added), { &progress, nullptr }, first);
    if (status == Status::Ok)
    {
      EXPECT_GT(poll, 3u);
      break;
    }
    ASSERT_EQ(status, Status::Cancelled);
    expectSame(inputOf(edit), expected);
    EXPECT_EQ(edit.pointCount(), before);
  }
  EXPECT_EQ(edit.pointCount(), before + more);
  EXPECT_EQ(first, std::int64_t(before));
  expectFresh(edit);
}

TEST(EditTrouble, AnInsertionThatIsCancelledIsNotDone)
{
  expectCancelled(1000, 30000);
  expectCancelled(40000, 30000);
}

TEST(EditTrouble, RequestsBeforeTheCancellationAreDone)
{
  Edit edit = made(makePoints(Distribution::Uniform, 60000, 1));
  std::vector<std::int64_t> ids(50000);
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    ids[k] = 1000 + std::int64_t(k);
  }
  std::vector<EditOutcome> outcomes(ids.size());
  CancelAt progress(3);
  EXPECT_EQ(edit.remove(ids.data(), ids.size(), { &progress, nullptr }, outcomes.data()),
    Status::Cancelled);
  const auto done = std::count(outcomes.begin(), outcomes.end(), EditOutcome::Done);
  EXPECT_GT(done, 0);
  EXPECT_EQ(edit.pointCount(), 60000u - std::size_t(done));
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    EXPECT_EQ(outcomes[k] == EditOutcome::NotTried, edit.has(ids[k]));
  }
  expectFresh(edit);
}

/// Every call once, each allocation failing in turn; true if all succeeded.
bool runFailing(Edit& edit, std::size_t k)
{
  const std::vector<Point> added = { { 0.25, 0.5 }, { 0.25, 0.5 }, { 3.0, 4.0 } };
  const std::vector<Point> many = makePoints(Distribution::Lattice, 300, 5);
  const std::int64_t ids[] = { 3, 4, 5 }, ends[] = { 1, 2, 8, 9, 10, 17 };
  EditOutcome outcomes[3];
  EditPlace places[3];
  EditedInput out;
  std::int64_t first = -1;
  account.allocations = 0;
  account.failAt = k;
  Status status[7];
  status[0] = edit.insert(viewOf(added), Context(), first);
  status[1] = edit.remove(ids, 3, Context(), outcomes);
  status[2] = edit.move(ids, viewOf(added), Context(), outcomes);
  status[3] = edit.constrain(ends, 3, Context(), outcomes);
  status[4] = edit.release(ends, 3, Context(), outcomes);
  status[5] = edit.insert(viewOf(many), Context(), first);
  status[6] = edit.locate(viewOf(added), Context(), places);
  const Status written = edit.write(out, Context());
  account.failAt = 0;
  bool isOk = written == Status::Ok;
  for (const Status s : status)
  {
    EXPECT_TRUE(s == Status::Ok || s == Status::OutOfMemory);
    isOk = isOk && s == Status::Ok;
  }
  return isOk;
}

TEST(EditTrouble, AnyAllocationMayFail)
{
  for (const Distribution d : { Distribution::RepeatedDraws, Distribution::Collinear })
  {
    for (const bool once : { true, false })
    {
      std::size_t k = 1;
      for (bool isOk = false; !isOk && k < 100000; k += 1 + k / 16)
      {
        Edit edit = made(makePoints(d, 40, 3));
        account.failsOnce = once;
        isOk = runFailing(edit, k);
        expectFresh(edit);
        EXPECT_EQ(inputOf(edit).places.size(), edit.pointCount());
        ASSERT_FALSE(HasFailure()) << nameOf(d) << ", allocation " << k;
      }
      EXPECT_GT(k, 60u);
    }
  }
}

TEST(EditTrouble, MemoryIsBetweenItsEstimates)
{
  const std::size_t before = account.held;
  Edit edit = made(makePoints(Distribution::Uniform, 5000, 3));
  for (std::size_t k = 0; k < 2; ++k)
  {
    const std::size_t taken = account.held - before;
    EXPECT_LE(edit.heldMemory(), taken);
    EXPECT_GT(2 * edit.heldMemory(), taken);
    EXPECT_GE(edit.memoryEstimate(0), taken);
    std::int64_t first = 0;
    EXPECT_EQ(edit.insert(viewOf(makePoints(Distribution::Uniform, 3000, 4)), Context(), first),
      Status::Ok);
  }
}

TEST(EditTrouble, IdsThatNoPointHasAreRefused)
{
  Edit edit = made(makePoints(Distribution::Uniform, 10, 3));
  EXPECT_EQ(edit.memoryEstimate(0) < edit.memoryEstimate(1000), true);
  EXPECT_EQ(removeOne(edit, 9), EditOutcome::Done);
  for (const std::int64_t id : { std::int64_t(-1), std::int64_t(9), std::int64_t(10),
         std::int64_t(1) << 32, std::numeric_limits<std::int64_t>::min() })
  {
    EXPECT_EQ(removeOne(edit, id), EditOutcome::NoPoint) << id;
    EXPECT_EQ(moveOne(edit, id, { 0.0, 0.0 }), EditOutcome::NoPoint) << id;
    EXPECT_EQ(constrainOne(edit, id, 0), EditOutcome::NoPoint) << id;
    EXPECT_EQ(releaseOne(edit, 1, id), EditOutcome::NoPoint) << id;
  }
  EXPECT_EQ(insertOne(edit, { 0.5, 0.5 }), 10) << "ids are not used again";
  const double unused = 0.0;
  std::int64_t first = -1;
  EXPECT_EQ(
    edit.insert(PointView(&unused, kMaximumPoints, 2), Context(), first), Status::TooManyPoints);
  expectFresh(edit);
}

} // namespace
} // namespace test
} // namespace ahd
