// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkFlags.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace ahd
{
namespace test
{
namespace
{

std::vector<std::string> split(const std::string& list)
{
  std::vector<std::string> words;
  std::stringstream stream(list);
  for (std::string word; std::getline(stream, word, ',');)
  {
    words.push_back(word);
  }
  return words;
}

std::vector<Distribution> defaultDistributions()
{
  std::vector<Distribution> result = paperDistributions();
  result.insert(result.end(),
    { Distribution::Lattice, Distribution::DecimalLattice, Distribution::Utm,
      Distribution::KuzminDisc, Distribution::NestedClusters });
  return result;
}

void takeDistributions(BenchmarkFlags& flags, const std::string& value, std::string& error)
{
  flags.distributions.clear();
  for (const std::string& word : split(value))
  {
    const std::vector<Distribution>& all = allDistributions();
    const auto found = std::find_if(
      all.begin(), all.end(), [&](Distribution d) { return word == nameOf(d); });
    if (found != all.end())
    {
      flags.distributions.push_back(*found);
    }
    else if (word == "paper" || word == "all")
    {
      const std::vector<Distribution>& group = word == "all" ? all : paperDistributions();
      flags.distributions.insert(flags.distributions.end(), group.begin(), group.end());
    }
    else
    {
      error += "no distribution is called " + word + "\n";
    }
  }
}

void takeSizes(BenchmarkFlags& flags, const std::string& value, std::string& error)
{
  flags.sizes.clear();
  for (const std::string& word : split(value))
  {
    const double size = std::atof(word.c_str());
    if (!(size >= 1 && size <= 2e8))
    {
      error += "not a number of points: " + word + "\n";
      continue;
    }
    flags.sizes.push_back(std::size_t(std::llround(size)));
  }
}

void takeEngines(BenchmarkFlags& flags, const std::string& value, std::string& error)
{
  flags.engines = split(value);
  for (const std::string& word : flags.engines)
  {
    const bool isThreads = word.rfind("threads", 0) == 0 && std::atoi(word.c_str() + 7) > 0;
    const bool isScaled = word.rfind("times", 0) == 0 && std::atof(word.c_str() + 5) > 0;
    static const std::vector<std::string> others = { "ours", "cgal", "c", "float", "shuffled" };
    if (!isThreads && !isScaled && std::find(others.begin(), others.end(), word) == others.end())
    {
      error += "no engine is called " + word + "\n";
    }
  }
}

/// If `argument` is "--name=value", sets `value`.
bool isFlag(const std::string& argument, const std::string& name, std::string& value)
{
  const std::string prefix = "--" + name + "=";
  if (argument.rfind(prefix, 0) != 0)
  {
    return false;
  }
  value = argument.substr(prefix.size());
  return true;
}

} // namespace

BenchmarkFlags takeFlags(int& argc, char** argv, std::string& error)
{
  BenchmarkFlags flags;
  flags.distributions = defaultDistributions();
  int kept = 1;
  for (int i = 1; i < argc; ++i)
  {
    std::string value;
    if (isFlag(argv[i], "sizes", value))
    {
      takeSizes(flags, value, error);
    }
    else if (isFlag(argv[i], "distributions", value))
    {
      takeDistributions(flags, value, error);
    }
    else if (isFlag(argv[i], "engines", value))
    {
      takeEngines(flags, value, error);
    }
    else if (isFlag(argv[i], "repeat", value))
    {
      flags.repeat = std::max(1, std::atoi(value.c_str()));
    }
    else if (std::string(argv[i]) == "--cold")
    {
      flags.cold = true;
    }
    else
    {
      argv[kept++] = argv[i];
    }
  }
  argc = kept;
  return flags;
}

} // namespace test
} // namespace ahd
