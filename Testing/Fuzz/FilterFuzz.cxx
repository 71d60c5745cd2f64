// SPDX-License-Identifier: BSD-3-Clause
//
// Bytes become a data set of any kind, a source and settings (FilterCase.h), and a filter, that of
// triangulations or that of quality meshes, runs on them: aborted once, then several times with
// changes between, each time checked against the documentation of the outputs, and compared with a
// new filter with other threads. Only the filter and its pipeline may report messages, and the
// input stays unchanged.
#include "FilterJudge.h"
#include "MeshJudge.h"

#include "vtkAdaptiveHilbertDelaunay2D.h"
#include "vtkAdaptiveHilbertQualityMesh2D.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

/// VTK is not compiled with the sanitizers, and frees some things only at the end of the program.
/// It allocates much: short stacks and a small quarantine make this three times as fast.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options()
{
  return "detect_container_overflow=0:alloc_dealloc_mismatch=0:detect_leaks=0:"
         "malloc_context_size=4:quarantine_size_mb=16";
}

namespace ahd
{
namespace fuzz
{
namespace
{

/// Records messages of VTK's own classes; but not about an input whose normals or the like have a
/// wrong number of components, which VTK permits: that deserves its warning.
class Ear : public vtkOutputWindow
{
public:
  static Ear* New();
  vtkTypeMacro(Ear, vtkOutputWindow);
  void DisplayText(const char* text) override
  {
    if (Listens && !std::strstr(text, "Can not set attribute"))
    {
      Heard += text;
    }
  }

  bool Listens = false;
  std::string Heard;
};
vtkStandardNewMacro(Ear);

Ear& ear()
{
  static Ear* const own = []
  {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    Ear* const window = Ear::New();
    vtkOutputWindow::SetInstance(window);
    return window;
  }();
  return *own;
}

[[noreturn]] void complain(const std::string& what, const std::string& more = "")
{
  std::fprintf(stderr, "The filter made %s\n%s\n", what.c_str(), more.c_str());
  std::abort();
}

/// `Filter`: its class. One whose messages are recorded, aborted at the given progress event, if
/// any.
template <typename Filter>
class Watched
{
public:
  explicit Watched(const FilterCase& given, unsigned run)
  {
    given.configure(filter_, run);
    filter_->SetInputDataObject(0, given.input());
    filter_->SetInputDataObject(1, given.source());
    callback_->SetClientData(this);
    callback_->SetCallback(&Watched::hear);
    for (const auto event : { vtkCommand::WarningEvent, vtkCommand::ErrorEvent })
    {
      filter_->AddObserver(event, callback_);
      filter_->GetExecutive()->AddObserver(event, callback_);
    }
    filter_->AddObserver(vtkCommand::ProgressEvent, callback_);
  }

  /// Updates, and reports faults.
  void update(unsigned abortAt = 0)
  {
    said_ = false;
    abortAt_ = abortAt;
    ear().Heard.clear();
    ear().Listens = true;
    filter_->Update();
    ear().Listens = false;
    if (!ear().Heard.empty())
    {
      complain("VTK say:", ear().Heard);
    }
    const std::string fault = faultOf(filter_, said_);
    if (!fault.empty())
    {
      complain(fault, outputsOf(filter_));
    }
    if (abortAt > 0)
    {
      filter_->SetAbortExecute(0);
      filter_->Modified();
    }
    abortAt_ = 0;
  }

  std::string outputs() { return outputsOf(filter_); }
  Filter* filter() { return filter_; }

private:
  static void hear(vtkObject* from, unsigned long event, void* self, void*)
  {
    auto* watched = static_cast<Watched*>(self);
    if (event != vtkCommand::ProgressEvent)
    {
      watched->said_ = watched->said_ || event == vtkCommand::ErrorEvent;
    }
    else if (watched->abortAt_ > 0 && --watched->abortAt_ == 0)
    {
      static_cast<vtkAlgorithm*>(from)->SetAbortExecute(1);
    }
  }

  vtkNew<Filter> filter_;
  vtkNew<vtkCallbackCommand> callback_;
  bool said_ = false;
  unsigned abortAt_ = 0;
};

void expectSame(const std::string& one, const std::string& other, const char* what)
{
  if (one != other)
  {
    complain(what, one + "\nand\n" + other);
  }
}

template <typename Filter>
void run(FilterCase& given)
{
  const std::string before = textOf(given.input()) + textOf(given.source());
  Watched<Filter> watched(given, 0);
  if (given.head(kAbortAt) > 0)
  {
    watched.update(given.head(kAbortAt));
  }
  for (unsigned step = 0; step < 3; ++step)
  {
    watched.update();
    if (step != 1) // the second only prepares for the third, which may pass on kept outputs
    {
      Watched<Filter> fresh(given, 1);
      fresh.update();
      expectSame(watched.outputs(), fresh.outputs(), "something else than a new filter");
    }
    if (step == 0)
    {
      expectSame(before, textOf(given.input()) + textOf(given.source()), "another input");
    }
    given.change(step);
    given.configure(watched.filter(), 0);
  }
}

} // namespace
} // namespace fuzz
} // namespace ahd

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  ahd::fuzz::ear();
  ahd::fuzz::FilterCase given(data, size);
  given.head(ahd::fuzz::kMesh) == 0 ? ahd::fuzz::run<vtkAdaptiveHilbertDelaunay2D>(given)
                                    : ahd::fuzz::run<vtkAdaptiveHilbertQualityMesh2D>(given);
  return 0;
}
