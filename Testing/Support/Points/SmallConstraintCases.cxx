// SPDX-License-Identifier: BSD-3-Clause
#include "ConstraintMakers.h"
#include "ExactSigns.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace ahd
{
namespace test
{
namespace
{

constexpr std::size_t kMostPoints = 12;

/// Makes one small case, choosing at random throughout.
class SmallCase
{
public:
  explicit SmallCase(std::uint64_t seed)
    : random_(seed * 2 + 1)
  {
  }

  ConstraintCase make()
  {
    places();
    spoil();
    const std::size_t lines = random_.below(5);
    for (std::size_t k = 0; k < lines; ++k)
    {
      chains_.push_back(chain());
      result_.constraints.addLine(chains_.back());
    }
    const std::size_t loops = random_.below(4);
    for (std::size_t k = 0; k < loops; ++k)
    {
      chains_.push_back(loop());
      result_.constraints.addLoop(chains_.back());
    }
    return result_;
  }

private:
  std::size_t count() const { return result_.points.size(); }
  bool chance(std::size_t oneIn) { return random_.below(oneIn) == 0; }

  void places();
  void spoil();
  std::int64_t anyId();
  Chain chain();
  Chain loop();
  Chain rectangle();
  void copyOf(Chain& chain);

  Random random_;
  std::size_t width_ = 0, height_ = 0; ///< of a lattice that has all its points, else 0
  std::vector<std::int64_t> idAt_;     ///< of such a lattice, column by column
  std::vector<Chain> chains_;
  ConstraintCase result_;
};

void SmallCase::places()
{
  static const double kSteps[] = { 1.0, 1.0, 1.0, 1.0, 0.1, 1e-300, 1e299, 0x1p-1074, 1e-12 };
  const auto step = [&] { return kSteps[random_.below(9)]; };
  const Point scale = { step(), step() };
  const auto at = [&](std::size_t x, std::size_t y) {
    return Point{ double(x) * scale.x, double(y) * scale.y };
  };
  if (chance(2))
  {
    width_ = 2 + random_.below(3);
    height_ = 2 + random_.below(2);
    for (std::size_t i = 0; i < width_ * height_; ++i)
    {
      idAt_.push_back(std::int64_t(i));
    }
    for (std::size_t i = idAt_.size(); i > 1; --i)
    {
      std::swap(idAt_[i - 1], idAt_[random_.below(i)]);
    }
    result_.points.resize(idAt_.size());
    for (std::size_t i = 0; i < idAt_.size(); ++i)
    {
      result_.points[std::size_t(idAt_[i])] = at(i / height_, i % height_);
    }
    return;
  }
  const std::size_t n = random_.below(kMostPoints);
  const bool anywhere = chance(4);
  const std::size_t side = 2 + random_.below(5);
  for (std::size_t i = 0; i < n; ++i)
  {
    const double x = random_.unit();
    const double y = random_.unit();
    const std::size_t column = random_.below(side);
    const std::size_t row = random_.below(side);
    result_.points.push_back(anywhere ? Point{ x * scale.x, y * scale.y } : at(column, row));
  }
}

/// A duplicate, a point that is not finite, points that are left out: now and then.
void SmallCase::spoil()
{
  if (chance(8) && count() > 0)
  {
    const Point p = result_.points[random_.below(count())];
    result_.points.push_back({ p.x, p.y == 0.0 ? -p.y : p.y });
  }
  if (chance(20))
  {
    result_.points.push_back({ std::numeric_limits<double>::quiet_NaN(), 1.0 });
  }
  if (chance(20))
  {
    result_.skip.assign(count(), 0);
    for (unsigned char& mark : result_.skip)
    {
      mark = chance(8) ? 1 : 0;
    }
  }
}

std::int64_t SmallCase::anyId()
{
  static const std::int64_t kNone[] = { -1, 1000, std::int64_t(1) << 40,
    std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max() };
  return count() == 0 || chance(150) ? kNone[random_.below(5)]
                                     : std::int64_t(random_.below(count()));
}

/// May become one of the chains before, or end as one does, either way round.
void SmallCase::copyOf(Chain& chain)
{
  if (!chains_.empty() && chance(5))
  {
    const Chain& other = chains_[random_.below(chains_.size())];
    const std::size_t kept = chance(2) ? 0 : chain.size();
    chain.resize(kept);
    chain.insert(chain.end(), other.begin(), other.end());
  }
  if (chance(3))
  {
    std::reverse(chain.begin(), chain.end());
  }
}

Chain SmallCase::chain()
{
  Chain result;
  const std::size_t length = chance(12) ? random_.below(2) : 2 + random_.below(4);
  for (std::size_t i = 0; i < length; ++i)
  {
    result.push_back(anyId());
  }
  copyOf(result);
  return result;
}

/// Counterclockwise round boxes of a lattice.
Chain SmallCase::rectangle()
{
  const std::size_t x0 = random_.below(width_ - 1);
  const std::size_t x1 = x0 + 1 + random_.below(width_ - 1 - x0);
  const std::size_t y0 = random_.below(height_ - 1);
  const std::size_t y1 = y0 + 1 + random_.below(height_ - 1 - y0);
  const auto at = [&](std::size_t x, std::size_t y) { return idAt_[x * height_ + y]; };
  return { at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1) };
}

Chain SmallCase::loop()
{
  Chain result;
  if (width_ > 0 && !chance(4))
  {
    result = rectangle();
    if (chance(4)) // two in one: a figure of eight, or one twice, or a bridge between them
    {
      result.push_back(result.front());
      const Chain other = rectangle();
      result.insert(result.end(), other.begin(), other.end());
      result.push_back(other.front());
    }
  }
  else
  {
    const std::size_t length = chance(10) ? random_.below(3) : 3 + random_.below(3);
    for (std::size_t i = 0; i < length; ++i)
    {
      result.push_back(anyId());
    }
  }
  copyOf(result);
  if (!result.empty() && chance(6))
  {
    result.push_back(result.front());
  }
  return result;
}

} // namespace

PointView ConstraintCase::view() const
{
  PointView result(points.empty() ? nullptr : &points[0].x, points.size(), 2);
  result.skip = skip.empty() ? nullptr : skip.data();
  return result;
}

std::string ConstraintCase::text() const
{
  std::string result;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    result += std::to_string(i) + " " + hexText(points[i]) +
      (!skip.empty() && skip[i] ? " left out\n" : "\n");
  }
  return result + constraints.text() + "\n";
}

ConstraintCase smallConstraintCase(std::uint64_t seed)
{
  return SmallCase(seed).make();
}

ConstraintCase shuffledCase(const ConstraintCase& original, std::uint64_t seed)
{
  std::vector<std::int64_t> newId(original.points.size());
  std::iota(newId.begin(), newId.end(), 0);
  Random random(seed);
  for (std::size_t i = newId.size(); i > 1; --i)
  {
    std::swap(newId[i - 1], newId[random.below(i)]);
  }
  ConstraintCase result = original;
  result.constraints = original.constraints.renamed(newId);
  for (std::size_t i = 0; i < newId.size(); ++i)
  {
    result.points[std::size_t(newId[i])] = original.points[i];
    if (!original.skip.empty())
    {
      result.skip[std::size_t(newId[i])] = original.skip[i];
    }
  }
  return result;
}

} // namespace test
} // namespace ahd
