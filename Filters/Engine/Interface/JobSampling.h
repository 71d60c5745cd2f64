// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_JobSampling_h
#define ahd_JobSampling_h

#include "../Sample/Sample.h"
#include "ahd.h"

#include <cstddef>
#include <cstdint>

namespace ahd
{

class Job;

/// What sampling makes of a result and keeps for the next time.
struct JobSampling
{
  struct Ready
  {
    bool is = false;
    SampleMethod method = SampleMethod::Linear;
    Sampler sampler;
  };

  /// To be called before anything else is made or written of the triangulation: the samplers look
  /// at what that may change.
  void forget()
  {
    byMethod = Ready();
    nearest = Ready();
  }

  Ready byMethod, nearest; ///< nearest: for places outside
  bool hasTables = false;  ///< has the triangulation those that it is asked with?
  bool hasWeights = false;
  SampleWeights weights;
  std::size_t places = 0;
  SampleReport report;
  std::size_t estimate = 0; ///< bytes
  double seconds = 0.0;
};

// Calls of ahd_sample.h; what cannot be done is refused.
void sample(Job& job, const ahd_places& places, const ahd_sampled* arrays, std::uint64_t count,
  std::uint8_t* mask);
void weigh(Job& job, const ahd_places& places);
/// Writes the estimate, and refuses if it is more than is allowed.
void estimateSample(
  Job& job, const ahd_places& places, std::uint64_t columns, std::uint64_t& bytes);

/// What sampling takes of so many points, the tables not counted.
std::uint64_t samplingEstimate(
  std::uint64_t points, const ahd_places& places, std::uint64_t columns, bool fills);

} // namespace ahd

#endif
