// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRoute_h
#define vtkAHDRoute_h

#include "Engine/Distribute/BlockRoute.h"
#include "Ranks/vtkAHDRanks.h"

#include <cstddef>

class vtkAbstractArray;

/// The engine's route, for VTK's arrays.
class vtkAHDRoute : public ahd::BlockRoute
{
public:
  /// Borrows both.
  vtkAHDRoute(vtkAHDRanks& ranks, const vtkAHDContext& context)
    : ahd::BlockRoute(ranks.GetOwn(), ranks.GetCount(), ranks, context.WithoutPhases())
    , Ranks(ranks)
    , Context(context)
  {
  }

  /// Moves the tuples of an array to `to`, after its first `first` ones; `to` has the same type
  /// and is large enough. `from` may be `to`. All ranks have arrays of the same type. Collective;
  /// throws vtkAHDStop on all ranks if one of them fails.
  void Move(vtkAbstractArray* from, vtkAbstractArray* to, std::size_t first);

  /// Can arrays of this type be moved?
  static bool CanMove(vtkAbstractArray* array);

private:
  void MoveStrings(vtkAbstractArray* from, vtkAbstractArray* to, std::size_t first);

  vtkAHDRanks& Ranks;
  const vtkAHDContext& Context;
};

#endif
