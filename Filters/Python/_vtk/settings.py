# SPDX-License-Identifier: BSD-3-Clause
"""The settings of vtkAdaptiveHilbertDelaunay2D as a table, and VTK's methods for each: SetX, GetX, XOn, XOff, SetXToY,
GetXMinValue, GetXMaxValue."""

import operator
import re

INT_MAX = 2**31 - 1
INT64_MAX = 2**63 - 1
DOUBLE_MAX = 1.0e299  # VTK_DOUBLE_MAX


class Setting:
    """One setting. `kind`: bool, flag (a vtkTypeBool: any int), enum, int, any (int), int64 or double. `least`,
    `most`: what values are clamped to. `names`: of an enum, what follows SetXTo for 0, 1, ... `about`: what it does."""

    def __init__(self, name, kind, default, about, least=None, most=None, names=()):
        self.name, self.kind, self.default, self.about, self.names = name, kind, default, about, names
        self.least, self.most = (0, len(names) - 1) if kind == "enum" and most is None else (least, most)

    def convert(self, value, now):
        """The value as the setting has it. TypeError for what is none, OverflowError for what VTK's type cannot
        hold."""
        if self.kind == "bool":
            return bool(value)
        if self.kind == "double":
            value = _as_double(value)
            return now if value != value else min(max(value, self.least), self.most)
        value = operator.index(value)
        largest = INT64_MAX if self.kind == "int64" else INT_MAX
        if not -largest - 1 <= value <= largest:
            raise OverflowError("value is out of range for %s" % ("long long" if self.kind == "int64" else "int"))
        return value if self.kind in ("flag", "any") else min(max(value, self.least), self.most)

    def text(self, value):
        """As PrintSelf has it."""
        return ("On" if value else "Off") if self.kind in ("bool", "flag") else "%g" % value if (
            self.kind == "double") else str(value)


def _as_double(value):
    if isinstance(value, (str, bytes)) or not (hasattr(value, "__float__") or hasattr(value, "__index__")):
        raise TypeError("a float is required, not %s" % type(value).__name__)
    return float(value)


CHANGES_TIME = " Changes the time, never the triangles."
NO_EFFECT = "No effect; here for programs written for vtkDelaunay2D."

INSERTION = (
    Setting("InsertionOrder", "enum", 0, "In which order points are inserted." + CHANGES_TIME,
            names=("AdaptiveHilbert", "MultiGrid", "RegularGrid", "AsGiven")),
    Setting("Nmax", "int", 50, "A box of the grid with more points than this is divided." + CHANGES_TIME, 1, INT_MAX),
    Setting("ControlPoints", "enum", 2, "Which points are inserted before all others." + CHANGES_TIME,
            names=("None", "SingleLevel", "EveryLevel")),
    Setting("GeneRotation", "bool", True, "Turn the curve inside each divided box." + CHANGES_TIME),
    Setting("RandomPointInsertion", "flag", 0, NO_EFFECT),
    Setting("UseHilbertSorter", "flag", 0, NO_EFFECT),
    Setting("CountWork", "bool", False, "Count NP and NR; one thread inserts."),
    Setting("InsertionLimit", "int64", 0, "Stop after so many distinct points; 0: all.", 0, INT64_MAX),
    Setting("GeneratePointStatus", "bool", False, 'Add the point array "Fate", the status of each point.'),
    Setting("GenerateConstraintEdges", "bool", False,
            'Add the cell array "ConstraintEdges": which edges of a triangle are constraints, as a sum of 1, 2, 4.'),
    Setting("GenerateRegionIds", "bool", False, 'Add the cell array "RegionId": what constraints separate.'),
    Setting("GenerateNeighbors", "bool", False, 'Add the cell array "Neighbors": the cells beyond the edges, or -1.'),
    Setting("GenerateInsertionRank", "bool", False, 'Add the point array "InsertionRank".'),
    Setting("GenerateInsertionCurve", "bool", False, "A polyline through the inserted points in output port 1."),
    Setting("GenerateBoxes", "bool", False, "The boxes of the grid in output port 1."),
    Setting("MemoryLimit", "int64", 0, "The most memory that may be taken, KiB; 0: what there is.", 0, INT64_MAX),
    Setting("NumberOfThreads", "int", 0, "How many threads work; 0: one for each processor, as vtkSMPTools allows."
            + CHANGES_TIME, 0, 1024),
    Setting("ReuseLimit", "int64", 262144, "The most working memory kept for the next execution, KiB.", 0, INT64_MAX),
    Setting("KeepTriangulation", "bool", True,
            "Pass on the triangles of the last execution where nothing has changed."),
)

SURFACE = (
    Setting("SourceMode", "enum", 0, "What the source's cells refer to: ids of the input, or the source's own points.",
            names=("Ids", "Coordinates")),
    Setting("CrossingMode", "enum", 0, "Of constraints that cross, leave out the later one, or split both.",
            names=("LeaveOut", "Split")),
    Setting("ClosedLines", "enum", 0, "What lines are that end where they begin: lines, or loops as polygons are.",
            names=("Lines", "Loops")),
    Setting("SourceHeights", "enum", 0,
            "Which z the points of the source have: their own, or that of the input's surface.",
            names=("Own", "FromSurface")),
    Setting("FillRule", "enum", 0, "What loops keep: what is on their left, or inside an odd number of them.",
            names=("Orientation", "EvenOdd")),
    Setting("Alpha", "double", 0.0, "The largest circumradius in space; 0: no limit.", 0.0, DOUBLE_MAX),
    Setting("AlphaTris", "flag", 1, "With Alpha, put out triangles."),
    Setting("AlphaLines", "flag", 1, "With Alpha, put out edges of no triangle that is put out."),
    Setting("AlphaVerts", "flag", 1, "With Alpha, put out points of neither."),
    Setting("MaximumEdgeLength", "double", 0.0, "The longest edge in the plane; 0: no limit.", 0.0, DOUBLE_MAX),
    Setting("ProjectionPlaneMode", "enum", 0,
            "The plane of the triangulation: 0: x, y; 1: by Transform; 2: best fitting.", 0, 2),
    Setting("Rim", "enum", 0, "How far the surface reaches where no loop bounds it.",
            names=("Automatic", "ConvexHull", "Trimmed")),
    Setting("Tolerance", "double", 0.0, "Merge points nearer than this part of the diagonal of all.", 0.0, 1.0),
    Setting("DuplicatePolicy", "enum", 0, "Which of several points at one place is the vertex.",
            names=("First", "LowestZ", "HighestZ", "MeanZ")),
    Setting("Offset", "double", 1.0, "How far out the points of BoundingTriangulation lie, in diagonals.", 0.75,
            DOUBLE_MAX),
    Setting("BoundingTriangulation", "flag", 0, "Add vtkDelaunay2D's eight bounding points."),
    Setting("MergeBlocks", "bool", False, "Triangulate the points of all blocks together."),
    Setting("GenerateVoronoi", "bool", False, "Put the Voronoi diagram into output port 2."),
    Setting("VoronoiClip", "enum", 0, "Where outer Voronoi cells end: at the hull or the bounding box of the points.",
            names=("Hull", "Bounds")),
    Setting("DistributePoints", "bool", False,
            "No effect in this class, which knows no ranks: on several, each triangulates its own points."),
)

SETTINGS = INSERTION + SURFACE

# Of vtkPlanarPointSource.
SOURCE = (
    Setting("Distribution", "enum", 0, "How the points are distributed.",
            names=("Uniform", "Line", "Cross", "Circle", "Spiral", "Mixed", "Lattice")),
    Setting("NumberOfPoints", "int64", 10000, "How many points.", 0, 2**29),
    Setting("Seed", "any", 1, "Where the random numbers start."),
    Setting("OutputPointsPrecision", "int", 1, "0: float; 1, 2: double.", 0, 2),
)
BY_NAME = {setting.name: setting for setting in SETTINGS}

CONSTANTS = {
    "ADAPTIVE_HILBERT": 0, "MULTI_GRID": 1, "REGULAR_GRID": 2, "AS_GIVEN": 3,
    "NO_CONTROL_POINTS": 0, "SINGLE_LEVEL": 1, "EVERY_LEVEL": 2,
    "SOURCE_IDS": 0, "SOURCE_COORDINATES": 1, "LEAVE_OUT": 0, "SPLIT": 1, "LINES": 0, "LOOPS": 1,
    "OWN": 0, "FROM_SURFACE": 1, "ORIENTATION": 0, "EVEN_ODD": 1,
    "FIRST": 0, "LOWEST_Z": 1, "HIGHEST_Z": 2, "MEAN_Z": 3,
    "CLIP_TO_HULL": 0, "CLIP_TO_BOUNDS": 1, "AUTOMATIC": 0, "CONVEX_HULL": 1, "TRIMMED": 2,
}

COUNTS = (
    "NumberOfPointsInserted", "NumberOfDuplicates", "NumberOfRejectedPoints", "NumberOfSkippedPoints",
    "NumberOfPointsBeyondLimit", "NumberOfTriangles", "NumberOfMergedPoints", "NumberOfAddedPoints",
    "NumberOfConstraintEdges", "NumberOfCrossings", "NumberOfBentConstraints", "NumberOfConstraintsLeftOut",
    "NumberOfUnfilledLoops", "NumberOfTrimmedTriangles")
# In the order in which the compiled class prints them; what they are before an execution, and after one that failed.
MEASURES = {
    "NumberOfPointsInserted": 0, "NumberOfDuplicates": 0, "NumberOfRejectedPoints": 0, "NumberOfSkippedPoints": 0,
    "NumberOfPointsBeyondLimit": 0, "NumberOfTriangles": 0, "NP": -1.0, "NR": -1.0, "SortSeconds": 0.0,
    "InsertSeconds": 0.0, "OutputSeconds": 0.0, "NumberOfThreadsUsed": 0, "NumberOfTriangulations": 0,
    "MemoryEstimate": 0, "NumberOfMergedPoints": 0, "NumberOfAddedPoints": 0, "NumberOfConstraintEdges": 0,
    "NumberOfCrossings": 0, "NumberOfBentConstraints": 0, "NumberOfConstraintsLeftOut": 0, "NumberOfUnfilledLoops": 0,
    "NumberOfTrimmedTriangles": 0, "ConstrainSeconds": 0.0}
SECONDS = ("SortSeconds", "InsertSeconds", "OutputSeconds", "ConstrainSeconds")


def _method(name, function, about):
    function.__name__ = name
    function.__doc__ = about
    return function


def _setter(setting):
    def set_it(self, value):
        self._set(setting, value)

    return set_it


def _getter(name):
    return lambda self: self._values[name]


def _sets_to(setting, value):
    return lambda self: getattr(self, "Set" + setting.name)(value)


def _answers(value):
    return lambda self: value


def methods_of(setting):
    """VTK's methods for one setting, by name."""
    name = setting.name
    made = {
        "Set" + name: _method("Set" + name, _setter(setting), "%s Default %s." % (setting.about, setting.default)),
        "Get" + name: _method("Get" + name, _getter(name), setting.about)}
    if setting.kind in ("bool", "flag"):
        for end, value in (("On", 1), ("Off", 0)):
            made[name + end] = _method(name + end, _sets_to(setting, value), setting.about)
    elif name != "MaximumEdgeLength" and setting.kind != "any":
        for end, value in (("MinValue", setting.least), ("MaxValue", setting.most)):
            made["Get" + name + end] = _method("Get" + name + end, _answers(value), "The %s value of %s." % (
                "smallest" if end == "MinValue" else "largest", name))
    for value, word in enumerate(setting.names):
        full = "Set%sTo%s" % (name, word)
        made[full] = _method(full, _sets_to(setting, value), setting.about)
    return made


def all_methods():
    """The methods and constants of all settings and measures, by name."""
    made = dict(CONSTANTS)
    for setting in SETTINGS:
        made.update(methods_of(setting))
    for end in ("SetGenerateFate", "GetGenerateFate", "GenerateFateOn", "GenerateFateOff"):
        made[end] = _renamed(end, end.replace("Fate", "PointStatus"))
    for name in MEASURES:
        made["Get" + name] = _method("Get" + name, _getter(name), "%s of the last execution." % name)
    return made


def properties_of(kind, names=tuple(BY_NAME) + tuple(MEASURES) + (
        "Transform", "Source", "SourceData", "SourceConnection", "Input", "InputData", "Output")):
    """VTK's properties for the methods SetX and GetX of a class, by name."""
    made = {}
    for name in names:
        get, set_ = getattr(kind, "Get" + name, None), getattr(kind, "Set" + name, None)
        if name in ("SourceData", "InputData"):
            get = None  # what VTK's algorithms in Python call so is another thing
        made[snake_case(name)] = property(get, set_, doc=(get or set_).__doc__)
    return made


def _renamed(name, now):
    return _method(name, lambda self, *given: getattr(self, now)(*given), "The old name of %s." % now)


def snake_case(name):
    """The name of VTK's property for a setting: alpha_tris."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower()
