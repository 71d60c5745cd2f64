// SPDX-License-Identifier: BSD-3-Clause
#include "ConstraintSets.h"

#include "PlaceTable.h"

#include <set>

namespace ahd
{
namespace test
{

void ConstraintSet::add(const Chain& chain)
{
  ids_.insert(ids_.end(), chain.begin(), chain.end());
  offsets_.push_back(std::int64_t(ids_.size()));
}

void ConstraintSet::addLine(const Chain& chain)
{
  add(chain);
  ++lines_;
}

void ConstraintSet::addLoop(const Chain& chain)
{
  add(chain);
}

ConstraintView ConstraintSet::view() const
{
  ConstraintView result;
  result.ids = ids_.data();
  result.offsets = offsets_.data();
  result.chains = chains();
  result.lines = lines_;
  return result;
}

Chain ConstraintSet::chain(std::size_t k) const
{
  return Chain(ids_.begin() + offsets_[k], ids_.begin() + offsets_[k + 1]);
}

ConstraintSet ConstraintSet::asLines() const
{
  ConstraintSet result;
  for (std::size_t k = 0; k < chains(); ++k)
  {
    Chain open = chain(k);
    if (k >= lines_ && !open.empty() && open.front() != open.back())
    {
      open.push_back(open.front());
    }
    result.addLine(open);
  }
  return result;
}

ConstraintSet ConstraintSet::renamed(const std::vector<std::int64_t>& newId) const
{
  ConstraintSet result = *this;
  for (std::int64_t& id : result.ids_)
  {
    id = id >= 0 && std::size_t(id) < newId.size() ? newId[std::size_t(id)] : id;
  }
  return result;
}

std::string ConstraintSet::text() const
{
  std::string result = "lines";
  for (std::size_t k = 0; k < chains(); ++k)
  {
    result += k == lines_ ? "; loops {" : " {";
    const Chain ids = chain(k);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      result += (i == 0 ? "" : " ") + std::to_string(ids[i]);
    }
    result += "}";
  }
  return result;
}

std::vector<GivenSegment> segmentsOf(const ConstraintView& constraints)
{
  std::vector<GivenSegment> result;
  for (std::size_t k = 0; k < constraints.chains; ++k)
  {
    const std::int64_t* ids = constraints.ids + constraints.offsets[k];
    const auto count = std::size_t(constraints.offsets[k + 1] - constraints.offsets[k]);
    const bool isLoop = k >= constraints.lines;
    const bool isOpen = count > 1 && ids[0] != ids[count - 1];
    for (std::size_t i = 0; i + 1 < count; ++i)
    {
      result.push_back({ k, i, ids[i], ids[i + 1], isLoop });
    }
    if (isLoop && isOpen)
    {
      result.push_back({ k, count - 1, ids[count - 1], ids[0], true });
    }
  }
  return result;
}

std::vector<GivenSegment> segmentsOf(
  const ConstraintView& constraints, const std::vector<std::int32_t>& vertices)
{
  std::vector<GivenSegment> result = segmentsOf(constraints);
  for (GivenSegment& given : result)
  {
    std::set<std::int32_t> passed;
    for (std::int64_t i = constraints.offsets[given.chain];
         i < constraints.offsets[given.chain + 1] && passed.size() < 3; ++i)
    {
      passed.insert(vertexOf(vertices, constraints.ids[i]));
    }
    given.ofLoop = given.ofLoop && passed.size() > 2;
  }
  return result;
}

std::vector<std::int32_t> verticesOf(const PointView& points)
{
  PlaceTable places(points);
  std::vector<std::int32_t> result(points.count, -1);
  for (std::size_t i = 0; i < points.count; ++i)
  {
    if (!points.skipped(i) && isFinite(points[i]))
    {
      result[i] = places.firstAt(i);
    }
  }
  return result;
}

} // namespace test
} // namespace ahd
