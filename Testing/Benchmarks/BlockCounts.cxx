// SPDX-License-Identifier: BSD-3-Clause
//
// The cost of one triangulation over very many blocks beyond the blocks' own: counted, and timed on
// this thread alone. Uniform points are drawn in the boxes of the blocks, block after block; only
// the border of each is kept, so 4,096 blocks of a million fit into a few gigabytes.
//   BlockCounts [--blocks=2,8,64,512,4096] [--points=1e6] [--write=FILE.md]
//   BlockCounts --check    few points: the same counts as the engine's BlockTriangulation
#include "BlockTree.h"
#include "Distribute/BlockTriangulation.h"

#include <fstream>
#include <iomanip>
#include <sstream>
#include <string>

namespace
{

using namespace ahd;
using namespace ahd::test;

/// All blocks in this process by BlockTriangulation.
class Beside
{
public:
  explicit Beside(const Boxes& boxes)
    : boxes_(boxes)
    , points_(boxes.blocks())
    , ids_(boxes.blocks())
    , blocks_(boxes.blocks())
  {
  }

  /// Exits if its counts differ.
  void compare(const Counts& counts)
  {
    using Waiting = BlockTriangulation::Waiting;
    for (std::size_t b = 0; b != blocks_.size(); ++b)
    {
      begin(b);
    }
    while (blocks_[0].waiting() != Waiting::ForNothing)
    {
      blocks_[0].waiting() == Waiting::ForAll ? stepAll() : stepSome(counts);
    }
    std::size_t bytes = 0;
    for (const Level& level : counts.levels)
    {
      bytes += level.bytesUp + level.bytesDown;
    }
    require(bytes == bytes_, "messages are not those of BlockTriangulation");
    require(counts.levels[0].triangles == blocks_[0].report().ownTriangles, "own triangles");
  }

private:
  void begin(std::size_t b)
  {
    boxes_.draw(b, points_[b]);
    ids_[b].resize(points_[b].size());
    std::iota(ids_[b].begin(), ids_[b].end(), std::int64_t(b * boxes_.each()));
    BlockInput input;
    input.block = b;
    input.blocks = blocks_.size();
    input.points = PointView(&points_[b][0].x, points_[b].size(), 2);
    input.ids = ids_[b].data();
    require(blocks_[b].begin(input, Context()) == Status::Ok, "begin()");
  }

  void stepAll()
  {
    std::vector<BlockBytes> all;
    for (const BlockTriangulation& block : blocks_)
    {
      all.push_back(block.toAll());
    }
    for (BlockTriangulation& block : blocks_)
    {
      require(block.takeAll(all, Context()) == Status::Ok, "takeAll()");
    }
  }

  void stepSome(const Counts& counts)
  {
    const std::vector<BorderCount> borders = blocks_[0].borders();
    if (!borders.empty())
    {
      Many points, edges;
      for (const BorderCount& border : borders)
      {
        points.add(double(border.points));
        edges.add(double(border.edges));
      }
      const Level& level = counts.levels[level_++];
      require(points.sum == level.borderPoints.sum && points.most == level.borderPoints.most &&
          edges.sum == level.borderEdges.sum,
        "borders are not those of BlockTriangulation");
    }
    std::vector<std::vector<BlockMessage>> in(blocks_.size());
    for (std::size_t b = 0; b != blocks_.size(); ++b)
    {
      std::vector<BlockMessage> out;
      require(blocks_[b].giveSome(out, Context()) == Status::Ok, "giveSome()");
      for (BlockMessage& message : out)
      {
        bytes_ += message.bytes.size();
        in[message.block].push_back({ b, std::move(message.bytes) });
      }
    }
    for (std::size_t b = 0; b != blocks_.size(); ++b)
    {
      require(blocks_[b].takeSome(in[b], Context()) == Status::Ok, "takeSome()");
    }
  }

  const Boxes& boxes_;
  std::vector<std::vector<Point>> points_;
  std::vector<std::vector<std::int64_t>> ids_;
  std::vector<BlockTriangulation> blocks_;
  std::size_t level_ = 0, bytes_ = 0;
};

// ------------------------------------------------------------------------------------ the table

std::string machine()
{
  std::ifstream file("/proc/cpuinfo");
  std::string line;
  while (std::getline(file, line))
  {
    if (line.compare(0, 10, "model name") == 0)
    {
      return line.substr(line.find(':') + 2);
    }
  }
  return "unknown processor";
}

std::string today()
{
  const std::time_t seconds = std::time(nullptr);
  char text[16] = {};
  std::strftime(text, sizeof(text), "%Y-%m-%d", std::localtime(&seconds));
  return text;
}

void printRow(std::ostream& out, const Boxes& boxes, const Counts& counts)
{
  const double root = std::sqrt(double(boxes.each())), blocks = double(boxes.blocks());
  const Level& bottom = counts.levels.front();
  const Level& top = counts.levels.back();
  double parts = 0.0, chain = bottom.seconds.most, bytes = 0.0, largest = 0.0;
  std::size_t mostBytes = 0;
  std::ostringstream levels;
  levels << std::fixed << std::setprecision(1);
  for (const Level& level : counts.levels)
  {
    bytes += double(level.bytesUp + level.bytesDown);
    if (&level != &bottom)
    {
      parts += level.seconds.sum + level.secondsDown.sum;
      chain += level.seconds.most + level.secondsDown.most;
      largest = std::max(largest, level.points.most);
      mostBytes = std::max(mostBytes, level.mostBytesIn + level.mostBytesOut);
      levels << (levels.tellp() > 0 ? " + " : "")
             << 1e3 * (level.seconds.most + level.secondsDown.most);
    }
  }
  out << std::fixed << "| " << boxes.blocks() << " | " << std::setprecision(2)
      << bottom.borderPoints.mean() / root << " (" << bottom.borderPoints.most / root << ") | "
      << std::setprecision(0) << bytes / blocks / 1024.0 << " | " << largest << " | "
      << double(top.points.sum) << " | " << double(mostBytes) / 1024.0 << " | "
      << std::setprecision(1) << 1e3 * counts.own.mean() << " | " << 1e3 * bottom.seconds.mean()
      << " | " << levels.str() << " | " << 1e3 * parts / blocks << " | " << 1e3 * chain << " | "
      << std::setprecision(0) << 100.0 * counts.own.mean() / (counts.own.mean() + chain) << " % |"
      << std::endl;
}

void printHead(std::ostream& out, std::size_t each)
{
  out << "# One triangulation over many blocks: counts\n\n"
         "Uniform points, "
      << each
      << " in each block; boxes of kd-cuts; eight blocks to a node of the tree. Drawn and "
         "triangulated one\n"
         "block after the other, of each only the border kept: `BlockCounts` (BlockCounts.cxx), "
      << today() << ",\n"
      << machine()
      << ", CPU time of one thread while others worked on the machine.\n"
         "That all triangles together are those of a triangulation of all points is checked by "
         "their number.\n\n"
         "*Border*: points that a block hands on, in roots of its points, the mean (the most). "
         "*Sent*: all messages up\n"
         "and down the tree, KiB per block. *Largest part*, *top*: points that are triangulated "
         "once more in one node, and\n"
         "at the root. *One node*: the most KiB that one gets and gives. *Own*, *search*: ms, the "
         "mean of the blocks.\n"
         "*Parts*: ms, the longest of each level, from the lowest up. *Common*: ms of all parts, "
         "per block. *Chain*: ms of the\n"
         "longest chain beyond the blocks' own: the search and one part of each level, carrying "
         "not counted. *Efficiency*: own\n"
         "over own and chain.\n\n"
         "| blocks | border | sent | largest part | top | one node | own | search | parts | common "
         "| chain | efficiency |\n"
         "|---|---|---|---|---|---|---|---|---|---|---|---|"
      << std::endl;
}

int check()
{
  for (const std::size_t blocks : { 2, 7, 8, 20, 130 })
  {
    const Boxes boxes(blocks, 700);
    const Counts counts = Tree(boxes).run();
    requireWhole(counts, blocks * boxes.each());
    Beside(boxes).compare(counts);
    printRow(std::cout, boxes, counts);
  }
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::size_t> blocks = { 2, 8, 64, 512, 4096 };
  std::size_t each = 1000000;
  std::ofstream file;
  for (int k = 1; k < argc; ++k)
  {
    const std::string word(argv[k]);
    const std::string value = word.substr(std::min(word.size(), word.find('=') + 1));
    if (word == "--check")
    {
      return check();
    }
    if (word.compare(0, 9, "--blocks=") == 0)
    {
      blocks.clear();
      std::istringstream list(value);
      for (std::string one; std::getline(list, one, ',');)
      {
        blocks.push_back(std::size_t(std::atof(one.c_str())));
      }
    }
    else if (word.compare(0, 9, "--points=") == 0)
    {
      each = std::size_t(std::atof(value.c_str()));
    }
    else
    {
      require(word.compare(0, 8, "--write=") == 0, "--blocks=, --points=, --write= or --check");
      file.open(value);
    }
  }
  require(each > 2 && *std::min_element(blocks.begin(), blocks.end()) > 1, "two blocks at least");
  std::ostream& out = file.is_open() ? file : std::cout;
  printHead(out, each);
  for (const std::size_t count : blocks)
  {
    const Boxes boxes(count, each);
    const Counts counts = Tree(boxes).run();
    requireWhole(counts, count * each);
    printRow(out, boxes, counts);
  }
  return 0;
}
