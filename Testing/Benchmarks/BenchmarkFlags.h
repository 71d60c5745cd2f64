// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BenchmarkFlags_h
#define ahd_BenchmarkFlags_h

#include "Distributions.h"

#include <string>
#include <vector>

namespace ahd
{
namespace test
{

/// The requested measurements.
struct BenchmarkFlags
{
  std::vector<std::size_t> sizes = { 1000000 };
  std::vector<Distribution> distributions; ///< by default those of the paper and five harder ones

  /// The triangulators, and their clocks:
  ///   ours, cgal   by the CPU time of the thread
  ///   c            ours, through the C interface
  ///   float        ours, with coordinates of 32 bits
  ///   shuffled     ours, the points in random order
  ///   times<x>     ours, all coordinates times x
  ///   threads<n>   ours on n threads, by the time on the wall
  std::vector<std::string> engines = { "ours", "cgal" };

  int repeat = 3;    ///< measurements of each
  bool cold = false; ///< the first call of the process is measured, not one after it
};

/// Takes --sizes=1e6,4e6  --distributions=Uniform,Utm|paper|all  --engines=ours,cgal  --repeat=3
/// --cold  out of the command line and leaves the rest. Empty `error` means all was understood.
BenchmarkFlags takeFlags(int& argc, char** argv, std::string& error);

} // namespace test
} // namespace ahd

#endif
