// SPDX-License-Identifier: BSD-3-Clause
//
// Writes cases for the fuzz targets to begin with, made of the text files of a corpus:
//   FuzzSeeds <folder of the corpus> <folder to write to>
// Each file is written whole, and several times cut down, as small inputs are tried more often,
// with settings and chains that each occur in some.
#include "Corpus.h"
#include "FuzzCase.h"
#include "Moves.h"

#include <algorithm>
#include <cstdio>
#include <fstream>

namespace
{

using ahd::fuzz::Dice;
using ahd::fuzz::FuzzCase;

/// At most so many of the points, taken evenly.
FuzzCase caseOf(const ahd::test::CorpusFile& file, std::size_t most)
{
  FuzzCase result;
  const std::size_t count = file.points.size();
  const std::size_t kept = std::min(count, most);
  for (std::size_t i = 0; i < kept; ++i)
  {
    result.points.push_back(file.points[i * count / kept]);
  }
  return result;
}

/// Head and chains by chance; bytes that make a run fail, or copies, are zero mostly.
void decorate(FuzzCase& seed, Dice& dice)
{
  using namespace ahd::fuzz;
  for (const HeadByte byte :
    { kFirstSettings, kSecondSettings, kNmax, kExecutors, kLayout, kMergeDistance, kShuffle })
  {
    seed.head[byte] = std::uint8_t(dice.below(256));
  }
  seed.head[kLayout] &= dice.below(4) == 0 ? 0xFF : 0xFE; // floats lose the difficulty
  for (const HeadByte byte : { kSkipMarks, kLimit, kCancelAt, kFailAt, kMostBoxes, kRefusals })
  {
    seed.head[byte] = std::uint8_t(dice.below(4) == 0 ? 1 + dice.below(24) : 0);
  }
  seed.head[kSkipMask] = 3;
  for (int moves = 0; moves < 6; ++moves)
  {
    moveChains(seed, dice);
  }
}

bool write(const std::string& path, const ahd::fuzz::Bytes& bytes)
{
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  return out.good();
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 3)
  {
    std::fprintf(stderr, "FuzzSeeds <folder of the corpus> <folder to write to>\n");
    return 2;
  }
  const auto files = ahd::test::readCorpus(argv[1]);
  bool good = !files.empty();
  unsigned number = 0;
  for (const ahd::test::CorpusFile& file : files)
  {
    for (const std::size_t most : { ahd::fuzz::kMostGivenPoints, std::size_t(36), std::size_t(16),
           std::size_t(16), std::size_t(8) })
    {
      FuzzCase seed = caseOf(file, most);
      Dice dice(++number);
      decorate(seed, dice);
      const std::string path = std::string(argv[2]) + "/" + file.name + "." +
        std::to_string(number);
      good = write(path, seed.bytes()) && good;
    }
  }
  return good ? 0 : 1;
}
