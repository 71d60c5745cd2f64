// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Judge_h
#define ahd_Judge_h

// Shared by the fuzz targets of the engine: reports of faults, and runs that fail.
#include "Core/Progress.h"
#include "EngineRun.h"
#include "FuzzCase.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace ahd
{
namespace fuzz
{

/// Ends the program with the case and its fault, unless `fault` is empty.
void expectNone(const std::string& fault, const FuzzCase& given);
/// Likewise, unless it is true.
void expect(bool isTrue, const char* what, const FuzzCase& given);

/// While one lives, allocations fail from the given one on (1 is the next one; 0: all
/// is well), in all threads. An inner one takes the place of the outer one meanwhile.
class NoMemory
{
public:
  explicit NoMemory(std::size_t from);
  ~NoMemory();
  NoMemory(const NoMemory&) = delete;
  NoMemory& operator=(const NoMemory&) = delete;

private:
  std::size_t outerFailAt_, outerAllocations_;
};

/// Checks the rules of Progress.h, and cancels at one poll (0: at none).
class Watch : public Progress
{
public:
  explicit Watch(std::size_t cancelAt = 0)
    : cancelAt_(cancelAt)
  {
  }
  void beginPhase(Phase phase) override;
  bool advance(Phase phase, double fraction) override;

  bool cancelled() const { return cancelAt_ != 0 && askings_ >= cancelAt_; }
  /// The broken rules; empty if none.
  const std::string& fault() const { return fault_; }

private:
  std::size_t cancelAt_;
  std::size_t askings_ = 0;
  Phase phase_ = Phase::Merge;
  double fraction_ = 0.0;
  std::string fault_;
};

/// Does the work cancelled and without memory, by the case: it must report it, or be Ok.
void expectStops(const FuzzCase& given, const std::function<Status(Progress*)>& work);

/// Coordinates in the layout of the case, and the marks of those to skip.
class Layout
{
public:
  Layout(const FuzzCase& given, const std::vector<Point>& points);
  PointView view() const;

private:
  std::vector<double> doubles_;
  std::vector<float> floats_;
  std::vector<unsigned char> skip_;
  std::size_t count_, stride_;
  unsigned char mask_;
};

/// The numbers 0 to n - 1 in an order that depends on the seed; 0 keeps the order.
std::vector<std::size_t> shuffledIds(std::size_t n, unsigned seed);

/// Settings, executor and progress of a run.
struct Run
{
  Options options;
  Executor* executor = nullptr;
  Progress* progress = nullptr;
};
Run runOf(const FuzzCase& given, std::size_t run);

/// run(), writeTriangles() and writePointStatus() with all that a Run has.
test::Outcome triangulate(test::Engine& engine, const PointView& points, const Run& run);

} // namespace fuzz
} // namespace ahd

#endif
