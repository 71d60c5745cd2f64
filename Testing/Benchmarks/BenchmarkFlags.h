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

/// What the benchmark was asked to measure.
struct BenchmarkFlags
{
  std::vector<std::size_t> sizes = { 1000000 };
  std::vector<Distribution> distributions; ///< by default those of the paper and five harder ones
  bool ours = true;
  bool cgal = true;
  int repeat = 3; ///< runs of each; the fastest counts, as whatever disturbs a run only slows it
};

/// Takes --sizes=1e6,4e6  --distributions=Uniform,Utm|paper|all  --engines=ours,cgal  --repeat=3
/// out of the command line and leaves the rest. Empty `error` means all was understood.
BenchmarkFlags takeFlags(int& argc, char** argv, std::string& error);

} // namespace test
} // namespace ahd

#endif
