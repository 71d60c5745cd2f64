// SPDX-License-Identifier: BSD-3-Clause
//
// Who may include whom, read from the sources: the engine's parts depend on each other in one
// direction only, and on nothing but the standard library.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace
{

namespace fs = std::filesystem;
using Names = std::set<std::string>;

const fs::path kEngine = AHD_ENGINE_DIRECTORY;

/// Part of the engine (a folder of Filters/Engine) -> the parts it may include besides itself.
const std::map<std::string, Names>& allowedParts()
{
  static const std::map<std::string, Names> kAllowed = {
    { "Points", {} },
    { "Predicates", { "Points" } },
    { "Mesh", {} },
    { "Order", { "Points" } },
    { "Insert", { "Points", "Order", "Predicates", "Mesh" } },
    { "Extract", { "Mesh" } },
    { "Constrain", { "Points", "Predicates", "Mesh" } },
    { "Parallel", { "Points", "Order", "Predicates", "Mesh", "Insert" } },
    { "Distribute", { "Order", "Insert", "Extract" } },
    { "Voronoi", { "Points" } },
  };
  return kAllowed;
}

/// Headers that carry words, not work: every part may use them.
const Names& vocabulary()
{
  static const Names kWords = { "Border.h", "Buffer.h", "Chunks.h", "Constraints.h", "Executor.h",
    "FloatingPoint.h", "Instructions.h", "Options.h", "Progress.h", "Result.h", "SortAsking.h",
    "Tasks.h" };
  return kWords;
}

/// Public headers beside the door, each to the part that does what it declares: it speaks of
/// points, and that part only includes it.
const std::map<std::string, std::string>& sideDoors()
{
  static const std::map<std::string, std::string> kParts = { { "Merge.h", "Points" },
    { "Crossings.h", "Constrain" }, { "Voronoi.h", "Voronoi" } };
  return kParts;
}

/// What lies directly in Filters/Engine: the door may use every part, side doors the points, the
/// words only words.
bool isDoor(const fs::path& file)
{
  static const std::set<std::string> kStems = { "Triangulate", "TriangulateCells",
    "TriangulatorState" };
  return file.parent_path().empty() && kStems.count(file.stem().string()) != 0;
}

/// The operands of #include: "x" with the quotes, <x> with the brackets.
std::vector<std::string> includesOf(const fs::path& file)
{
  static const std::regex kInclude("^\\s*#\\s*include\\s*([\"<][^\">]+[\">]).*");
  std::ifstream in(file);
  EXPECT_TRUE(in.is_open()) << file;
  std::vector<std::string> result;
  std::smatch match;
  for (std::string line; std::getline(in, line);)
  {
    if (std::regex_match(line, match, kInclude))
    {
      result.push_back(match[1]);
    }
  }
  return result;
}

std::string inside(const std::string& operand)
{
  return operand.substr(1, operand.size() - 2);
}

bool isSource(const fs::path& file)
{
  return file.extension() == ".h" || file.extension() == ".cxx";
}

/// All sources of the engine, relative to its folder.
std::vector<fs::path> engineSources()
{
  std::vector<fs::path> result;
  for (const auto& entry : fs::recursive_directory_iterator(kEngine))
  {
    if (entry.is_regular_file() && isSource(entry.path()))
    {
      result.push_back(fs::relative(entry.path(), kEngine));
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

bool mayInclude(const fs::path& file, const fs::path& included)
{
  if (vocabulary().count(included.generic_string()) != 0 || isDoor(file))
  {
    return true;
  }
  const std::string part = file.parent_path().empty() ? "" : file.begin()->string();
  const std::string other = included.parent_path().empty() ? "" : included.begin()->string();
  if (sideDoors().count(file.generic_string()) != 0)
  {
    return other == "Points";
  }
  if (const auto door = sideDoors().find(included.generic_string()); door != sideDoors().end())
  {
    return part == door->second;
  }
  if (part.empty() || other.empty())
  {
    return false;
  }
  const auto rule = allowedParts().find(part);
  return part == other || (rule != allowedParts().end() && rule->second.count(other) != 0);
}

TEST(IncludeArrows, PartsOfTheEnginePointOneWay)
{
  const std::vector<fs::path> sources = engineSources();
  ASSERT_GE(sources.size(), 10u) << "in " << kEngine;
  std::size_t arrows = 0;
  for (const fs::path& file : sources)
  {
    for (const std::string& operand : includesOf(kEngine / file))
    {
      if (operand[0] != '"')
      {
        continue;
      }
      ++arrows;
      const fs::path included = (file.parent_path() / inside(operand)).lexically_normal();
      EXPECT_TRUE(fs::exists(kEngine / included))
        << file << " includes " << operand << ", which is not found from its own folder";
      EXPECT_TRUE(mayInclude(file, included)) << file << " may not include " << included;
    }
  }
  EXPECT_GE(arrows, 10u) << "includes are no longer recognised";
}

TEST(IncludeArrows, EveryPartHasARule)
{
  for (const fs::path& file : engineSources())
  {
    if (!file.parent_path().empty())
    {
      EXPECT_EQ(allowedParts().count(file.begin()->string()), 1u) << file;
    }
  }
}

TEST(IncludeArrows, EngineNeedsOnlyTheStandardLibrary)
{
  // Headers of the standard library have neither a folder nor an extension; of the C library's
  // their C++ names are used.
  static const std::regex kStandard("[a-z_0-9]+");
  // What the compiler says about the processor, where it is one that has it.
  static const Names kProcessor = { "xmmintrin.h", "immintrin.h" };
  for (const fs::path& file : engineSources())
  {
    for (const std::string& operand : includesOf(kEngine / file))
    {
      const std::string name = inside(operand);
      if (operand[0] == '<' && kProcessor.count(name) == 0)
      {
        EXPECT_TRUE(std::regex_match(name, kStandard)) << file << " includes " << operand;
      }
    }
  }
}

TEST(IncludeArrows, EngineKeepsToItself)
{
  // Neither a clock, nor the environment, nor printing: who includes none of these has none.
  static const Names kUnwanted = { "chrono", "ctime", "iostream", "fstream", "cstdio", "random",
    "thread", "mutex", "filesystem" };
  for (const fs::path& file : engineSources())
  {
    for (const std::string& operand : includesOf(kEngine / file))
    {
      EXPECT_EQ(kUnwanted.count(inside(operand)), 0u) << file << " includes " << operand;
    }
  }
}

TEST(IncludeArrows, MakersOfPointsKeepToThemselves)
{
  // They name their own headers without a folder, and the standard library's.
  static const std::regex kOwnOrStandard("\"[A-Za-z]+\\.h\"|<[a-z]+>");
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(kEngine.parent_path() / "Distributions"))
  {
    if (!isSource(entry.path()))
    {
      continue;
    }
    ++files;
    for (const std::string& operand : includesOf(entry.path()))
    {
      EXPECT_TRUE(std::regex_match(operand, kOwnOrStandard))
        << entry.path() << " includes " << operand;
      EXPECT_NE(operand, "<random>") << entry.path() << ": its distributions differ by platform";
    }
  }
  EXPECT_GE(files, 6u);
}

TEST(IncludeArrows, VtkFilesComeThroughTheDoor)
{
  static const Names kDoor = { "Engine/Triangulate.h", "Engine/Options.h", "Engine/Result.h",
    "Engine/Progress.h", "Engine/Executor.h", "Engine/Constraints.h", "Engine/Crossings.h",
    "Engine/Merge.h", "Engine/Points/Points.h", "Engine/Voronoi.h", "Engine/FloatingPoint.h" };
  for (const auto& entry : fs::directory_iterator(kEngine.parent_path()))
  {
    if (!entry.is_regular_file() || !isSource(entry.path()))
    {
      continue;
    }
    for (const std::string& operand : includesOf(entry.path()))
    {
      const std::string name = inside(operand);
      if (name.rfind("Engine/", 0) == 0)
      {
        EXPECT_EQ(kDoor.count(name), 1u) << entry.path() << " includes " << operand;
      }
    }
  }
}

} // namespace
