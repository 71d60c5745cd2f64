// SPDX-License-Identifier: BSD-3-Clause
#ifndef FilterObservers_h
#define FilterObservers_h

/// Called when the plugin is loaded. From now on each proxy of a filter of ours is
/// observed, for four things that ParaView does not do by itself.
///
/// It fetches information properties before a run, not after it, so a panel would show the measures
/// of the run before the last. They are fetched again after each run.
///
/// It offers every polygonal data set as a Source, those made from the filter's own output too, and
/// the update of such a circle never ends. A Source of this kind is taken away, with a warning, and
/// so are an Input and Places.
///
/// It knows no second name of a property. GeneratePointStatus has an old one, GenerateFate, which
/// is a property of its own, for older states and scripts: the two are kept equal.
///
/// It shows numbers that are out of a property's range, and such as stand for no entry of a list,
/// though the filter takes the nearest legal one. They are replaced by it, of the source of points
/// too.
///
/// Does nothing on a server, which has no properties.
void ObserveTheFilters();

#endif
