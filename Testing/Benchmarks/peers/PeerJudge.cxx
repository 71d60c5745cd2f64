// SPDX-License-Identifier: BSD-3-Clause
//
// PeerJudge POINTS TRIANGLES [VERTICES]: prints the verdict (TriangleJudge.h) as JSON. The files
// are those of PeerFiles.h; triangles are in ids of the points or, where given, of the vertices.
#include "PeerFiles.h"
#include "TriangleJudge.h"

#include <cstdio>

int main(int argc, char** argv)
{
  using namespace ahd::test;
  if (argc != 3 && argc != 4)
  {
    std::fprintf(stderr, "PeerJudge POINTS TRIANGLES [VERTICES]\n");
    return 1;
  }
  const std::vector<ahd::Point> points = readPoints(argv[1]);
  const std::vector<std::int32_t> triples = readTriples(argv[2]);
  const Verdict verdict = argc == 3 ? judge(points, triples)
                                    : judge(points, readPoints(argv[3]), triples);
  std::printf("%s\n", verdict.json().c_str());
  return 0;
}
