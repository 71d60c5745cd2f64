// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_HashFile_h
#define ahd_HashFile_h

#include <string>
#include <vector>

namespace ahd
{
namespace test
{

/// The hash of one result.
struct NamedHash
{
  std::string name; ///< without spaces
  std::string hash;
};
using Hashes = std::vector<NamedHash>;

/// Reads lines "hash name"; those that begin with # are comments. Empty if there is no such file.
Hashes readHashes(const std::string& path);

/// The differences, a line for each: its name, the hash before and the one now. Empty if none.
std::string differences(const Hashes& before, const Hashes& now);

/// differences() between the file and the current hashes, and how to write the file anew. But if
/// the environment variable AHD_WRITE_HASHES is set, the file is written, its comments kept, and
/// the result is empty, or the reason why it could not be.
std::string differencesFromFile(const std::string& path, const Hashes& now);

} // namespace test
} // namespace ahd

#endif
