# SPDX-License-Identifier: BSD-3-Clause
#
# The engine does some things for tens of thousands of points only: it shares work among threads,
# sorts in several passes, polls for cancellation. ahd_copy_with_small_thresholds(<folder>) makes a
# copy of its sources in which a few points are enough, so that small inputs reach all of it.
set(ahd_small_thresholds
  "Triangulation/State.h|kLeastForThreads = 15000|kLeastForThreads = 12"
  "Insert/Insert.h|kLeastShared = 30000|kLeastShared = 16"
  "Insert/ByRounds.cxx|kLeastPart = 512|kLeastPart = 2"
  "Insert/Parts.h|kFew = 256|kFew = 2"
  "Core/Chunks.h|kChunk = std::size_t(1) << 12|kChunk = std::size_t(1) << 3"
  "Core/Progress.h|kStepsPerAsking = std::size_t(1) << 14|kStepsPerAsking = std::size_t(1) << 6"
  "Constrain/EdgeRows.h|kStride = 32|kStride = 2"
  "Constrain/InCurveOrder.h|kMostInOrder = 32|kMostInOrder = 1"
  "Constrain/InCurveOrder.h|kCrossingAtLeast = 64|kCrossingAtLeast = 2"
  "Constrain/PolygonFiller.cxx|kManyCorners = 48|kManyCorners = 6"
  "Order/Scatter.cxx|kBucket = 256|kBucket = 8"
  "Order/Scatter.cxx|kMostTasks = 128|kMostTasks = 8"
  "Order/BucketSorter.h|kSmall = 1024|kSmall = 16"
  "Order/BucketSorter.cxx|kMostSplitBits = 11|kMostSplitBits = 5"
  "Order/BucketSorter.h|kCrowdedBin =\n    24|kCrowdedBin =\n    3"
  "Order/BoxWalk.h|kFew = 64|kFew = 4"
  "Order/Rank.h|kTiedByCoordinates = 16|kTiedByCoordinates = 3"
  "Order/HilbertKeys.h|kKeyBlock = 256|kKeyBlock = 16"
  "Extract/SortKeys.h|kMostKeys = 4096|kMostKeys = 64")

function (ahd_copy_with_small_thresholds folder)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS RELATIVE "${ahd_root_dir}/Filters/Engine"
    "${ahd_root_dir}/Filters/Engine/*.h" "${ahd_root_dir}/Filters/Engine/*.cxx")
  foreach (source IN LISTS sources)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
      "${ahd_root_dir}/Filters/Engine/${source}")
    configure_file("${ahd_root_dir}/Filters/Engine/${source}" "${folder}/original/${source}" COPYONLY)
    file(READ "${folder}/original/${source}" text)
    foreach (threshold IN LISTS ahd_small_thresholds)
      string(REPLACE "|" ";" parts "${threshold}")
      list(GET parts 0 file)
      list(GET parts 1 old)
      list(GET parts 2 new)
      if (file STREQUAL source)
        string(FIND "${text}" "${old}" at)
        if (at EQUAL -1)
          message(FATAL_ERROR "${file} no longer says \"${old}\": mend SmallThresholds.cmake")
        endif ()
        string(REPLACE "${old}" "${new}" text "${text}")
      endif ()
    endforeach ()
    file(CONFIGURE OUTPUT "${folder}/${source}" CONTENT "${text}" @ONLY)
  endforeach ()
endfunction ()
