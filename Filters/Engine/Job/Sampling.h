// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_JobSampling_h
#define ahd_JobSampling_h

#include "../Sample/Sample.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

class Job;
struct JobResult;

/// Sampling data of a result, kept for the next call.
struct JobSampling
{
  struct Ready
  {
    bool is = false;
    SampleMethod method = SampleMethod::Linear;
    Sampler sampler;
  };

  /// Must be called before anything else uses the triangulation, since the samplers read data
  /// that it may change.
  void forget()
  {
    byMethod = Ready();
    nearest = Ready();
  }

  Ready byMethod, nearest; ///< nearest: for places outside
  bool hasTables = false;  ///< does the triangulation have its tables?
  bool hasWeights = false;
  SampleWeights weights;
  SampleReport report;
  std::size_t estimate = 0; ///< bytes
  double seconds = 0.0;
};

/// The places of the values: `count` places; if `xy` is null, a raster.
struct GivenPlaces
{
  const double* xy;
  std::uint64_t count;
  std::array<double, 2> origin, spacing;
  std::uint64_t columns, rows;
};
/// As a raster. Refuses what is none.
SampleRaster wholeRaster(const GivenPlaces& given);

/// Numbers to interpolate.
struct GivenSamples
{
  const double* values;
  std::int32_t columns;
  double* out;
  double* gradients; ///< may be null
};

/// One call that interpolates on a result, within available memory.
/// Its functions refuse.
class Sampling
{
public:
  Sampling(Job& job, const GivenPlaces& places);

  /// Writes the bytes that so many columns may take, and refuses if it is more than is allowed.
  void estimate(std::uint64_t columns, std::uint64_t& bytes) const;
  /// `mask`: null, or whether each place has a value of its own.
  void values(const std::vector<GivenSamples>& given, std::uint8_t* mask);
  /// Stores them in the result.
  void weights();

private:
  std::size_t bytesFor(std::size_t components, bool hasMask) const;
  void checkMemory(std::size_t bytes) const;
  std::vector<SampleArray> arraysOf(const std::vector<GivenSamples>& given) const;
  bool fills() const { return outside_ != OutsideValues::None; }
  template <typename Work>
  void run(std::size_t bytes, const Work& work);
  const Sampler& prepare(JobSampling::Ready& ready, SampleMethod method, const Context& context);
  std::vector<double> stageWeights() const;

  Job& job_;
  JobResult& made_;
  JobSampling& kept_;
  SamplePlaces places_;
  SampleMethod method_;
  OutsideValues outside_;
};

/// The bytes that sampling takes for so many points, without the tables.
std::uint64_t samplingEstimate(
  std::uint64_t points, const GivenPlaces& places, std::uint64_t columns, bool fills);

} // namespace ahd

#endif
