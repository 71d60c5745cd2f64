// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ExactSum_h
#define ahd_ExactSum_h

#include <array>
#include <cstddef>

namespace ahd
{

/// A sum that does not depend on the order of its terms: each is cut into three parts on fixed
/// grids (of 2^-24, 2^-49, 2^-74), and the sum of the parts on one grid is exact. REQUIRES: at most
/// 2^28 terms of magnitude 1 at most (more only round).
class ExactSum
{
public:
  void add(double term)
  {
    // Adding and subtracting a large number leaves the term rounded to that number's last place.
    constexpr double kLarge[3] = { 0x1.8p28, 0x1.8p3, 0x1.8p-22 };
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double part = (term + kLarge[k]) - kLarge[k];
      parts_[k] += part;
      term -= part;
    }
  }

  void merge(const ExactSum& other)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      parts_[k] += other.parts_[k];
    }
  }

  double value() const { return parts_[0] + (parts_[1] + parts_[2]); }

private:
  std::array<double, 3> parts_ = { { 0, 0, 0 } };
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
