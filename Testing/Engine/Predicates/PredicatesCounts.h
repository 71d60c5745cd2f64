// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_test_PredicatesCounts_h
#define ahd_test_PredicatesCounts_h

#include "PredicatesExtremes.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>

/// Counts of answers, by stage.
namespace ahd::test
{

/// The filters whose border is searched for.
enum Border
{
  OrientBorder,
  InCircleBorder,
  FlatnessBorder,
  KernelOrientBorder,
  KernelInCircleBorder,
  Borders
};

/// How often it happened. A stage is 0 filter, 1 grid, 2 unbounded; a sign is counted at sign + 1.
struct Counts
{
  std::uint64_t orient[kExtremes][3][3] = {};
  std::uint64_t inCircle[kExtremes][3][3] = {};
  std::uint64_t flatness[kExtremes][3][3] = {};
  std::uint64_t ties[4][2] = {};      ///< by the largest point, by the answer
  std::uint64_t conflicts[2] = {};    ///< other than ties
  std::uint64_t kernelOrient[2] = {}; ///< uncertain, certain
  std::uint64_t kernelInCircle[2] = {};
  std::uint64_t less[2] = {};
  std::uint64_t borders[Borders] = {};

  void add(const Counts& other)
  {
    static_assert(sizeof(Counts) % sizeof(std::uint64_t) == 0, "numbers only");
    auto* to = reinterpret_cast<std::uint64_t*>(this);
    const auto* from = reinterpret_cast<const std::uint64_t*>(&other);
    for (std::size_t i = 0; i < sizeof(Counts) / sizeof(std::uint64_t); ++i)
    {
      to[i] += from[i];
    }
  }
};

template <std::size_t N>
std::uint64_t sumOf(const std::uint64_t (&counts)[N])
{
  std::uint64_t sum = 0;
  for (const std::uint64_t count : counts)
  {
    sum += count;
  }
  return sum;
}

template <std::size_t N, std::size_t M>
std::uint64_t sumOf(const std::uint64_t (&counts)[N][M])
{
  std::uint64_t sum = 0;
  for (const auto& part : counts)
  {
    sum += sumOf(part);
  }
  return sum;
}

inline std::uint64_t casesOf(const Counts& counts)
{
  std::uint64_t cases = sumOf(counts.ties) + sumOf(counts.conflicts) + sumOf(counts.kernelOrient) +
    sumOf(counts.kernelInCircle) + sumOf(counts.less);
  for (std::size_t i = 0; i < kExtremes; ++i)
  {
    cases += sumOf(counts.orient[i]) + sumOf(counts.inCircle[i]) + sumOf(counts.flatness[i]);
  }
  return cases;
}

inline void printStages(const char* name, const std::uint64_t (&counts)[kExtremes][3][3])
{
  std::printf("%-12s %11s %11s | %11s %11s %11s | %11s %11s %11s\n", name, "filter -", "+",
    "grid -", "0", "+", "unbounded -", "0", "+");
  for (std::size_t i = 0; i < kExtremes; ++i)
  {
    std::printf("%-12s", nameOf(static_cast<Extreme>(i)));
    for (int stage = 0; stage < 3; ++stage)
    {
      for (int sign = 0; sign < 3; ++sign)
      {
        if (stage > 0 || sign != 1)
        {
          std::printf(" %11llu", static_cast<unsigned long long>(counts[i][stage][sign]));
        }
      }
      std::printf(stage < 2 ? " |" : "\n");
    }
  }
}

template <std::size_t N>
void printRow(const char* name, const std::uint64_t (&counts)[N])
{
  std::printf("%-40s", name);
  for (const std::uint64_t count : counts)
  {
    std::printf(" %11llu", static_cast<unsigned long long>(count));
  }
  std::printf("\n");
}

inline void print(const Counts& counts)
{
  printStages("orient2d", counts.orient);
  printStages("inCircle", counts.inCircle);
  printStages("flatness", counts.flatness);
  static const char* const largest[] = { "a", "b", "c", "d" };
  for (std::size_t i = 0; i < 4; ++i)
  {
    printRow((std::string("ties, largest is ") + largest[i] + ": no, yes").c_str(), counts.ties[i]);
  }
  printRow("inConflict otherwise: no, yes", counts.conflicts);
  printRow("orientIsCertain: no, yes", counts.kernelOrient);
  printRow("inCircleIsCertain: no, yes", counts.kernelInCircle);
  printRow("lexicographicallyLess: no, yes", counts.less);
  printRow("borders: three stages, two of the kernel", counts.borders);
  std::printf("cases: %llu\n", static_cast<unsigned long long>(casesOf(counts)));
}

} // namespace ahd::test

#endif
