// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PeerFiles_h
#define ahd_PeerFiles_h

#include "Points/Points.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ahd
{
namespace test
{

/// The files that peers read and write: bare numbers in the machine's byte order.
/// Points: two doubles (x, y) each. Triangles: three 32-bit integers each. Readers and writers end
/// the program with a message where a file cannot be read or written.
std::vector<Point> readPoints(const std::string& file);
void writePoints(const std::string& file, const std::vector<Point>& points);
std::vector<std::int32_t> readTriples(const std::string& file);
void writeTriples(const std::string& file, const std::vector<std::int32_t>& triples);

/// Times a call as runs.py expects it of every peer. Prints "call" to stdout before, and "called"
/// after; then `write` saves the result, and the line "done" with the figures ends the run. Returns
/// main()'s exit code.
int timeCall(const std::function<void()>& call, const std::function<void()>& write);

} // namespace test
} // namespace ahd

#endif
