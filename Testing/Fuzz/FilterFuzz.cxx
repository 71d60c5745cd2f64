// SPDX-License-Identifier: BSD-3-Clause
//
// Bytes become a data set of any kind, a source and settings (FilterCase.h), and the filter runs on
// them: aborted once, then several times with changes between, each time held to what its
// documentation says of the outputs, and compared with a filter that is new and has other threads.
// Nothing may be said by others than the filter and its pipeline, and the input stays as it is.
#include "FilterJudge.h"

#include "vtkAdaptiveHilbertDelaunay2D.h"
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

/// VTK is not compiled with the sanitizers, and leaves some things to the end of the program. What
/// it allocates is much: short stacks and a small quarantine make this thrice as fast.
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

/// Hears what VTK's own classes say; but not of an input that already has normals or the like of a
/// number of components they cannot have, as VTK lets one make: that is worth its warning.
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

/// A filter that is heard, and aborted at the given progress event, if any.
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

  /// Updates, and complains of what is wrong.
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
  vtkAdaptiveHilbertDelaunay2D* filter() { return filter_; }

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

  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter_;
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

void run(FilterCase& given)
{
  const std::string before = textOf(given.input()) + textOf(given.source());
  Watched watched(given, 0);
  if (given.head(kAbortAt) > 0)
  {
    watched.update(given.head(kAbortAt));
  }
  for (unsigned step = 0; step < 3; ++step)
  {
    watched.update();
    if (step != 1) // the second only prepares for the third, which may pass on what was kept
    {
      Watched fresh(given, 1);
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
  ahd::fuzz::run(given);
  return 0;
}
