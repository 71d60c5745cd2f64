// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSampleInformation_h
#define vtkAHDSampleInformation_h

#include "Sampling/vtkAHDRaster.h"
#include "vtkType.h"

class vtkDataObject;
class vtkInformation;

/// Announces the image of this raster to VTK's pipeline: its extent, empty if there is
/// no raster, origin and spacing.
void vtkAHDAnnounceRaster(const vtkAHDRaster& raster, vtkInformation* info);

/// Does this image or grid differ from the announced one? The points then were those of another
/// time step.
bool vtkAHDIsNotAnnounced(vtkDataObject* made, vtkInformation* info);

/// Does it have the whole extent that downstream filters request?
bool vtkAHDHasAllThatIsWanted(vtkDataObject* made, vtkInformation* info);

/// Are there filters downstream of this output? Each of them holds this information, besides only
/// the filter's own executive; any other holder counts as one of them. They cannot be
/// identified: VTK's list of consumers also has deleted ones.
bool vtkAHDHasFiltersBehind(vtkInformation* info);

/// The part of the announced raster that downstream filters request; empty: none.
ahd::SampleRaster vtkAHDToldRaster(vtkInformation* info);

/// Image filters read as many pixels as were announced, whether or not these exist: so
/// makes the raster at least that large. If no point determines its bounds, it is the announced
/// one. Returns whether it differs then.
bool vtkAHDCover(const ahd::SampleRaster& told, vtkAHDRaster& raster);

/// Do heights and mask of these cells alone take more memory than this limit in KiB, or, if it is
/// 0, than available?
bool vtkAHDIsLarger(const ahd::SampleRaster& cells, vtkTypeInt64 limit);

#endif
