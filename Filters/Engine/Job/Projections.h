// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_JobProjections_h
#define ahd_JobProjections_h

#include "../Prepare/Prepare.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace ahd
{

/// PlaneKind::Matrix: a matrix of 4 x 4 numbers, row by row, is applied to (x, y, z, 1).
class MatrixProjection : public Projection
{
public:
  explicit MatrixProjection(const std::array<double, 16>& matrix)
    : matrix_(matrix)
  {
  }
  bool project(const PointView& points, double* to, const Context& context) const override;

private:
  std::array<double, 16> matrix_;
};

/// Moves points, (x, y, z) each, in place. Non-zero cancels.
using ProjectionCallback = std::int32_t (*)(void* user, double* xyz, std::uint64_t count);

/// PlaneKind::Callback.
class CallbackProjection : public Projection
{
public:
  CallbackProjection(ProjectionCallback callback, void* user)
    : callback_(callback)
    , user_(user)
  {
  }
  bool project(const PointView& points, double* to, const Context& context) const override;

private:
  bool call(double* xyz, std::size_t count) const;

  ProjectionCallback callback_;
  void* user_;
};

} // namespace ahd

#endif
