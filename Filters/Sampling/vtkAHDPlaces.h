// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDPlaces_h
#define vtkAHDPlaces_h

#include "Engine/Core/Uninitialised.h"
#include "Engine/Prepare/Prepare.h"
#include "Engine/Sample/Sample.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDPointsView.h"
#include "Pipeline/vtkAHDSettings.h"
#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <memory>

/**
 * The places of an interpolation: the points of a data set, in the plane of a triangulation. Read
 * in place if they have coordinates in memory and the plane is x, y; else copied. Holds the
 * data set.
 */
class vtkAHDPlaces
{
public:
  explicit vtkAHDPlaces(vtkDataSet* places);

  std::size_t GetCount() const { return this->Count; }

  /// Bytes that Open() allocates.
  std::size_t EstimateBytes(bool isProjected) const;

  /// The places in the plane of `points`, valid as long as this object and the data
  /// set. Throws vtkAHDStop and std::bad_alloc.
  ahd::PointView Open(
    const vtkAHDSettings& settings, const ahd::PreparedInput& points, const vtkAHDContext& context);

private:
  void Read(const vtkAHDContext& context);
  void Move(const ahd::PointView& from, const vtkAHDSettings& settings,
    const ahd::PreparedInput& points, const vtkAHDContext& context);

  const vtkSmartPointer<vtkDataSet> Set;
  const std::size_t Count;
  std::unique_ptr<vtkAHDPointsView> View; // if it is a vtkPointSet
  ahd::UninitialisedVector<double> Copy;
};

#endif
