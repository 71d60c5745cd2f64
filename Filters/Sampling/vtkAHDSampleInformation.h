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

/// Are there filters behind this output? Each of them holds this information, and but for them only
/// the filter's own executive need: who else does counts as one of them. Which they are nobody can
/// say: VTK's list of consumers keeps those that were deleted.
bool vtkAHDHasFiltersBehind(vtkInformation* info);

/// What filters behind were told of the raster, as far as they ask for it; empty: nothing.
ahd::SampleRaster vtkAHDToldRaster(vtkInformation* info);

/// Filters for images read as many pixels as they were told of, whether or not these are there: so
/// makes the raster at least that large. If no point says where it is to be, it is the one that
/// they were told of. Returns whether it is another then.
bool vtkAHDCover(const ahd::SampleRaster& told, vtkAHDRaster& raster);

/// Do heights and mask of these cells alone take more memory than this limit in KiB, or, if that is
/// 0, than there is?
bool vtkAHDIsLarger(const ahd::SampleRaster& cells, vtkTypeInt64 limit);

#endif
