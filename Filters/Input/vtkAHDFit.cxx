// SPDX-License-Identifier: BSD-3-Clause
#include "Input/vtkAHDFit.h"

#include "Input/vtkAHDSum.h"
#include "Pipeline/vtkAHDLoop.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <mutex>

namespace
{
using Xyz = vtkAHDVector;
using Matrix = vtkAHDMatrix;

struct Box
{
  Xyz Low = { { DBL_MAX, DBL_MAX, DBL_MAX } };
  Xyz High = { { -DBL_MAX, -DBL_MAX, -DBL_MAX } };
  double Count = 0.0;

  void Merge(const Box& other)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->Low[k] = std::min(this->Low[k], other.Low[k]);
      this->High[k] = std::max(this->High[k], other.High[k]);
    }
    this->Count += other.Count;
  }
};

struct Reach : Xyz
{
  Reach() { this->fill(0.0); }
  void Merge(const Reach& other)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      (*this)[k] = std::max((*this)[k], other[k]);
    }
  }
};

/// 2^e or, where that is no double, the closest power of two that is.
double PowerOfTwo(int e)
{
  return std::ldexp(1.0, std::max(-1022, std::min(e, 1023)));
}

/// Turns columns p and q of `vectors` so that element p, q of `a` becomes zero: one step of
/// Jacobi's method. REQUIRES: the element is not zero.
void Rotate(Matrix& a, Matrix& vectors, std::size_t p, std::size_t q)
{
  const double theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
  const double t = (theta < 0 ? -1.0 : 1.0) / (std::fabs(theta) + std::sqrt(theta * theta + 1.0));
  const double c = 1.0 / std::sqrt(t * t + 1.0);
  const double s = t * c;
  const std::size_t r = 3 - p - q;
  a[p][p] -= t * a[p][q];
  a[q][q] += t * a[p][q];
  a[p][q] = a[q][p] = 0.0;
  const double rp = a[r][p];
  const double rq = a[r][q];
  a[r][p] = a[p][r] = c * rp - s * rq;
  a[r][q] = a[q][r] = s * rp + c * rq;
  for (Xyz& row : vectors)
  {
    const double vp = row[p];
    const double vq = row[q];
    row[p] = c * vp - s * vq;
    row[q] = s * vp + c * vq;
  }
}

/// The eigenvectors, as columns, of a symmetric matrix with no negative eigenvalue; its diagonal
/// becomes the eigenvalues. Small eigenvalues are as exact as large ones where the elements allow
/// it, as an element counts as zero only in comparison with its own two diagonal elements.
Matrix FindEigenvectors(Matrix& a)
{
  Matrix vectors = { { vtkAHDUnitAxis(0), vtkAHDUnitAxis(1), vtkAHDUnitAxis(2) } };
  constexpr int kMostSweeps = 50; // 5 to 8 do
  for (int sweep = 0; sweep < kMostSweeps; ++sweep)
  {
    bool turned = false;
    for (std::size_t r = 0; r < 3; ++r)
    {
      const std::size_t p = r == 0 ? 1 : 0;
      const std::size_t q = r == 2 ? 1 : 2;
      const double both = std::sqrt(std::fabs(a[p][p])) * std::sqrt(std::fabs(a[q][q]));
      if (std::fabs(a[p][q]) > 0x1p-54 * both)
      {
        Rotate(a, vectors, p, q);
        turned = true;
      }
    }
    if (!turned)
    {
      break;
    }
  }
  return vectors;
}

/// One call of vtkAHDFit::Run().
class Fitting
{
public:
  Fitting(const ahd::PointView& points, ahd::Executor& executor, vtkAHDProgress& progress)
    : Points(points)
    , Executor(executor)
    , Progress(progress)
  {
  }

  bool Run(vtkAHDFit& fit);

private:
  template <typename Part, typename Visit>
  bool Gather(Part& total, const Visit& visit);
  bool FindBox();
  void ChooseOrigin();
  bool FindMean();
  bool FindSpread(const Matrix& axes, Matrix& spread);
  bool FindReach(const Matrix& axes, Reach& reach);
  Xyz ChooseNormal(const Matrix& axes, const Matrix& spread) const;
  Xyz FromMean(const Xyz& p) const;
  double Largest() const;

  const ahd::PointView& Points;
  ahd::Executor& Executor;
  vtkAHDProgress& Progress;
  Box Around;
  Xyz Origin = { { 0, 0, 0 } };
  Xyz Mean = { { 0, 0, 0 } };   // from the origin, scaled
  double Factors[2] = { 1, 1 }; // their product scales the points to 1/32 of a unit at most
};

/// Calls visit(part, p) for all points that count, and merges the parts into the total.
template <typename Part, typename Visit>
bool Fitting::Gather(Part& total, const Visit& visit)
{
  std::mutex mutex;
  return vtkAHDLoop(this->Points.count, this->Executor, this->Progress,
    [&](std::size_t begin, std::size_t end)
    {
      Part part;
      for (std::size_t i = begin; i < end; ++i)
      {
        Xyz p;
        for (std::size_t k = 0; k < 3; ++k)
        {
          p[k] = this->Points.doubles ? this->Points.doubles[3 * i + k]
                                      : double(this->Points.floats[3 * i + k]);
        }
        if (p[0] * 0 + p[1] * 0 + p[2] * 0 == 0 && !this->Points.skipped(i))
        {
          visit(part, p);
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      total.Merge(part);
    });
}

bool Fitting::FindBox()
{
  return this->Gather(this->Around,
    [](Box& box, const Xyz& p)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        box.Low[k] = std::min(box.Low[k], p[k]);
        box.High[k] = std::max(box.High[k], p[k]);
      }
      box.Count += 1.0;
    });
}

/// The largest magnitude of a coordinate.
double Fitting::Largest() const
{
  double largest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    largest = std::max({ largest, -this->Around.Low[k], this->Around.High[k] });
  }
  return largest;
}

/// p - origin is exact for all points: where the origin is not zero, all p are three times as large
/// as they are apart, so the difference has no digit before the first or behind the last of p.
void Fitting::ChooseOrigin()
{
  int exponent = std::numeric_limits<int>::min();
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double low = this->Around.Low[k] / 2;
    const double high = this->Around.High[k] / 2;
    const double centre = low + high;
    int e = 0;
    std::frexp(high - low, &e); // half the extent is below 2^e
    if (high == low)
    {
      this->Origin[k] = this->Around.Low[k];
      continue;
    }
    if (std::fabs(centre) >= 8 * (high - low))
    {
      this->Origin[k] = std::ldexp(std::nearbyint(std::ldexp(centre, -e - 1)), e + 1);
    }
    exponent = std::max(exponent, e + 1); // the extent is below 2^exponent
  }
  exponent = exponent == std::numeric_limits<int>::min() ? 0 : exponent + 5;
  this->Factors[0] = PowerOfTwo(-exponent / 2);
  this->Factors[1] = PowerOfTwo(-exponent - -exponent / 2);
}

/// Where a point lies from the mean, scaled.
Xyz Fitting::FromMean(const Xyz& p) const
{
  Xyz d;
  for (std::size_t k = 0; k < 3; ++k)
  {
    // scaled by half before and by half behind, so that huge numbers stay finite
    d[k] = (p[k] * this->Factors[0] - this->Origin[k] * this->Factors[0]) * this->Factors[1] -
      this->Mean[k];
  }
  return d;
}

bool Fitting::FindMean()
{
  vtkAHDSums<3> sums;
  const bool all = this->Gather(sums,
    [this](vtkAHDSums<3>& part, const Xyz& p)
    {
      const Xyz d = this->FromMean(p); // from the origin: there is no mean yet
      for (std::size_t k = 0; k < 3; ++k)
      {
        part[k].Add(d[k]);
      }
    });
  for (std::size_t k = 0; k < 3; ++k)
  {
    this->Mean[k] = sums[k].Get() / this->Around.Count;
  }
  return all;
}

/// How far the points reach from the mean along each axis.
bool Fitting::FindReach(const Matrix& axes, Reach& reach)
{
  return this->Gather(reach,
    [this, &axes](Reach& part, const Xyz& p)
    {
      const Xyz d = this->FromMean(p);
      for (std::size_t k = 0; k < 3; ++k)
      {
        part[k] = std::max(part[k], std::fabs(vtkAHDDot(axes[k], d)));
      }
    });
}

/// The covariance of the points in the system of these axes. Its small elements are as exact as its
/// large ones, as far as the coordinates are.
bool Fitting::FindSpread(const Matrix& axes, Matrix& spread)
{
  Reach reach;
  if (!this->FindReach(axes, reach))
  {
    return false;
  }
  Xyz factor;
  for (std::size_t k = 0; k < 3; ++k)
  {
    int e = 0;
    std::frexp(reach[k], &e);
    factor[k] = PowerOfTwo(std::min(-e, 1000));
  }
  vtkAHDSums<9> sums; // products of the pairs 00, 01, 02, 11, 12, 22, then the three themselves
  const bool all = this->Gather(sums,
    [&](vtkAHDSums<9>& part, const Xyz& p)
    {
      const Xyz d = this->FromMean(p);
      Xyz x;
      for (std::size_t k = 0; k < 3; ++k)
      {
        x[k] = vtkAHDDot(axes[k], d) * factor[k];
        part[6 + k].Add(x[k]);
      }
      std::size_t pair = 0;
      for (std::size_t i = 0; i < 3; ++i)
      {
        for (std::size_t j = i; j < 3; ++j)
        {
          part[pair++].Add(x[i] * x[j]);
        }
      }
    });
  const double n = this->Around.Count;
  std::size_t pair = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = i; j < 3; ++j)
    {
      const double mean = sums[pair++].Get() / n -
        (sums[6 + i].Get() / n) * (sums[6 + j].Get() / n);
      spread[i][j] = spread[j][i] = mean / factor[i] / factor[j];
    }
  }
  return all;
}

Xyz Fitting::ChooseNormal(const Matrix& axes, const Matrix& spread) const
{
  std::array<std::size_t, 3> by = { { 0, 1, 2 } }; // decreasing spread
  std::stable_sort(by.begin(), by.end(),
    [&](std::size_t i, std::size_t j) { return spread[i][i] > spread[j][j]; });
  if (spread[by[0]][by[0]] <= 0)
  {
    return vtkAHDUnitAxis(2);
  }
  // A width that the rounding of the coordinates alone would make is none.
  const double precision = this->Points.doubles ? DBL_EPSILON : double(FLT_EPSILON);
  const double rounding = 2 * (this->Largest() * this->Factors[0]) * this->Factors[1] * precision;
  if (std::sqrt(std::max(0.0, spread[by[1]][by[1]])) <= rounding + 0x1p-50)
  {
    const Xyz& line = axes[by[0]];
    const bool isSteep = std::fabs(line[2]) >
      1.000001 * std::max(std::fabs(line[0]), std::fabs(line[1]));
    return vtkAHDPerpendicular(vtkAHDUnitAxis(isSteep ? 1 : 2), line);
  }
  return axes[by[2]];
}

bool Fitting::Run(vtkAHDFit& fit)
{
  if (!this->FindBox() || this->Around.Count == 0)
  {
    return this->Around.Count == 0 && !this->Progress.MustAbort();
  }
  this->ChooseOrigin();
  if (!this->FindMean())
  {
    return false;
  }
  // Twice: in the system that the first round finds, the second sees small differences beside large
  // ones, as of a thin band.
  Matrix spread;
  Matrix axes = { { vtkAHDUnitAxis(0), vtkAHDUnitAxis(1), vtkAHDUnitAxis(2) } };
  for (int round = 0; round < 2; ++round)
  {
    if (!this->FindSpread(axes, spread))
    {
      return false;
    }
    const Matrix vectors = FindEigenvectors(spread);
    Matrix turned;
    for (std::size_t k = 0; k < 3; ++k)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        turned[k][i] = vectors[0][k] * axes[0][i] + vectors[1][k] * axes[1][i] +
          vectors[2][k] * axes[2][i];
      }
    }
    axes = turned;
  }
  fit.Normal = this->ChooseNormal(axes, spread);
  fit.Origin = this->Origin;
  fit.Height = vtkAHDDot(fit.Normal, this->Mean) / this->Factors[0] / this->Factors[1];
  fit.Shrink = this->Largest() > 0x1p1000 ? 0x1p-32 : 1.0;
  return true;
}
}

bool vtkAHDFit::Run(const ahd::PointView& points, ahd::Executor& executor, vtkAHDProgress& progress)
{
  *this = vtkAHDFit();
  return Fitting(points, executor, progress).Run(*this);
}
