// SPDX-License-Identifier: BSD-3-Clause
//
// The experiments of Su et al., Computers & Graphics 54 (2016), section 4: one distribution and
// number of points, triangulated by each configuration in turn, round after round. Prints one JSON
// object per configuration, times in milliseconds, one a round:
//   PaperExperiments --distributions=Line --sizes=2e6 --configurations=RG,MG,HG,default,CGAL
//                    [--repeat=5] [--validate-cgal]
//   PaperExperiments --about        how it was built
// A configuration is CGAL, default (what is shipped) or an order, RG, MG or HG, with the paper's
// settings, which may be changed: HG:control=none|one|every  HG:genes=off  MG:nmax=100.
//
// One thread, timed by its CPU time. Every run is cold: it begins with a new engine and no memory,
// and page faults are part of it, as in a program that runs once. Results are freed after the clock
// has stopped. The first of the engine's results is certified, all others have to be the same
// bytes; of CGAL's, the number of triangles has to agree.
#include "BenchmarkFlags.h"
#ifdef AHD_WITH_CGAL
#include "CgalRun.h"
#endif
#include "EngineRun.h"

#include <malloc.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <memory>
#include <sstream>

namespace
{

using namespace ahd;
using namespace ahd::test;

double milliseconds(clockid_t clock)
{
  timespec t;
  clock_gettime(clock, &t);
  return 1e3 * double(t.tv_sec) + 1e-6 * double(t.tv_nsec);
}

/// One thing to measure.
struct Configuration
{
  std::string name;
  bool isCgal = false;
  Options options;
};

/// The printed data of a configuration: times by name, one a round, and results.
struct Measured
{
  std::map<std::string, std::vector<double>> times;
  std::size_t triangles = 0;
  Report work; ///< counted, in a run of its own
  std::string checked;
  std::string faults;
};

/// Takes the time of each phase, and of the whole.
class Stopwatch : public Progress
{
public:
  Stopwatch()
    : begin_(milliseconds(CLOCK_THREAD_CPUTIME_ID))
    , beginOnTheWall_(milliseconds(CLOCK_MONOTONIC))
  {
  }

  void beginPhase(Phase phase) override
  {
    this->endPhase();
    running_ = phase == Phase::Read ? "read"
      : phase == Phase::Sort        ? "sort"
      : phase == Phase::Insert      ? "insert"
                                    : "extract";
    phaseBegin_ = milliseconds(CLOCK_THREAD_CPUTIME_ID);
  }
  bool advance(Phase, double) override { return true; }

  void endPhase()
  {
    if (running_)
    {
      took_[running_] += milliseconds(CLOCK_THREAD_CPUTIME_ID) - phaseBegin_;
    }
    running_ = nullptr;
  }

  void stop()
  {
    this->endPhase();
    took_["total"] = milliseconds(CLOCK_THREAD_CPUTIME_ID) - begin_;
    took_["wall"] = milliseconds(CLOCK_MONOTONIC) - beginOnTheWall_;
  }

  void addTo(Measured& measured) const
  {
    for (const auto& [name, time] : took_)
    {
      measured.times[name].push_back(time);
    }
  }

private:
  double begin_;
  double beginOnTheWall_;
  double phaseBegin_ = 0;
  const char* running_ = nullptr;
  std::map<std::string, double> took_;
};

/// All configurations on the same points.
class Experiment
{
public:
  Experiment(std::vector<Point> points, bool validateCgal)
    : points_(std::move(points))
    , validateCgal_(validateCgal)
  {
  }

  void run(const Configuration& configuration, Measured& measured)
  {
    configuration.isCgal ? this->runCgal(measured) : this->runEngine(configuration, measured);
    malloc_trim(0);
  }

  void count(const Configuration& configuration, Measured& measured) const
  {
    if (configuration.isCgal)
    {
      return;
    }
    Workspace workspace;
    Triangulation made;
    Options options = this->withLimit(configuration.options);
    options.countWork = true;
    if (triangulate(viewOf(points_), options, workspace, {}, made) != Status::Ok)
    {
      measured.faults += "the counting run failed; ";
    }
    measured.work = made.report();
  }

private:
  /// A limit beyond all points means "as an explicit sequence, by one thread": the path of the
  /// other orders, unlike the default.
  Options withLimit(Options options) const
  {
    options.insertionLimit = options.insertionLimit > 0 ? points_.size() : 0;
    return options;
  }

  void runEngine(const Configuration& configuration, Measured& measured)
  {
    const Options options = this->withLimit(configuration.options);
    const PointView view = viewOf(points_);
    Stopwatch watch;
    Workspace workspace;
    Triangulation made;
    Status status = triangulate(view, options, workspace, { &watch, nullptr }, made);
    watch.endPhase();
    const std::size_t triangles = made.report().triangles;
    const std::unique_ptr<std::int32_t[]> triples(new std::int32_t[3 * triangles]);
    if (status == Status::Ok)
    {
      status = made.writeTriangles(triples.get(), { &watch, nullptr });
    }
    watch.stop();
    watch.addTo(measured);
    measured.triangles = triangles;
    if (status != Status::Ok)
    {
      measured.faults += "the run failed; ";
      return;
    }
    this->check(made, triples.get(), measured);
  }

  void check(Triangulation& made, const std::int32_t* triples, Measured& measured)
  {
    const std::size_t numbers = 3 * measured.triangles;
    if (right_.empty())
    {
      std::vector<std::int64_t> pointStatus(points_.size());
      made.writePointStatus(pointStatus.data(), {});
      right_.assign(triples, triples + numbers);
      measured.faults += joined(certify(viewOf(points_), right_, pointStatus));
      measured.checked = "certificate";
      return;
    }
    if (numbers != right_.size() || !std::equal(right_.begin(), right_.end(), triples))
    {
      measured.faults += "not the same triangles as the first run; ";
    }
    measured.checked = measured.checked.empty() ? "same bytes" : measured.checked;
  }

  void runCgal(Measured& measured)
  {
#ifdef AHD_WITH_CGAL
    const CgalRun cgal(points_);
    Stopwatch watch;
    measured.triangles = cgal.triangulate([&watch] { watch.stop(); });
    watch.addTo(measured);
    if (!right_.empty() && 3 * measured.triangles != right_.size())
    {
      measured.faults += "not as many triangles as the engine; ";
    }
    if (validateCgal_ && measured.checked.empty() && !cgal.isValid())
    {
      measured.faults += "CGAL's is_valid() says no; ";
    }
    measured.checked = validateCgal_ ? "number of triangles, is_valid()" : "number of triangles";
#else
    measured.faults = "built without CGAL";
#endif
  }

  std::vector<Point> points_;
  bool validateCgal_;
  std::vector<std::int32_t> right_; ///< the triangles that were certified
};

// --- The command line
// -----------------------------------------------------------------------------

std::vector<std::string> split(const std::string& list, char separator)
{
  std::vector<std::string> words;
  std::stringstream stream(list);
  for (std::string word; std::getline(stream, word, separator);)
  {
    words.push_back(word);
  }
  return words;
}

/// The paper's settings for an order. False if there is no such order.
bool takeOrder(const std::string& name, Options& options)
{
  const std::map<std::string, InsertionOrder> orders{ { "RG", InsertionOrder::RegularGrid },
    { "MG", InsertionOrder::MultiGrid }, { "HG", InsertionOrder::AdaptiveHilbert } };
  const auto found = orders.find(name);
  if (found != orders.end())
  {
    options.order = found->second;
    options.controlPoints = name == "HG" ? ControlPoints::SingleLevel : ControlPoints::Off;
    options.insertionLimit = 1; // to be the number of points
  }
  return found != orders.end();
}

bool takeSetting(const std::string& word, Options& options)
{
  const std::map<std::string, ControlPoints> controls{ { "control=none", ControlPoints::Off },
    { "control=one", ControlPoints::SingleLevel }, { "control=every", ControlPoints::EveryLevel } };
  const auto found = controls.find(word);
  if (found != controls.end())
  {
    options.controlPoints = found->second;
    return true;
  }
  if (word == "genes=off" || word == "genes=on")
  {
    options.geneRotation = word == "genes=on";
    return true;
  }
  options.nmax = word.rfind("nmax=", 0) == 0 ? std::atoi(word.c_str() + 5) : 0;
  return options.nmax >= 1;
}

Configuration configurationOf(const std::string& name, std::string& error)
{
  Configuration result{ name, name == "CGAL", Options() };
  if (result.isCgal || name == "default")
  {
    return result;
  }
  const std::vector<std::string> words = split(name, ':');
  bool known = !words.empty() && takeOrder(words[0], result.options);
  for (std::size_t i = 1; known && i < words.size(); ++i)
  {
    known = takeSetting(words[i], result.options);
  }
  error += known ? "" : "not a configuration: " + name + "\n";
  return result;
}

/// Takes the flags that only this program has, and leaves the rest.
std::vector<Configuration> takeConfigurations(
  int& argc, char** argv, bool& validateCgal, std::string& error)
{
  const std::string prefix = "--configurations=";
  std::vector<Configuration> result;
  int kept = 1;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument == "--validate-cgal")
    {
      validateCgal = true;
    }
    else if (argument.rfind(prefix, 0) == 0)
    {
      for (const std::string& name : split(argument.substr(prefix.size()), ','))
      {
        result.push_back(configurationOf(name, error));
      }
    }
    else
    {
      argv[kept++] = argv[i];
    }
  }
  argc = kept;
  error += result.empty() ? "no configurations\n" : "";
  return result;
}

// --- The output
// -----------------------------------------------------------------------------------

void printTimes(const Measured& measured)
{
  for (const auto& [name, times] : measured.times)
  {
    std::printf(", \"%s\": [", name.c_str());
    for (std::size_t i = 0; i < times.size(); ++i)
    {
      std::printf("%s%.3f", i ? ", " : "", times[i]);
    }
    std::printf("]");
  }
}

void print(const Configuration& configuration, const Measured& measured)
{
  std::string faults = measured.faults;
  std::replace(faults.begin(), faults.end(), '\n', ' ');
  std::replace(faults.begin(), faults.end(), '"', '\'');
  std::printf("{\"configuration\": \"%s\", \"triangles\": %zu, \"checked\": \"%s\", "
              "\"faults\": \"%s\"",
    configuration.name.c_str(), measured.triangles, measured.checked.c_str(), faults.c_str());
  if (!configuration.isCgal)
  {
    std::printf(", \"np\": %.4f, \"nr\": %.4f", measured.work.np(), measured.work.nr());
  }
  printTimes(measured);
  std::printf("}\n");
  std::fflush(stdout);
}

int about()
{
  const char* cgal = "";
#ifdef AHD_WITH_CGAL
  cgal = CgalRun::version();
#endif
  std::printf(
    "{\"compiler\": \"%s\", \"flags\": \"%s\", \"cgal\": \"%s\"}\n", AHD_COMPILER, AHD_FLAGS, cgal);
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc == 2 && std::string(argv[1]) == "--about")
  {
    return about();
  }
  std::string error;
  bool validateCgal = false;
  const auto configurations = takeConfigurations(argc, argv, validateCgal, error);
  const BenchmarkFlags flags = takeFlags(argc, argv, error);
  if (!error.empty() || argc > 1 || flags.sizes.size() != 1 || flags.distributions.size() != 1)
  {
    std::fprintf(
      stderr, "%sone --sizes, one --distributions, and --configurations, please\n", error.c_str());
    return 1;
  }
  // Large blocks come from the system and go back to it, always: malloc would learn to keep them.
  mallopt(M_MMAP_THRESHOLD, 128 * 1024);
  mallopt(M_TRIM_THRESHOLD, 128 * 1024);

  Experiment experiment(makePoints(flags.distributions[0], flags.sizes[0], 1), validateCgal);
  std::vector<Measured> measured(configurations.size());
  for (std::size_t round = 0; round < std::size_t(flags.repeat); ++round)
  {
    for (std::size_t i = 0; i < configurations.size(); ++i)
    {
      const std::size_t turn = (i + round) % configurations.size(); // none always begins
      experiment.run(configurations[turn], measured[turn]);
    }
  }
  bool ok = true;
  for (std::size_t i = 0; i < configurations.size(); ++i)
  {
    experiment.count(configurations[i], measured[i]);
    print(configurations[i], measured[i]);
    ok = ok && measured[i].faults.empty();
  }
  return ok ? 0 : 1;
}
