// SPDX-License-Identifier: BSD-3-Clause
//
// The filter on the ranks of an MPI program: one triangulation of uniform points, of which each
// rank has a run by number, wherever they lie. On one rank it is the plain filter.
//   mpirun -np RANKS RanksBenchmark [--points=10000000] [--threads=1] [--runs=3] [--cpu]
// Prints a line of JSON for each run: wall-clock seconds, or of CPU time, the longest of all ranks,
// of the whole and of each stage, and bytes at the peak beyond input and output, per point, the
// most of all ranks. New memory each time.
#include "Engine/Core/Threads.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDSettings.h"
#include "Ranks/vtkAHDRankExecution.h"
#include "vtkAdaptiveHilbertDelaunay2D.h"

#include <vtkCommunicator.h>
#include <vtkDoubleArray.h>
#include <vtkMPIController.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iterator>
#include <malloc.h>
#include <string>
#include <vector>

namespace
{

struct Way
{
  std::size_t points = 10000000;
  int threads = 1, runs = 3;
};

/// Times and memory of one rank.
struct Taken
{
  enum
  {
    kAll,
    kMove, ///< points and ids to their owners
    kOwn,
    kShared,
    kOutput, ///< data of points too
    kBytes,
    kCount
  };
  std::array<double, kCount> of = {};
  long long triangles = 0;
};

clockid_t clockToTake = CLOCK_MONOTONIC;

double now()
{
  timespec t;
  clock_gettime(clockToTake, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

/// A number in [0, 1) for each number: the same points on however many ranks.
double drawn(std::uint64_t i)
{
  i = (i + 1) * 0x9E3779B97F4A7C15u;
  i = (i ^ i >> 30) * 0xBF58476D1CE4E5B9u;
  i = (i ^ i >> 27) * 0x94D049BB133111EBu;
  return double((i ^ i >> 31) >> 11) * 0x1p-53;
}

vtkSmartPointer<vtkPolyData> makeRun(std::size_t begin, std::size_t end)
{
  vtkNew<vtkDoubleArray> places;
  places->SetNumberOfComponents(3);
  places->SetNumberOfTuples(vtkIdType(end - begin));
  double* to = places->GetPointer(0);
  for (std::size_t i = begin; i < end; ++i)
  {
    *to++ = drawn(2 * i);
    *to++ = drawn(2 * i + 1);
    *to++ = 0.0;
  }
  vtkNew<vtkPoints> points;
  points->SetData(places);
  auto made = vtkSmartPointer<vtkPolyData>::New();
  made->SetPoints(points);
  return made;
}

/// A line of /proc/self/status, in bytes.
double memory(const char* name)
{
  std::ifstream status("/proc/self/status");
  std::string word;
  double kib = 0.0;
  while (status >> word && word != name)
  {
  }
  status >> kib;
  return 1024.0 * kib;
}

/// Resets the peak. Returns the bytes held.
double beginPeak()
{
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
  return memory("VmRSS:");
}

Taken runAlone(vtkPolyData* input, const Way& way)
{
  Taken taken;
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(input);
  filter->SetNumberOfThreads(way.threads);
  filter->KeepTriangulationOff();
  const double held = beginPeak(), begun = now();
  filter->Update();
  taken.of[Taken::kAll] = taken.of[Taken::kOwn] = now() - begun;
  taken.triangles = filter->GetOutput()->GetNumberOfCells();
  // the points of the output are those of the input
  const double put = double(taken.triangles) * 4.0 * sizeof(vtkTypeInt32);
  taken.of[Taken::kBytes] = memory("VmHWM:") - held - put;
  return taken;
}

Taken runTogether(vtkPolyData* input, const Way& way, vtkMultiProcessController* controller)
{
  Taken taken;
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter; // observes progress
  vtkNew<vtkPolyData> output, order, cells;
  const double held = beginPeak(), begun = now();
  vtkAHDProgress progress(filter, now);
  ahd::Threads threads(unsigned(way.threads));
  vtkAHDOutputMemory outputs;
  const vtkAHDContext context(progress, threads, outputs);
  const vtkAHDSettings settings;
  vtkAHDRanks ranks(controller);
  vtkAHDRankResult result;
  vtkAHDDataSets data;
  data.Input = input;
  data.Outputs = { { output, order, cells } };
  ahd::Workspace workspace;
  const ahd::Status status = ranks.Execute(
    [&] {
      vtkAHDRankExecution(settings, ranks, context, result).Run(data, ahd::Status::Ok, workspace);
    });
  const double ended = now();
  std::vector<double> stages = progress.stagesBegun();
  stages.push_back(ended);
  if (status != ahd::Status::Ok || stages.size() != Taken::kBytes)
  {
    std::fprintf(stderr, "failed: %s\n", result.Error.c_str());
    std::exit(1);
  }
  taken.of[Taken::kAll] = ended - begun;
  for (int stage = Taken::kMove; stage <= Taken::kOutput; ++stage)
  {
    taken.of[std::size_t(stage)] = stages[std::size_t(stage)] - stages[std::size_t(stage - 1)];
  }
  taken.triangles = (long long)result.Report.triangles;
  taken.of[Taken::kBytes] = memory("VmHWM:") - held -
    1024.0 * double(output->GetActualMemorySize());
  return taken;
}

void print(const Taken& taken, const Way& way, int ranks)
{
  static const char* const kNames[] = { "seconds", "move", "own", "shared", "output" };
  std::printf("{\"ranks\": %d, \"threads\": %d, \"points\": %zu, \"triangles\": %lld", ranks,
    way.threads, way.points, taken.triangles);
  for (std::size_t k = 0; k < std::size(kNames); ++k)
  {
    std::printf(", \"%s\": %.4f", kNames[k], taken.of[k]);
  }
  std::printf(
    ", \"bytesPerPoint\": %.1f}\n", taken.of[Taken::kBytes] * double(ranks) / double(way.points));
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  Way way;
  for (int k = 1; k < argc; ++k)
  {
    const char* const value = std::strchr(argv[k], '=');
    const double number = value ? std::atof(value + 1) : 0.0;
    const std::string name(argv[k], value ? std::size_t(value - argv[k]) : std::strlen(argv[k]));
    (name == "--points"       ? way.points = std::size_t(number)
        : name == "--threads" ? std::size_t(way.threads = int(number))
        : name == "--runs"    ? std::size_t(way.runs = int(number))
        : name == "--cpu"     ? (clockToTake = CLOCK_PROCESS_CPUTIME_ID, std::size_t(1))
                              : way.points = 0);
  }
  if (way.points == 0)
  {
    std::fprintf(stderr, "RanksBenchmark [--points=N] [--threads=N] [--runs=N]\n");
    controller->Finalize();
    return 1;
  }
  const int ranks = controller->GetNumberOfProcesses(), rank = controller->GetLocalProcessId();
  const auto cut = [&](int k) { return way.points * std::size_t(k) / std::size_t(ranks); };
  const vtkSmartPointer<vtkPolyData> input = makeRun(cut(rank), cut(rank + 1));
  for (int run = 0; run < way.runs; ++run)
  {
    controller->Barrier();
    const Taken own = ranks == 1 ? runAlone(input, way) : runTogether(input, way, controller);
    Taken all = own;
    controller->AllReduce(
      own.of.data(), all.of.data(), vtkIdType(own.of.size()), vtkCommunicator::MAX_OP);
    if (rank == 0)
    {
      print(all, way, ranks);
    }
  }
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return 0;
}
