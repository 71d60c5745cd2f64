// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSampleInformation_h
#define vtkAHDSampleInformation_h

#include "Sampling/vtkAHDRaster.h"
#include "vtkType.h"

class vtkDataObject;
class vtkInformation;

/// Tells VTK's pipeline what the image of this raster will be like: its extent, empty if there is
/// no raster, origin and spacing.
void vtkAHDAnnounceRaster(const vtkAHDRaster& raster, vtkInformation* info);

/// Is this image or grid that was made another than was announced? Then its points were others at
/// that time, those of another time step.
bool vtkAHDIsNotAnnounced(vtkDataObject* made, vtkInformation* info);

/// Does it have all of the extent that filters behind ask for?
bool vtkAHDHasAllThatIsWanted(vtkDataObject* made, vtkInformation* info);

/// Is there a vtkImageAlgorithm among the filters behind this output? These read as many pixels as
/// were announced, whether or not they are there.
bool vtkAHDFeedsImageFilters(vtkInformation* info);

/// Do heights and mask of these cells alone take more memory than this limit in KiB, or, if that is
/// 0, than there is?
bool vtkAHDIsLarger(const ahd::SampleRaster& cells, vtkTypeInt64 limit);

#endif
