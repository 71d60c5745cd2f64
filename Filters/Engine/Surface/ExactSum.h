// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ExactSum_h
#define ahd_ExactSum_h

#include "../Core/Dispatch.h"

#include <array>
#include <cstddef>

namespace ahd
{

/// So many terms are added at once: whole vectors of any length, and too many for compilers to
/// write the loops over them out before they make vectors of them.
constexpr std::size_t kSumLanes = 24;
using SumTerms = std::array<double, kSumLanes>;

/// Each lane's parts, on three grids.
using SumParts = std::array<SumTerms, 3>;

/// A sum that does not depend on the order of its terms: each is cut into three parts on fixed
/// grids (of 2^-24, 2^-49, 2^-74), and the sum of the parts on one grid is exact. @pre at most
/// 2^28 terms of magnitude 1 at most (more only round).
class ExactSum
{
public:
  AHD_ALWAYS_INLINE void add(const SumTerms& terms)
  {
    // Adding and subtracting a large number leaves the term rounded to that number's last place.
    constexpr double kLarge[3] = { 0x1.8p28, 0x1.8p3, 0x1.8p-22 };
    SumTerms rest = terms; // a copy: no pointer to it, so the loops are free of doubts
    for (std::size_t k = 0; k < 3; ++k)
    {
      double* const sums = parts_[k].data();
      const double large = kLarge[k];
      for (std::size_t lane = 0; lane < kSumLanes; ++lane)
      {
        const double part = (rest[lane] + large) - large;
        sums[lane] += part;
        rest[lane] -= part;
      }
    }
  }

  void merge(const ExactSum& other)
  {
    for (std::size_t k = 0; k < parts_.size(); ++k)
    {
      for (std::size_t lane = 0; lane < kSumLanes; ++lane)
      {
        parts_[k][lane] += other.parts_[k][lane];
      }
    }
  }

  double value() const
  {
    double sums[3] = { 0, 0, 0 };
    for (std::size_t k = 0; k < parts_.size(); ++k)
    {
      for (const double part : parts_[k])
      {
        sums[k] += part;
      }
    }
    return sums[0] + (sums[1] + sums[2]);
  }

private:
  SumParts parts_ = {};
};

/// N of them.
template <std::size_t N>
struct ExactSums : std::array<ExactSum, N>
{
  void merge(const ExactSums& other)
  {
    for (std::size_t k = 0; k < N; ++k)
    {
      (*this)[k].merge(other[k]);
    }
  }
};

} // namespace ahd

#endif
