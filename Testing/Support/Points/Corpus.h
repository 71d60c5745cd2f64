// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Corpus_h
#define ahd_Corpus_h

#include "Points/Points.h"

#include <string>
#include <vector>

namespace ahd
{
namespace test
{

/// A file of Data/Corpus: "# reason" in the first line, then "x y" per line in hexadecimal floating
/// point ("nan" and "inf" included); further lines that begin with # are comments.
struct CorpusFile
{
  std::string name;
  std::string reason;
  std::vector<Point> points;
  std::string fault; ///< the error of reading; empty if none
};

/// All files *.txt of a folder, by name.
std::vector<CorpusFile> readCorpus(const std::string& folder);

} // namespace test
} // namespace ahd

#endif
