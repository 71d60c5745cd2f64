// SPDX-License-Identifier: BSD-3-Clause
#include "TileBytes.h"

#include <algorithm>
#include <cstring>

namespace ahd
{

namespace
{

constexpr std::uint64_t kMark = 0x4148445469333031; // "AHDTi301"

struct Head
{
  std::uint64_t mark, kind;
  Fingerprint plan;
  std::uint64_t part, size;

  auto fields() { return std::tie(mark, kind, plan, part, size); }
};
static_assert(IsSolid<Head>::value, "it is read where it lies");

/// Where the section of a leaf ends; the first begins behind all of these.
struct SectionEnd
{
  std::uint64_t leaf, end;
};

std::uint64_t numberAt(const unsigned char* bytes)
{
  std::uint64_t number;
  std::memcpy(&number, bytes, sizeof number);
  return number;
}

} // namespace

void beginBytes(TileKind kind, const TilePlan& plan, std::size_t part, BlockBytes& bytes)
{
  const Head head{ kMark, std::uint64_t(kind), plan.fingerprint(), part, 0 };
  BytesWriter{ bytes }(head);
}

void endBytes(BlockBytes& bytes)
{
  const std::uint64_t size = bytes.size();
  std::memcpy(bytes.data() + sizeof(Head) - sizeof size, &size, sizeof size);
}

TileView contentOf(TileKind kind, const TilePlan& plan, std::size_t part, const TileView& bytes)
{
  Head head{ 0, 0, {}, 0, 0 };
  BytesReader{ bytes.data, bytes.size }(head);
  const bool isIt = head.mark == kMark && head.kind == std::uint64_t(kind) &&
    head.plan == plan.fingerprint() && head.part == part && head.size == bytes.size;
  return isIt ? TileView{ bytes.data + sizeof(Head), bytes.size - sizeof(Head) }
              : TileView{ nullptr, 0 };
}

bool readOwn(const TilePlan& plan, std::size_t leaf, const TileView& bytes, TileOwn& own)
{
  own = TileOwn();
  const TileView content = contentOf(TileKind::Own, plan, leaf, bytes);
  constexpr std::size_t kNumber = sizeof(std::uint64_t);
  if (!content.data || content.size < kNumber)
  {
    return false;
  }
  const std::uint64_t numbers = numberAt(content.data);
  if (numbers % 3 != 0 || numbers > (content.size - kNumber) / sizeof(Index))
  {
    return false;
  }
  own.triples = content.data + kNumber;
  own.count = static_cast<std::size_t>(numbers / 3);
  const std::size_t end = kNumber + static_cast<std::size_t>(numbers) * sizeof(Index);
  BytesReader{ content.data + end, content.size - end }(own.pieces);
  return own.pieces.empty() || own.pieces.size() == own.count;
}

ShareWriter::ShareWriter(
  const TilePlan& plan, std::size_t node, const std::vector<Index>& leaves, BlockBytes& bytes)
  : bytes_(bytes)
{
  beginBytes(TileKind::Share, plan, node, bytes_);
  BytesWriter writer{ bytes_ };
  writer(std::uint64_t(leaves.size()));
  index_ = bytes_.size();
  for (const Index leaf : leaves)
  {
    writer(std::uint64_t(leaf), std::uint64_t(0));
  }
}

void ShareWriter::add(const TileSection& section)
{
  BytesWriter{ bytes_ }(section);
  const std::uint64_t end = bytes_.size();
  std::memcpy(bytes_.data() + index_ + sizeof end, &end, sizeof end);
  index_ += sizeof(SectionEnd);
}

namespace
{

/// Of so many entries at `index`, leaves ascending, the number of the first that is not before it.
std::size_t findEntry(const unsigned char* index, std::size_t count, std::size_t leaf)
{
  std::size_t begin = 0, end = count;
  while (begin < end)
  {
    const std::size_t middle = (begin + end) / 2;
    if (numberAt(index + middle * sizeof(SectionEnd)) < leaf)
    {
      begin = middle + 1;
    }
    else
    {
      end = middle;
    }
  }
  return begin;
}

} // namespace

bool readSection(const TilePlan& plan, std::size_t node, std::size_t leaf, const TileView& share,
  TileSection& section)
{
  section = TileSection();
  const TileView content = contentOf(TileKind::Share, plan, node, share);
  constexpr std::size_t kNumber = sizeof(std::uint64_t), kEntry = sizeof(SectionEnd);
  if (!content.data || content.size < kNumber ||
    numberAt(content.data) > (content.size - kNumber) / kEntry)
  {
    return false;
  }
  const std::size_t count = static_cast<std::size_t>(numberAt(content.data));
  const unsigned char* const index = content.data + kNumber;
  const std::size_t k = findEntry(index, count, leaf);
  if (k == count || numberAt(index + k * kEntry) != leaf)
  {
    return true;
  }
  const std::uint64_t first = sizeof(Head) + kNumber + count * kEntry;
  const std::uint64_t from = k == 0 ? first : numberAt(index + k * kEntry - kNumber);
  const std::uint64_t to = numberAt(index + k * kEntry + kNumber);
  if (from > to || to > share.size)
  {
    return false;
  }
  BytesReader{ share.data + from, static_cast<std::size_t>(to - from) }(section);
  const auto isIn = [&](const std::array<Index, 3>& c) {
    return std::max({ c[0], c[1], c[2] }) < section.points.size();
  };
  return section.flags.size() == section.corners.size() &&
    std::all_of(section.corners.begin(), section.corners.end(), isIn);
}

} // namespace ahd
