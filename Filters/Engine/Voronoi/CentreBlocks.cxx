// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled twice: see CentreBlocksAvx2.cxx.
#include "CentreBlocks.h"

#include "../Arithmetic/DoubleDouble.h"
#include "Circumcentre.h"

#include <algorithm>
#include <cmath>

namespace ahd
{
inline namespace AHD_TARGET
{
namespace
{

constexpr std::size_t kBlock = 32;
constexpr double kMostCondition = 0x1p20;

/// Data of some triangles at once: each coordinate in its own row, so that the compiler handles
/// several triangles with one instruction.
struct Block
{
  double ax[kBlock], ay[kBlock], bx[kBlock], by[kBlock], cx[kBlock], cy[kBlock];
  double x[kBlock], y[kBlock]; ///< the centres
  double doubt[kBlock];        ///< 0 where these are certain, if the condition is no more than
  double condition[kBlock];    ///< kMostCondition
};

inline DoubleDouble productOf(double a, double b)
{
#ifdef AHD_FUSED_MULTIPLY_ADD
  const double high = a * b;
  return { high, std::fma(a, b, -high) };
#else
  return exactProduct(a, b);
#endif
}

/// The sum of two exact products.
inline DoubleDouble sumOf(const DoubleDouble& a, const DoubleDouble& b)
{
  const DoubleDouble high = exactSum(a.high, b.high);
  return { high.high, high.low + (a.low + b.low) };
}

inline DoubleDouble timesOf(const DoubleDouble& a, double b)
{
  const DoubleDouble high = productOf(a.high, b);
  return { high.high, high.low + a.low * b };
}

/// origin + quotient, rounded; `doubt` grows where it is not certain. `over` / (2 `half`) is the
/// quotient, `size` that of the terms of `over`, `halfSize` of those of `half`, `inverse` the
/// rounded 1 / (2 half.high).
struct Division
{
  DoubleDouble half;
  double halfSize;
  double inverse;
  double condition; ///< halfSize |inverse|

  double addedTo(double origin, const DoubleDouble& over, double size, double& doubt) const
  {
    const double most = over.high * inverse;
    const DoubleDouble back = productOf(most, 2.0 * half.high);
    const double rest = ((over.high - back.high) - back.low) + (over.low - most * (2.0 * half.low));
    const DoubleDouble sum = exactSum(origin, most);
    const double low = sum.low + rest * inverse;
    const double error = 0x1p-80 * condition * std::fabs(inverse) *
        (size + halfSize * std::fabs(most)) +
      0x1p-90 * std::fabs(sum.high);
    const double result = sum.high + (low - error);
    doubt += std::fabs((sum.high + (low + error)) - result);
    return result;
  }
};

/// Proof. Let e = 2^-53. Nothing overflows or underflows, as the coordinates are modest and their
/// differences multiples of 2^-112; where these are not exact, there is doubt. Then the products of
/// two are exact; uu, vv and half are wrong by 3 e^2 of the sizes of their terms, and their low
/// parts at most 2.1 e of these; products with a third by 9 e^2, and the two terms of `over`
/// together by 16 e^2 of `size`. The first quotient is wrong by 3 e of itself; what it leaves is
/// known to 15 e^2 size + 13 e^2 halfSize |most|, and is itself less than 8 e of both. Dividing it
/// by half.high alone, which is wrong by 4.1 e condition, and rounding that, adds at most
/// e^2 condition (64 size + 36 halfSize |most|), times the inverse. As `condition` is at least
/// 0.49 and at most 2^20, all is less than 2^-98 condition |inverse| (size + halfSize |most|); and
/// where circumcentre() adds with 100 bits, its error is less than 2^-96 of the same and 2^-100 of
/// the sum. Centres that are certain here therefore equal those that it finds.
inline void computeBlock(Block& b)
{
  for (std::size_t i = 0; i < kBlock; ++i)
  {
    const DoubleDouble ux = exactDifference(b.bx[i], b.ax[i]);
    const DoubleDouble uy = exactDifference(b.by[i], b.ay[i]);
    const DoubleDouble vx = exactDifference(b.cx[i], b.ax[i]);
    const DoubleDouble vy = exactDifference(b.cy[i], b.ay[i]);
    const DoubleDouble first = productOf(ux.high, vy.high), second = productOf(uy.high, vx.high);
    const DoubleDouble uu = sumOf(productOf(ux.high, ux.high), productOf(uy.high, uy.high));
    const DoubleDouble vv = sumOf(productOf(vx.high, vx.high), productOf(vy.high, vy.high));
    const DoubleDouble half = sumOf(first, -second);
    const double halfSize = std::fabs(first.high) + std::fabs(second.high);
    const double inverse = 0.5 / half.high;
    const Division division{ half, halfSize, inverse, halfSize * std::fabs(inverse) };
    const DoubleDouble xPlus = timesOf(uu, vy.high), xMinus = timesOf(vv, uy.high);
    const DoubleDouble yPlus = timesOf(vv, ux.high), yMinus = timesOf(uu, vx.high);
    double doubt = std::fabs(ux.low) + std::fabs(uy.low) + std::fabs(vx.low) + std::fabs(vy.low);
    b.x[i] = division.addedTo(
      b.ax[i], sumOf(xPlus, -xMinus), std::fabs(xPlus.high) + std::fabs(xMinus.high), doubt);
    b.y[i] = division.addedTo(
      b.ay[i], sumOf(yPlus, -yMinus), std::fabs(yPlus.high) + std::fabs(yMinus.high), doubt);
    b.doubt[i] = doubt;
    b.condition[i] = division.condition;
  }
}

} // namespace

void circumcentresHere(
  const Index* vertices, const Point* places, std::size_t count, Point* centres)
{
  Block b;
  for (std::size_t k = 0; k < count; k += kBlock)
  {
    const std::size_t n = std::min(kBlock, count - k);
    for (std::size_t i = 0; i < kBlock; ++i)
    {
      const Index* const v = vertices + 3 * (k + std::min(i, n - 1));
      b.ax[i] = places[v[0]].x;
      b.ay[i] = places[v[0]].y;
      b.bx[i] = places[v[1]].x;
      b.by[i] = places[v[1]].y;
      b.cx[i] = places[v[2]].x;
      b.cy[i] = places[v[2]].y;
    }
    computeBlock(b);
    for (std::size_t i = 0; i < n; ++i)
    {
      const Index* const v = vertices + 3 * (k + i);
      centres[k + i] = b.doubt[i] == 0.0 && b.condition[i] <= kMostCondition
        ? Point{ b.x[i], b.y[i] }
        : circumcentre({ places[v[0]], places[v[1]], places[v[2]] });
    }
  }
}

} // namespace AHD_TARGET
} // namespace ahd
