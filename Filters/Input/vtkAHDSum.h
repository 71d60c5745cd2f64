// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSum_h
#define vtkAHDSum_h

#include <array>
#include <cstddef>

/// A sum that does not depend on the order of its terms: each is cut into three parts on fixed
/// grids (of 2^-24, 2^-49, 2^-74), and the sum of the parts on one grid is exact. REQUIRES: at most
/// 2^28 terms of magnitude 1 at most (more only round).
class vtkAHDSum
{
public:
  void Add(double term)
  {
    // Adding and subtracting a large number leaves the term rounded to that number's last place.
    constexpr double kLarge[3] = { 0x1.8p28, 0x1.8p3, 0x1.8p-22 };
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double part = (term + kLarge[k]) - kLarge[k];
      this->Parts[k] += part;
      term -= part;
    }
  }

  void Merge(const vtkAHDSum& other)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->Parts[k] += other.Parts[k];
    }
  }

  double Get() const { return this->Parts[0] + (this->Parts[1] + this->Parts[2]); }

private:
  std::array<double, 3> Parts = { { 0, 0, 0 } };
};

/// N of them.
template <std::size_t N>
struct vtkAHDSums : std::array<vtkAHDSum, N>
{
  void Merge(const vtkAHDSums& other)
  {
    for (std::size_t k = 0; k < N; ++k)
    {
      (*this)[k].Merge(other[k]);
    }
  }
};

#endif
