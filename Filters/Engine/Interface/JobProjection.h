// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_JobProjection_h
#define ahd_JobProjection_h

#include "../Prepare/Prepare.h"
#include "ahd.h"

#include <array>
#include <cstddef>

namespace ahd
{

/// AHD_PLANE_MATRIX: a matrix of 4 x 4 numbers, row by row, is applied to (x, y, z, 1).
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

/// AHD_PLANE_CALLBACK.
class CallbackProjection : public Projection
{
public:
  CallbackProjection(ahd_projection callback, void* user)
    : callback_(callback)
    , user_(user)
  {
  }
  bool project(const PointView& points, double* to, const Context& context) const override;

private:
  bool call(double* xyz, std::size_t count) const;

  ahd_projection callback_;
  void* user_;
};

} // namespace ahd

#endif
