// SPDX-License-Identifier: BSD-3-Clause
#include "TileBytes.h"

#include <algorithm>
#include <cstring>

namespace ahd
{

namespace
{

constexpr std::uint64_t kMark = 0x4148445469333032;          // "AHDTi302"
constexpr std::uint64_t kKindOfSection = 0x4148445365637469; // "AHDSecti"; the leaf is added

struct Head
{
  std::uint64_t mark, kind;
  Fingerprint plan;
  std::uint64_t part, size;
  Fingerprint content; ///< of a share that of its constraints; each section has one

  auto fields() { return std::tie(mark, kind, plan, part, size, content); }
};
static_assert(IsSolid<Head>::value, "it is read where it lies");

/// Of a share, behind its constraints, for each leaf of the node: where its section ends, and its
/// fingerprint. The first begins behind all of these.
struct SectionEnd
{
  std::uint64_t end;
  Fingerprint content;

  auto fields() { return std::tie(end, content); }
};
static_assert(IsSolid<SectionEnd>::value, "it is read where it lies");

/// What is checked whenever the bytes are read.
Fingerprint contentFingerprint(TileKind kind, TileView content)
{
  content.size = std::min(
    content.size, kind == TileKind::Share ? sizeof(TileConstraints) : content.size);
  return fingerprintOf(content, std::uint64_t(kind));
}

/// Where the ends of the sections of a share are.
constexpr std::size_t kSectionEnds = sizeof(Head) + sizeof(TileConstraints);

} // namespace

void beginBytes(TileKind kind, const TilePlan& plan, std::size_t part, BlockBytes& bytes)
{
  BytesWriter{ bytes }(Head{ kMark, std::uint64_t(kind), plan.fingerprint(), part, 0, {} });
}

void endBytes(BlockBytes& bytes)
{
  Head head;
  BytesReader{ bytes }(head);
  head.size = bytes.size();
  head.content = contentFingerprint(
    TileKind(head.kind), { bytes.data() + sizeof(Head), bytes.size() - sizeof(Head) });
  std::memcpy(bytes.data(), &head, sizeof head);
}

TileView contentOf(TileKind kind, const TilePlan& plan, std::size_t part, const TileView& bytes)
{
  Head head{ 0, 0, {}, 0, 0, {} };
  BytesReader{ bytes.data, bytes.size }(head);
  if (head.mark != kMark || head.kind != std::uint64_t(kind) || head.plan != plan.fingerprint() ||
    head.part != part || head.size != bytes.size)
  {
    return { nullptr, 0 };
  }
  const TileView content{ bytes.data + sizeof(Head), bytes.size - sizeof(Head) };
  return head.content == contentFingerprint(kind, content) ? content : TileView{ nullptr, 0 };
}

bool readOwn(const TilePlan& plan, std::size_t leaf, const TileView& bytes, TileOwn& own)
{
  own = TileOwn();
  const TileView content = contentOf(TileKind::Own, plan, leaf, bytes);
  if (!content.data)
  {
    return false;
  }
  std::uint64_t numbers = 0;
  BytesReader{ content.data, content.size }(numbers);
  own.triples = content.data + sizeof numbers;
  own.count = static_cast<std::size_t>(numbers / 3);
  const std::size_t end = sizeof numbers + static_cast<std::size_t>(numbers) * sizeof(Index);
  BytesReader{ content.data + end, content.size - end }(own.pieces);
  return true;
}

TileConstraints constraintsOf(const ConstraintReport& report)
{
  const std::size_t counts[] = { report.segments, report.points, report.withoutVertex,
    report.crossing, report.unfilledLoops, report.edges };
  TileConstraints made;
  std::transform(std::begin(counts), std::end(counts), made.begin(),
    [](std::size_t count) { return static_cast<std::int64_t>(count); });
  return made;
}

ShareWriter::ShareWriter(
  const TilePlan& plan, std::size_t node, const TileConstraints& constraints, BlockBytes& bytes)
  : bytes_(bytes)
  , leaf_(plan.rowOf(node).begin)
{
  beginBytes(TileKind::Share, plan, node, bytes_);
  BytesWriter{ bytes_ }(constraints);
  index_ = bytes_.size();
  bytes_.resize(index_ + (plan.rowOf(node).end - leaf_) * sizeof(SectionEnd));
}

void ShareWriter::add(const TileSection& section)
{
  const std::size_t begin = bytes_.size();
  BytesWriter{ bytes_ }(section);
  const TileView written{ bytes_.data() + begin, bytes_.size() - begin };
  const SectionEnd end{ bytes_.size(), fingerprintOf(written, kKindOfSection + leaf_) };
  std::memcpy(bytes_.data() + index_, &end, sizeof end);
  index_ += sizeof end;
  ++leaf_;
}

bool readSection(const TilePlan& plan, std::size_t node, std::size_t leaf, const TileView& share,
  TileSection& section)
{
  section = TileSection();
  const BlockRow& row = plan.rowOf(node);
  const std::size_t first = kSectionEnds + (row.end - row.begin) * sizeof(SectionEnd);
  if (!contentOf(TileKind::Share, plan, node, share).data || share.size < first)
  {
    return false;
  }
  SectionEnd ends[2] = { { first, {} }, { 0, {} } }; // of the one before, too
  const std::size_t before = leaf == row.begin ? 0 : 1;
  std::memcpy(ends + 1 - before,
    share.data + kSectionEnds + (leaf - row.begin - before) * sizeof(SectionEnd),
    (1 + before) * sizeof(SectionEnd));
  if (ends[0].end > ends[1].end || ends[1].end > share.size)
  {
    return false;
  }
  const TileView found{ share.data + ends[0].end,
    static_cast<std::size_t>(ends[1].end - ends[0].end) };
  BytesReader{ found.data, found.size }(section);
  return fingerprintOf(found, kKindOfSection + leaf) == ends[1].content;
}

bool readConstraints(
  const TilePlan& plan, std::size_t node, const TileView& share, TileConstraints& constraints)
{
  const TileView content = contentOf(TileKind::Share, plan, node, share);
  const bool isThere = content.data && content.size >= sizeof constraints;
  if (isThere)
  {
    std::memcpy(constraints.data(), content.data, sizeof constraints);
  }
  return isThere;
}

} // namespace ahd
