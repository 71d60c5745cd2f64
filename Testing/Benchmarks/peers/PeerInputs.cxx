// SPDX-License-Identifier: BSD-3-Clause
//
// PeerInputs NAME COUNT FILE: writes points of a distribution (Support/Points/Distributions.h) for
// peers.
#include "Distributions.h"
#include "PeerFiles.h"

#include <cstdio>
#include <cstdlib>
#include <string>

int main(int argc, char** argv)
{
  using namespace ahd::test;
  for (const Distribution distribution : allDistributions())
  {
    if (argc == 4 && std::string(argv[1]) == nameOf(distribution))
    {
      const auto count = std::size_t(std::strtod(argv[2], nullptr));
      writePoints(argv[3], makePoints(distribution, count, 1));
      return 0;
    }
  }
  std::fprintf(stderr, "PeerInputs NAME COUNT FILE\nNAME is one of");
  for (const Distribution distribution : allDistributions())
  {
    std::fprintf(stderr, " %s", nameOf(distribution));
  }
  std::fprintf(stderr, "\n");
  return 1;
}
