// SPDX-License-Identifier: BSD-3-Clause
//
// The permitted #includes, read from the sources: the engine's parts depend on each other in one
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
/// Core, independent of points and triangles, is open to all.
const std::map<std::string, Names>& allowedParts()
{
  static const std::map<std::string, Names> kAllowed = {
    { "Core", {} },
    { "Arithmetic", { "Points" } },
    { "Points", {} },
    { "Mesh", {} },
    { "Predicates", { "Arithmetic", "Points" } },
    { "Order", { "Points" } },
    { "Insert", { "Points", "Order", "Predicates", "Mesh" } },
    { "Extract", { "Mesh" } },
    { "Merge", { "Points" } },
    { "Crossings", { "Arithmetic", "Points", "Order", "Predicates" } },
    { "Constrain", { "Points", "Predicates", "Mesh" } },
    { "Living", { "Points", "Predicates", "Mesh" } },
    { "Edit", { "Points", "Order", "Predicates", "Mesh", "Living", "Triangulation", "" } },
    { "Refine", { "Arithmetic", "Points", "Predicates", "Mesh", "Living", "Triangulation" } },
    { "Outline", { "Points", "Order", "Predicates", "Prepare" } },
    { "Prepare",
      { "Arithmetic", "Points", "Order", "Predicates", "Merge", "Crossings", "Surface",
        "Triangulation", "" } },
    { "Simplify", { "Arithmetic", "Points", "Order", "Predicates", "Mesh", "Living" } },
    { "Surface", { "Arithmetic", "Points", "Merge", "Triangulation" } },
    { "Triangulation", { "Points", "Order", "Predicates", "Mesh", "Constrain", "Extract" } },
    { "Voronoi", { "Arithmetic", "Points", "Predicates", "Triangulation" } },
    { "Sample", { "Arithmetic", "Points", "Order", "Predicates", "Triangulation" } },
    { "Distribute",
      { "Points", "Order", "Predicates", "Mesh", "Constrain", "Extract", "Prepare", "Sample",
        "Triangulation", "" } },
    { "Tiles",
      { "Points", "Order", "Predicates", "Constrain", "Distribute", "Sample", "Surface",
        "Triangulation" } },
    { "Job",
      { "Points", "Order", "Merge", "Crossings", "Edit", "Outline", "Prepare", "Refine", "Sample",
        "Simplify", "Surface", "Tiles", "Triangulation", "Voronoi", "" } },
    { "Interface", { "Job" } },
  };
  return kAllowed;
}

/// Headers beside the entries with types only: every part may use them.
const Names& vocabulary()
{
  static const Names kWords = { "Constraints.h", "Options.h", "Result.h" };
  return kWords;
}

/// Headers that some files of the engine may include beyond the usual ones: those that start
/// threads, count processors, find free memory and read the clock; the C interface is a C header.
const Names& machineHeaders(const fs::path& file)
{
  static const std::map<std::string, Names> kFiles = { { "Core/Threads.cxx",
                                                         { "chrono", "mutex", "thread" } },
    { "Core/Processors.cxx", { "thread", "sched.h" } },
    { "Core/Memory.cxx", { "fstream", "sys/resource.h", "unistd.h", "psapi.h", "mach/mach.h" } },
    { "Core/Windows.h", { "windows.h" } }, { "Core/Clock.cxx", { "chrono" } },
    { "Interface/ahd.h", { "stdint.h" } } };
  static const Names kNone;
  const auto found = kFiles.find(file.generic_string());
  return found == kFiles.end() ? kNone : found->second;
}

/// What lies directly in Filters/Engine: the entries may use every part, headers of types only such
/// headers.
bool isDoor(const fs::path& file)
{
  static const std::set<std::string> kStems = { "Triangulate", "TriangulateConstrained" };
  return file.parent_path().empty() && kStems.count(file.stem().string()) != 0;
}

/// The folders of the VTK layer (below Filters; "" is Filters itself) -> those they may include
/// besides themselves.
const std::map<std::string, Names>& allowedInTheVtkLayer()
{
  static const std::map<std::string, Names> kAllowed = {
    { "Pipeline", {} },
    { "Input", { "Pipeline" } },
    { "Output", { "Input", "Pipeline" } },
    { "Execution", { "Input", "Output", "Pipeline" } },
    { "Ranks", { "Execution", "Input", "Output", "Pipeline", "Sampling" } },
    { "Sampling", { "Execution", "Input", "Output", "Pipeline" } },
    { "", { "Execution", "Input", "Output", "Pipeline", "Ranks", "Sampling", "Distributions" } },
  };
  return kAllowed;
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

/// The folder that a file lies in, directly or below it; "" for none.
std::string partOf(const fs::path& file)
{
  return file.parent_path().empty() ? "" : file.begin()->string();
}

bool mayInclude(const fs::path& file, const fs::path& included)
{
  const std::string part = partOf(file), other = partOf(included);
  if (isDoor(file) || other == "Core" || vocabulary().count(included.generic_string()) != 0)
  {
    return true;
  }
  const auto rule = allowedParts().find(part);
  return rule != allowedParts().end() && (part == other || rule->second.count(other) != 0);
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

TEST(IncludeArrows, EveryPartHasARuleAndEveryRuleAPart)
{
  for (const fs::path& file : engineSources())
  {
    if (!file.parent_path().empty())
    {
      EXPECT_EQ(allowedParts().count(file.begin()->string()), 1u) << file;
    }
  }
  for (const auto& [part, others] : allowedParts())
  {
    EXPECT_TRUE(fs::is_directory(kEngine / part)) << "there is a rule for " << part;
    for (const std::string& other : others)
    {
      EXPECT_TRUE(fs::is_directory(kEngine / other)) << part << " may include " << other;
    }
  }
  for (const auto& [folder, others] : allowedInTheVtkLayer())
  {
    EXPECT_TRUE(fs::is_directory(kEngine.parent_path() / folder)) << folder;
  }
}

TEST(IncludeArrows, EngineNeedsOnlyTheStandardLibrary)
{
  // Headers of the standard library have neither a folder nor an extension; of the C library's
  // their C++ names are used.
  static const std::regex kStandard("[a-z_0-9]+");
  // The compiler's headers of processor instructions, where present.
  static const Names kProcessor = { "xmmintrin.h", "immintrin.h" };
  for (const fs::path& file : engineSources())
  {
    for (const std::string& operand : includesOf(kEngine / file))
    {
      const std::string name = inside(operand);
      const bool may = machineHeaders(file).count(name) != 0;
      if (operand[0] == '<' && kProcessor.count(name) == 0 && !may)
      {
        EXPECT_TRUE(std::regex_match(name, kStandard)) << file << " includes " << operand;
      }
    }
  }
}

TEST(IncludeArrows, EngineKeepsToItself)
{
  // No clock, environment or printing: none of their headers is included.
  static const Names kUnwanted = { "chrono", "ctime", "iostream", "fstream", "cstdio", "random",
    "thread", "mutex", "filesystem" };
  for (const fs::path& file : engineSources())
  {
    for (const std::string& operand : includesOf(kEngine / file))
    {
      const std::string name = inside(operand);
      const bool may = machineHeaders(file).count(name) != 0;
      EXPECT_TRUE(may || kUnwanted.count(name) == 0) << file << " includes " << operand;
    }
  }
}

TEST(IncludeArrows, SystemsDifferBehindTheDoorsToTheMachineOnly)
{
  static const std::regex kSystem(
    "__linux__|__APPLE__|__unix__|_WIN32|_WIN64|__MINGW32__|__CYGWIN__");
  for (const fs::path& file : engineSources())
  {
    std::ifstream in(kEngine / file);
    const std::string text{ std::istreambuf_iterator<char>(in), {} };
    EXPECT_TRUE(!machineHeaders(file).empty() || !std::regex_search(text, kSystem)) << file;
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

/// The VTK layer includes only installed headers of the engine: those of its C++ interface.
Names interfaceOfTheEngine()
{
  std::ifstream in(kEngine / "Sources.cmake");
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  const std::size_t begin = text.find("set(ahd_engine_headers");
  text = text.substr(begin, text.find(')', begin) - begin);
  static const std::regex kHeader("[A-Za-z_/]+\\.h");
  Names result;
  for (std::sregex_iterator i(text.begin(), text.end(), kHeader), end; i != end; ++i)
  {
    EXPECT_TRUE(fs::exists(kEngine / i->str())) << i->str();
    result.insert("Engine/" + i->str());
  }
  return result;
}

TEST(IncludeArrows, TheVtkLayerPointsOneWayAndComesThroughTheDoor)
{
  const Names interface = interfaceOfTheEngine();
  EXPECT_GE(interface.size(), 5u);
  const fs::path filters = kEngine.parent_path();
  std::size_t arrows = 0;
  for (const auto& [folder, others] : allowedInTheVtkLayer())
  {
    for (const auto& entry : fs::directory_iterator(filters / folder))
    {
      if (!entry.is_regular_file() || !isSource(entry.path()))
      {
        continue;
      }
      for (const std::string& operand : includesOf(entry.path()))
      {
        const fs::path included = inside(operand);
        if (operand[0] == '<' || !fs::exists(filters / included))
        {
          continue; // VTK's
        }
        ++arrows;
        const std::string other = partOf(included);
        const bool may = other == "Engine" ? interface.count(included.generic_string()) != 0
                                           : other == folder || others.count(other) != 0;
        EXPECT_TRUE(may) << entry.path() << " may not include " << operand;
      }
    }
  }
  EXPECT_GE(arrows, 30u);
}

TEST(IncludeArrows, WhatIsInstalledIncludesOnlyWhatIsInstalled)
{
  const Names interface = interfaceOfTheEngine();
  for (const std::string& header : interface)
  {
    const fs::path file = fs::path(header).lexically_relative("Engine");
    for (const std::string& operand : includesOf(kEngine / file))
    {
      if (operand[0] == '"')
      {
        const fs::path included = (file.parent_path() / inside(operand)).lexically_normal();
        EXPECT_EQ(interface.count("Engine/" + included.generic_string()), 1u)
          << header << " includes " << operand << ", which is not installed";
      }
    }
  }
}

} // namespace
