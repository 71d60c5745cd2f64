// SPDX-License-Identifier: BSD-3-Clause
#include "Outside.h"

#include "../Core/Border.h"
#include "../Core/Buffer.h"
#include "../Core/Loops.h"

#include <algorithm>
#include <vector>

namespace ahd
{

namespace
{

constexpr std::size_t kBlock = std::size_t(1) << 18; // places that are looked for at a time

/// The places without a value, a block at a time.
class Filling
{
public:
  Filling(const SamplePlaces& places, const SampleArray* arrays, std::size_t count)
    : places_(places)
    , arrays_(arrays, arrays + count)
  {
    const std::size_t most = std::min(places.count(), kBlock);
    which_.allocate(most);
    xy_.allocate(2 * most);
    found_.resize(count);
    for (std::size_t k = 0; k != count; ++k)
    {
      found_[k].allocate(most * arrays_[k].components);
    }
  }

  /// Lists places from `next` on until there are enough; moves `next` behind them. Returns false if
  /// cancelled.
  bool list(std::size_t& next, const unsigned char* mask, Progress* progress)
  {
    Ticker ticker(progress, Phase::Outputs, 0); // a phase of its own, as each call of values() has
    listed_ = 0;
    const std::size_t all = places_.count();
    while (next != all && listed_ != which_.size())
    {
      const std::size_t end = next + std::min({ all - next, which_.size() - listed_, kChunk });
      for (std::size_t k = next; k != end; ++k)
      {
        if (mask[k] == 0) // those that are not finite have no nearest vertex either
        {
          const Point place = places_[k];
          which_[listed_] = k;
          xy_[2 * listed_] = place.x;
          xy_[2 * listed_ + 1] = place.y;
          ++listed_;
        }
      }
      if (!ticker.step(end - next))
      {
        return false;
      }
      next = end;
    }
    return ticker.ask();
  }

  Status fill(const Sampler& sampler, const Context& context)
  {
    std::vector<SampleArray> arrays(arrays_);
    for (std::size_t k = 0; k != arrays.size(); ++k)
    {
      arrays[k].out = found_[k].data();
      arrays[k].gradients = nullptr;
    }
    SampleReport report;
    const PointView listed(xy_.data(), listed_, 2);
    const SamplePlaces places(listed);
    return sampler.isNearest()
      ? sampler.values(places, arrays.data(), arrays.size(), nullptr, report, context)
      : sampler.valuesAtRim(places, arrays.data(), arrays.size(), report, context);
  }

  /// Returns false if cancelled.
  bool write(Progress* progress) const
  {
    Ticker ticker(progress, Phase::Outputs, 0);
    return inChunks(0, listed_, ticker,
      [this](std::size_t a, std::size_t b)
      {
        for (std::size_t k = 0; k != arrays_.size(); ++k)
        {
          const std::size_t n = arrays_[k].components;
          for (std::size_t i = a; i != b; ++i)
          {
            std::copy_n(found_[k].data() + i * n, n, arrays_[k].out + which_[i] * n);
          }
        }
      });
  }

  bool isEmpty() const { return listed_ == 0; }

private:
  const SamplePlaces& places_;
  std::vector<SampleArray> arrays_;
  Buffer<std::size_t> which_;
  Buffer<double> xy_;
  std::vector<Buffer<double>> found_;
  std::size_t listed_ = 0;
};

} // namespace

Status fillOutside(const Sampler& sampler, const SamplePlaces& places, const SampleArray* arrays,
  std::size_t count, const unsigned char* mask, const Context& context)
{
  return withoutThrowing(
    [&]
    {
      Filling filling(places, arrays, count);
      for (std::size_t next = 0; next != places.count();)
      {
        if (!filling.list(next, mask, context.progress))
        {
          return Status::Cancelled;
        }
        const Status status = filling.isEmpty() ? Status::Ok : filling.fill(sampler, context);
        if (status != Status::Ok)
        {
          return status;
        }
        if (!filling.write(context.progress))
        {
          return Status::Cancelled;
        }
      }
      return Status::Ok;
    });
}

std::size_t fillOutsideMemoryEstimate(
  std::size_t pointCount, const SamplePlaces& places, std::size_t components)
{
  std::size_t most = kBlock;
  if (!places.isRaster())
  {
    most = std::min(places.count(), kBlock);
  }
  else if (places.raster().rows == 0 || places.raster().columns <= kBlock / places.raster().rows)
  {
    most = places.count();
  }
  const PointView block(static_cast<const double*>(nullptr), most, 2);
  return most * (sizeof(std::size_t) + (2 + components) * sizeof(double)) +
    sampleMemoryEstimate(pointCount, SamplePlaces(block), components) +
    components * 2 * (sizeof(SampleArray) + sizeof(Buffer<double>));
}

} // namespace ahd
