// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeasuresAfterUpdate_h
#define MeasuresAfterUpdate_h

/// Called when the plugin is loaded. ParaView fetches information properties when it prepares a
/// run, not when the run is over, so a panel would show the measures of the run before the last.
/// From now on those of AdaptiveHilbertDelaunay2D are fetched again after each run. Does nothing on
/// a server, which has no properties.
void FetchMeasuresAfterUpdate();

#endif
