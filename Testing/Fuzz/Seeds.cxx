// SPDX-License-Identifier: BSD-3-Clause
//
// Writes the text files of a corpus as cases for the fuzz targets, to begin with:
//   FuzzSeeds <folder of the corpus> <folder to write to>
// Each file is written once per order of insertion; of longer files some points are taken evenly,
// as small inputs are tried more often.
#include "Corpus.h"
#include "FuzzCase.h"

#include <algorithm>
#include <cstdio>
#include <fstream>

namespace
{

using ahd::fuzz::FuzzCase;

FuzzCase caseOf(const ahd::test::CorpusFile& file, std::size_t most)
{
  FuzzCase result;
  const std::size_t count = file.points.size();
  const std::size_t kept = std::min(count, most);
  for (std::size_t i = 0; i < kept; ++i)
  {
    result.points.push_back(file.points[i * count / kept]);
  }
  // a loop around some, a line through some
  for (std::size_t i = 0; i < 6; ++i)
  {
    result.chains.push_back(std::uint8_t(i * kept / 6));
  }
  result.chains.push_back(ahd::fuzz::kNewLine);
  for (std::size_t i = 0; i < 4; ++i)
  {
    result.chains.push_back(std::uint8_t((i * 37 + 5) % (kept + 1)));
  }
  return result;
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
  for (const ahd::test::CorpusFile& file : files)
  {
    for (std::uint8_t order = 0; order < 4; ++order)
    {
      FuzzCase seed = caseOf(file, order == 0 ? ahd::fuzz::kMostGivenPoints : 24);
      seed.head[ahd::fuzz::kFirstSettings] = std::uint8_t(order | 0xC0);
      seed.head[ahd::fuzz::kSecondSettings] = std::uint8_t(order ^ 1);
      seed.head[ahd::fuzz::kShuffle] = order;
      good = write(std::string(argv[2]) + "/" + file.name + "." + std::to_string(order),
               seed.bytes()) &&
        good;
    }
  }
  return good ? 0 : 1;
}
