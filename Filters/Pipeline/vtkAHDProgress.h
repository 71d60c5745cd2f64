// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDProgress_h
#define vtkAHDProgress_h

#include "Engine/Job/RunProgress.h"
#include "Pipeline/vtkAHDWatchedArrays.h"

class vtkAlgorithm;
class vtkDataObject;

/**
 * The progress of an execution for a VTK filter: reports to vtkAlgorithm::UpdateProgress, and
 * cancels on an abort. Observers may be slow, so they are called no more often than
 * ahd::RunProgress reports; they can draw and abort. The memory of arrays that are read is not
 * theirs to change: after that nothing is read any more.
 */
class vtkAHDProgress : public ahd::RunProgress
{
public:
  explicit vtkAHDProgress(vtkAlgorithm* filter, ahd::Clock clock = ahd::steadySeconds);

  /// The execution reads this data set: once an observer has given an array of it other memory or
  /// another size, it is cancelled, and the error reported. Null is nothing. Throws std::bad_alloc.
  void Watch(vtkDataObject* data) { this->Watched.Add(data); }

  /// Is anybody told of progress?
  bool IsObserved() const;

  /// While it lives, observers are told nothing, so what is watched stays as it is; it cancels if
  /// that has changed already. An abort counts.
  class Silence
  {
  public:
    explicit Silence(vtkAHDProgress& progress)
      : Of(progress)
    {
      this->Of.LookAtInput();
      ++this->Of.Silences;
    }
    ~Silence() { --this->Of.Silences; }
    Silence(const Silence&) = delete;
    void operator=(const Silence&) = delete;

  private:
    vtkAHDProgress& Of;
  };

protected:
  bool isCancelled() const override;
  void tell(double done, ahd::Phase phase) override;

private:
  void LookAtInput();

  vtkAlgorithm* const Filter;
  vtkAHDWatchedArrays Watched;
  bool InputIsChanged = false;
  int Silences = 0;
};

#endif
