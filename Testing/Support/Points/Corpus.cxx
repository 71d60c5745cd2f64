// SPDX-License-Identifier: BSD-3-Clause
#include "Corpus.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace ahd
{
namespace test
{
namespace
{

/// Reads "x y" and nothing else from a line.
bool parse(const std::string& line, Point& point)
{
  char* afterX = nullptr;
  char* afterY = nullptr;
  point.x = std::strtod(line.c_str(), &afterX);
  point.y = std::strtod(afterX, &afterY);
  return afterX != line.c_str() && afterY != afterX && *afterY == '\0';
}

CorpusFile readFile(const std::filesystem::path& path)
{
  CorpusFile file;
  file.name = path.filename().string();
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);)
  {
    Point point{};
    if (file.reason.empty() && line.rfind("# ", 0) == 0)
    {
      file.reason = line.substr(2);
    }
    else if (!line.empty() && line[0] != '#')
    {
      if (!parse(line, point))
      {
        file.fault += "not two numbers: " + line + "\n";
      }
      file.points.push_back(point);
    }
  }
  return file;
}

} // namespace

std::vector<CorpusFile> readCorpus(const std::string& folder)
{
  std::vector<CorpusFile> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
  {
    if (entry.path().extension() == ".txt")
    {
      files.push_back(readFile(entry.path()));
    }
  }
  std::sort(files.begin(), files.end(),
    [](const CorpusFile& a, const CorpusFile& b) { return a.name < b.name; });
  return files;
}

} // namespace test
} // namespace ahd
