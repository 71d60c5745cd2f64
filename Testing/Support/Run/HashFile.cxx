// SPDX-License-Identifier: BSD-3-Clause
#include "HashFile.h"

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

namespace ahd
{
namespace test
{
namespace
{

std::map<std::string, std::string> byName(const Hashes& hashes)
{
  std::map<std::string, std::string> result;
  for (const NamedHash& hash : hashes)
  {
    result[hash.name] = hash.hash;
  }
  return result;
}

std::string commentsOf(const std::string& path)
{
  std::string comments;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);)
  {
    comments += line.rfind('#', 0) == 0 ? line + "\n" : "";
  }
  return comments;
}

std::string write(const std::string& path, const Hashes& hashes)
{
  const std::string comments = commentsOf(path);
  std::ofstream out(path);
  out << comments;
  for (const NamedHash& hash : hashes)
  {
    out << hash.hash << ' ' << hash.name << '\n';
  }
  out.close();
  return out ? "" : path + " cannot be written\n";
}

} // namespace

Hashes readHashes(const std::string& path)
{
  Hashes hashes;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);)
  {
    NamedHash hash;
    if (line.rfind('#', 0) != 0 && std::istringstream(line) >> hash.hash >> hash.name)
    {
      hashes.push_back(hash);
    }
  }
  return hashes;
}

std::string differences(const Hashes& before, const Hashes& now)
{
  const std::map<std::string, std::string> old = byName(before);
  std::map<std::string, std::string> gone = old;
  std::string result;
  for (const NamedHash& hash : now)
  {
    const auto found = old.find(hash.name);
    const std::string was = found == old.end() ? "none" : found->second;
    result += was == hash.hash ? "" : hash.name + ": was " + was + ", is " + hash.hash + "\n";
    gone.erase(hash.name);
  }
  for (const auto& hash : gone)
  {
    result += hash.first + ": was " + hash.second + ", is none\n";
  }
  return result;
}

std::string differencesFromFile(const std::string& path, const Hashes& now)
{
  if (std::getenv("AHD_WRITE_HASHES"))
  {
    return write(path, now);
  }
  const std::string result = differences(readHashes(path), now);
  return result.empty() ? ""
                        : result + "A change of results? If it is meant, run this test with " +
      "AHD_WRITE_HASHES=1 in the environment and commit " + path + ".\n";
}

} // namespace test
} // namespace ahd
