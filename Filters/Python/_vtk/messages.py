# SPDX-License-Identifier: BSD-3-Clause
"""What the filter has to say, through VTK's channels: events, or its output window where nobody observes these. Word
for word as the compiled class (Filters/Execution/vtkAHDMessages.cxx)."""

import sys

from .. import _library as engine

OTHER_PLANE = "To triangulate a wall, set ProjectionPlaneMode to Best-Fitting Plane"


def _say(backend, algorithm, event, word, text):
    if not backend.vtkObject.GetGlobalWarningDisplay():
        return
    address = algorithm.GetAddressAsString("vtkObject").split("=")[-1]
    caller = sys._getframe(2)
    full = "%s: In %s, line %d\n%s (%s): %s\n\n" % (
        word, caller.f_code.co_filename, caller.f_lineno, algorithm.GetClassName(), address, text)
    if algorithm.HasObserver(event):
        algorithm.InvokeEvent(event, full)
        return
    window = backend.vtkOutputWindow.GetInstance()
    (window.DisplayErrorText if word == "ERROR" else window.DisplayWarningText)(full)


class Speaker:
    """Says things of one filter."""

    def __init__(self, backend, algorithm):
        self.backend, self.algorithm = backend, algorithm

    def warn(self, text):
        _say(self.backend, self.algorithm, "WarningEvent", "Warning", text)

    def error(self, text):
        _say(self.backend, self.algorithm, "ErrorEvent", "ERROR", text)


class Silence:
    """A Speaker of nobody."""

    def warn(self, text):
        pass

    error = warn


def size_in_words(size, up):
    """Bytes as a person writes them, with three digits at most, rounded up or down: Engine/Core/SizeInWords.h."""
    part, decimals, unit = 1, 0, 0
    while size // part + (up and size % part > 0) >= 1000:
        part, unit = part * 10, unit + (decimals == 0)
        decimals = decimals - 1 if decimals else 2
    number = size // part + (up and size % part > 0)
    number = ("%.2f" % (number / 10**decimals)).rstrip("0").rstrip(".")
    return "%s %s" % (number, "byte" if size == 1 else ("bytes", "KB", "MB", "GB", "TB", "PB", "EB")[unit])


def needed_in_words(kibibytes):
    return size_in_words(1024 * min(kibibytes, 2**53), True)


def but_allowed(kibibytes, is_limited, of=""):
    return ("MemoryLimit %sallows " % of if is_limited else "there are ") + size_in_words(
        1024 * min(kibibytes, 2**53), False)


def or_set_limit(kibibytes):
    """The way out."""
    return "or set MemoryLimit to %d or more (KiB)." % kibibytes


def error_text(status, job, values, more):
    """What ended an execution; None for one that was aborted. `values`: the filter's settings. `more`: for faults that
    are none of those below."""
    if status == engine.CANCELLED:
        return None
    if status == engine.BAD_ARRAY:
        return not_computed(more)
    if status > engine.TOO_MANY_CROSSINGS:
        return "%s. Nothing is put out." % more
    points, limited = job.count("points"), values["MemoryLimit"] > 0
    needed = job.count("memory_estimate") // 1024
    allowed = values["MemoryLimit"] if limited else job.count("memory_allowed") // 1024
    of_memory = "%s of memory, but %s. Nothing was computed." % (needed_in_words(needed), but_allowed(allowed, limited))
    if status == engine.TOO_MANY_POINTS:
        return too_many_points(points)
    if status == engine.TOO_MANY_BOXES:
        return (
            "The grid of %d points has more than %d boxes. Putting out more may take more than %s Switch GenerateBoxes "
            "off, take fewer points or a larger Nmax, %s" % (
                points, job.count("most_boxes"), of_memory, or_set_limit(needed)))
    if status == engine.TOO_MANY_CROSSINGS:
        return (
            "The lines and polygons of the source cross in more than %d places. Splitting them there and triangulating "
            "%d points and the crossings may take more than %s Take fewer lines, switch CrossingMode to Leave Out, %s"
            % (job.count("most_crossings"), points - job.count("most_crossings") - 1, of_memory, or_set_limit(needed)))
    if status == engine.MEMORY_LIMIT:
        return (
            "Triangulating %d points may take %s Take fewer points, switch off outputs that are not needed, %s" % (
                points, of_memory, or_set_limit(needed)))
    if status == engine.OUT_OF_MEMORY:
        also = ", and " + but_allowed(allowed, True) if limited and needed > allowed else ""
        return ("Out of memory while triangulating %d points; about %s are needed%s. Take fewer points, or switch off "
                "outputs that are not needed." % (points, needed_in_words(needed), also))
    raise ValueError(status)


def not_computed(why):
    return "%s. Nothing was computed." % why


def too_many_points(count):
    return "%d points are too many: at most %d can be triangulated." % (count, 2**28 - 2)


def warnings(job, values, found):
    """The texts, in order. `found`: what was found out beside the job: marks_are_unfit, input_points, source_points,
    source_vertices, source_strips, is_projected, adds_bounding, transform_is_missing, diagram_in_plane, cells."""
    return [text for part in (_of_plane, _of_points, _of_cells, _of_rim, _of_source, _of_constraints)
            for text in part(job, values, found)]


def _of_plane(_job, values, found):
    if found.transform_is_missing:
        yield "ProjectionPlaneMode asks for a Transform, but none is set: the points were triangulated in x and y."
    if values["BoundingTriangulation"] and not found.adds_bounding:
        yield ("There is no bounding triangulation, because the points are triangulated in another plane than x and y.")


def _of_points(job, _values, found):
    points = job.count("points")
    if found.marks_are_unfit:
        yield ("The point data array vtkGhostType does not have one value for each of the %d points, or is not of "
               "type unsigned char, so no point was skipped." % found.input_points)
    if job.count("not_finite"):
        yield "%d of %d points were left out, since %s; the first is point %d." % (
            job.count("not_finite"), points, "they have no finite place in the plane of the triangulation"
            if found.is_projected else "their x or y is NaN or infinite", job.count("first_not_finite"))
    if job.count("odd_z"):
        yield ("%d of %d points have a z that is NaN or infinite. They are part of the triangulation, which is "
               "computed in x and y, but cannot be drawn." % (job.count("odd_z"), points))


def _of_no_triangle(job, found):
    inserted, beyond = job.count("inserted"), job.count("beyond_limit")
    if beyond:
        return ("There is no triangle yet, because InsertionLimit has only the first %d of %d distinct points "
                "inserted, %s" % (
                    inserted, inserted + beyond, "fewer than three." if inserted < 3 else "and these are collinear."))
    merged = job.count("merged_points")
    looked = not found.is_projected
    return "There is no triangle, because %s%d distinct points among %d%s.%s" % (
        "there are fewer than three distinct points: " if inserted < 3 else "all distinct points are collinear: ",
        inserted, job.count("points"), ", of which Tolerance merged %d into others" % merged if merged else "",
        " They are not collinear in space. %s." % OTHER_PLANE if looked and not job.count("on_one_line") else "")


def _of_cells(job, values, found):
    triangles, delaunay = job.count("kept_triangles"), job.count("delaunay_triangles")
    if found.diagram_in_plane:
        yield "The Voronoi diagram lies in the plane z = 0, as Transform has no inverse to take it back to the points."
    if triangles and not found.cells:
        yield ("Nothing is put out: Alpha, its switches and MaximumEdgeLength leave none of %d %s, no line and no "
               "vertex. Larger numbers keep more, and 0 is no limit." % (
                   triangles, "triangle" if triangles == 1 else "triangles"))
    if delaunay == 0 and job.count("inserted") + job.count("not_finite") > 0:
        yield _of_no_triangle(job, found)
    looked = not found.is_projected and values["DuplicatePolicy"] == 0 and not job.count("beyond_limit")
    if delaunay and looked and job.count("stacked"):
        yield ("%d of %d points have the x and y of others and lie above or below them: of each stack one point is in "
               "the surface (see DuplicatePolicy). %s; of a volume mesh, triangulate one layer of points." % (
                   job.count("duplicates"), job.count("points"), OTHER_PLANE))
    if delaunay and triangles + job.count("trimmed_triangles") == 0:
        yield ("There is no triangle, because the polygons of the source keep none of the %d triangles (see FillRule)."
               % delaunay)


def _of_rim(job, _values, _found):
    """Of what is more than the slivers along a rim."""
    bare, area = job.count("bare_vertices"), job.measure("trimmed_area")
    if bare == 0 and not area > 0.1:
        return
    triangles, trimmed = job.count("kept_triangles"), job.count("trimmed_triangles")
    part = min(1.0, max(0.0, area)) if area == area else 0.0  # NaN where areas are beyond all doubles
    yield ("%s the rim took %s%d of %d triangles away, %d %% of the area in the plane, and left %d %s without a "
           "triangle. Set Rim to Convex Hull to keep them all." % (
               "Trimming" if triangles else "There is no triangle left: trimming", "" if triangles else "all ", trimmed,
               triangles + trimmed, int(100.0 * part + 0.5), bare, "point" if bare == 1 else "points"))


def _in_words(found):
    parts = ((found.source_points, "point", "points"), (found.source_vertices, "vertex", "vertices"),
             (found.source_strips, "triangle strip", "triangle strips"))
    return ", ".join("%d %s" % (count, one if count == 1 else many) for count, one, many in parts if count)


def _of_source(job, _values, found):
    strips = found.source_strips
    if found.source_points + strips > 0 and job.count("segments") == 0:
        yield "The source constrains nothing: it has no line and no polygon of two points or more. Found%s: %s." % (
            " (strips are ignored)" if strips else "", _in_words(found))
    elif strips:
        yield "%d triangle strip%s of the source %s ignored: lines and polygons constrain." % (
            strips, "" if strips == 1 else "s", "is" if strips == 1 else "are")
    if job.count("points_off_surface"):
        yield ("%d of %d points of the source lie outside the surface of the input and keep their own z (see "
               "SourceHeights)." % (job.count("points_off_surface"), found.source_points))


def _of_constraints(job, values, _found):
    of_all = " segments or pieces of segments" if values["CrossingMode"] else " of %d segments" % job.count("segments")
    unfilled, crossing = job.count("unfilled_loops"), job.count("segments_crossing")
    loops = " %d %s nothing, since a segment is missing." % (
        unfilled, "polygon bounds" if unfilled == 1 else "polygons bound") if unfilled else ""
    if crossing:
        yield ("%d%s of the source were left out, since they cross others that come before them; the first is in cell "
               "%d and crosses cell %d.%s" % (
                   crossing, of_all, job.count("first_crossing_cell"), job.count("first_crossed_cell"), loops))
        loops = ""
    bent = job.count("bent_segments")
    if bent:
        yield ("%d %s of the source %s by rounding, led through a point that is not exactly on %s; the first is in "
               "cell %d." % ((bent,) + (("segment", "bends", "it") if bent == 1 else ("segments", "bend", "them"))
                             + (job.count("first_bent_cell"),)))
    missing = job.count("segments_without_vertex")
    if job.count("unfit_ids"):
        yield ("%d%s of the source are no constraints: %d of the ids in its cells are not those of points, the first "
               "is %d in cell %d. They refer to the points of %s%s" % (
                   missing, of_all, job.count("unfit_ids"), job.count("first_unfit_id"), job.count("first_unfit_cell"),
                   "the source." if values["SourceMode"] else "the input (see SourceMode).", loops))
    elif missing and job.count("delaunay_triangles"):
        yield ("%d%s of the source are no constraints, since an end of theirs is a point that was rejected, is skipped "
               "or lies beyond InsertionLimit.%s" % (missing, of_all, loops))
