// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_JobRun_h
#define ahd_JobRun_h

#include "Constraints.h"
#include "Interface/ahd.h"
#include "Points/Points.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ahd
{
namespace test
{

/// A job of the C interface, for tests in C++. Borrows its arguments.
class JobRun
{
public:
  JobRun();
  ~JobRun();
  JobRun(const JobRun&) = delete;
  JobRun& operator=(const JobRun&) = delete;

  void setPoints(const PointView& points);
  void setConstraints(const ConstraintView& constraints);
  void set(const char* name, std::int64_t value);
  void set(const char* name, double value);

  ahd_status run() { return ahd_run(job_); }

  std::int64_t count(const char* name);
  /// An output array, row by row; empty on failure, which status() gives.
  std::vector<std::int64_t> ids(const char* name);
  std::vector<std::int32_t> shortIds(const char* name);
  std::vector<double> doubles(const char* name);
  std::vector<std::uint8_t> bytes(const char* name);

  /// That of the first call that failed since it was made.
  ahd_status status() const { return status_; }
  std::string message() const { return message_; }
  ahd_job* job() const { return job_; }

private:
  template <typename Number>
  std::vector<Number> read(const char* name, std::int32_t type);
  void note(ahd_status status);

  ahd_job* job_;
  ahd_status status_ = AHD_OK;
  std::string message_;
};

} // namespace test
} // namespace ahd

#endif
