// SPDX-License-Identifier: BSD-3-Clause
//
// Mutations by the meaning of the bytes, for libFuzzer to choose among: points exactly or nearly in
// positions that are hard for the predicates; chains that overlap, cross and nest.
#include "FuzzCase.h"
#include "Moves.h"

#include <algorithm>
#include <random>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace ahd
{
namespace fuzz
{
namespace
{

/// Copies are expensive: an input of the corpus rarely passes them on.
void dropCopies(FuzzCase& mutated, Dice& dice)
{
  if (mutated.head[kCopies] >= 240 && dice.below(24) != 0)
  {
    mutated.head[kCopies] = 0;
  }
}

std::size_t write(const FuzzCase& mutated, std::uint8_t* data, std::size_t most)
{
  const Bytes bytes = mutated.bytes();
  const std::size_t size = std::min(bytes.size(), most);
  std::copy(bytes.begin(), bytes.begin() + std::ptrdiff_t(size), data);
  return size;
}

/// Small inputs run more often per second, and find as many faults.
void shrink(FuzzCase& mutated, Dice& dice)
{
  constexpr std::size_t kMany = 40;
  const std::size_t count = mutated.points.size();
  if (count > kMany && dice.below(2) == 0)
  {
    const std::size_t kept = 3 + dice.below(kMany - 2);
    const std::size_t from = dice.below(count - kept + 1);
    mutated.points = std::vector<Point>(mutated.points.begin() + std::ptrdiff_t(from),
      mutated.points.begin() + std::ptrdiff_t(std::min(count, from + kept)));
  }
}

void mutateHead(FuzzCase& mutated, Dice& dice)
{
  const std::size_t byte = dice.below(kPoints);
  const bool isCopies = byte == kCopies && dice.below(8) != 0;
  const std::uint8_t any = std::uint8_t(dice.below(256));
  mutated.head[byte] = isCopies || dice.below(3) == 0 ? 0
    : dice.below(2) == 0                              ? std::uint8_t(any & any >> 3)
                                                      : any;
}

} // namespace
} // namespace fuzz
} // namespace ahd

extern "C" std::size_t LLVMFuzzerCustomMutator(
  std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed)
{
  using namespace ahd::fuzz;
  Dice dice(seed);
  if (size < kHeadBytes || dice.below(8) == 0)
  {
    size = LLVMFuzzerMutate(data, size, most);
    FuzzCase mutated = FuzzCase::fromBytes(data, size);
    dropCopies(mutated, dice);
    return size < kHeadBytes ? size : write(mutated, data, most);
  }
  FuzzCase mutated = FuzzCase::fromBytes(data, size);
  dropCopies(mutated, dice);
  shrink(mutated, dice);
  const std::size_t moves = std::size_t(1) << dice.below(4);
  for (std::size_t k = 0; k < moves; ++k)
  {
    switch (dice.below(8))
    {
      case 0:
        mutateHead(mutated, dice);
        break;
      case 1:
      case 2:
        moveChains(mutated, dice);
        break;
      default:
        movePoints(mutated, dice);
    }
  }
  return write(mutated, data, most);
}

/// Points of both, the chains of one.
extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* first, std::size_t firstSize,
  const std::uint8_t* second, std::size_t secondSize, std::uint8_t* out, std::size_t most,
  unsigned seed)
{
  using namespace ahd::fuzz;
  Dice dice(seed);
  FuzzCase result = FuzzCase::fromBytes(first, firstSize);
  const FuzzCase other = FuzzCase::fromBytes(second, secondSize);
  dropCopies(result, dice);
  if (!other.points.empty())
  {
    const std::size_t from = dice.below(other.points.size());
    const std::size_t count = std::min(1 + dice.below(other.points.size() - from),
      kMostGivenPoints - std::min(kMostGivenPoints, result.points.size()));
    result.points.insert(result.points.end(), other.points.begin() + std::ptrdiff_t(from),
      other.points.begin() + std::ptrdiff_t(from + count));
  }
  if (dice.below(2) == 0)
  {
    result.chains = other.chains;
  }
  return write(result, out, most);
}
