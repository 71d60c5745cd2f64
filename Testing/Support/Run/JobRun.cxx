// SPDX-License-Identifier: BSD-3-Clause
#include "JobRun.h"

namespace ahd
{
namespace test
{
namespace
{

template <typename Number>
std::int64_t stepsOf(std::int64_t count)
{
  return count * static_cast<std::int64_t>(sizeof(Number));
}

ahd_array listOf(const std::int64_t* numbers, std::size_t count)
{
  return { numbers, AHD_INT64, 1, static_cast<std::int64_t>(count), stepsOf<std::int64_t>(1), 0 };
}

} // namespace

JobRun::JobRun()
  : job_(ahd_job_new())
{
  note(job_ ? AHD_OK : AHD_OUT_OF_MEMORY);
}

JobRun::~JobRun()
{
  ahd_job_free(job_);
}

void JobRun::note(ahd_status status)
{
  if (status != AHD_OK && status_ == AHD_OK)
  {
    status_ = status;
    message_ = ahd_message(job_);
  }
}

void JobRun::setPoints(const PointView& points)
{
  const auto stride = static_cast<std::int64_t>(points.stride);
  ahd_array array = { points.doubles, AHD_FLOAT64, points.isFlat ? 2 : 3,
    static_cast<std::int64_t>(points.count), stepsOf<double>(stride), stepsOf<double>(1) };
  if (points.floats)
  {
    array.data = points.floats;
    array.type = AHD_FLOAT32;
    array.row_stride = stepsOf<float>(stride);
    array.column_stride = stepsOf<float>(1);
  }
  note(ahd_set_array(job_, "points", &array));
  const ahd_array marks = { points.skip, AHD_UINT8, 1, array.rows, 1, 1 };
  const bool canSkip = points.skip && points.skipMask != 0;
  note(ahd_set_array(job_, "skip", canSkip ? &marks : nullptr));
  set("skip_mask", std::int64_t(canSkip ? points.skipMask : 0xFF));
}

void JobRun::setConstraints(const ConstraintView& constraints)
{
  const std::int64_t* const offsets = constraints.offsets;
  const std::size_t lines = constraints.lines, chains = constraints.chains;
  const auto idsTo = [&](std::size_t chain)
  { return listOf(constraints.ids, static_cast<std::size_t>(offsets ? offsets[chain] : 0)); };
  const ahd_array lineIds = idsTo(lines), loopIds = idsTo(chains);
  const ahd_array lineOffsets = listOf(offsets, lines + 1);
  const ahd_array loopOffsets = listOf(offsets + lines, chains - lines + 1);
  note(ahd_set_array(job_, "line_ids", lines > 0 ? &lineIds : nullptr));
  note(ahd_set_array(job_, "line_offsets", lines > 0 ? &lineOffsets : nullptr));
  note(ahd_set_array(job_, "loop_ids", chains > lines ? &loopIds : nullptr));
  note(ahd_set_array(job_, "loop_offsets", chains > lines ? &loopOffsets : nullptr));
}

void JobRun::set(const char* name, std::int64_t value)
{
  note(ahd_set_int(job_, name, value));
}

void JobRun::set(const char* name, double value)
{
  note(ahd_set_double(job_, name, value));
}

std::int64_t JobRun::count(const char* name)
{
  std::int64_t value = -7;
  note(ahd_count(job_, name, &value));
  return value;
}

template <typename Number>
std::vector<Number> JobRun::read(const char* name, std::int32_t type)
{
  std::uint64_t rows = 0, columns = 0;
  note(ahd_array_size(job_, name, &rows, &columns));
  std::vector<Number> numbers(static_cast<std::size_t>(rows * columns), Number(77));
  const ahd_status status = ahd_get_array(job_, name, type, numbers.data(), numbers.size());
  note(status);
  return status == AHD_OK ? numbers : std::vector<Number>();
}

std::vector<std::int64_t> JobRun::ids(const char* name)
{
  return read<std::int64_t>(name, AHD_INT64);
}

std::vector<std::int32_t> JobRun::shortIds(const char* name)
{
  return read<std::int32_t>(name, AHD_INT32);
}

std::vector<double> JobRun::doubles(const char* name)
{
  return read<double>(name, AHD_FLOAT64);
}

std::vector<std::uint8_t> JobRun::bytes(const char* name)
{
  return read<std::uint8_t>(name, AHD_UINT8);
}

} // namespace test
} // namespace ahd
