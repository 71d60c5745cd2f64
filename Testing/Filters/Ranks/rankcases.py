# SPDX-License-Identifier: BSD-3-Clause
"""The inputs for which several ranks must give the triangles of one.

A case is made alike on all ranks: what each rank has as input and source, and the settings of all. `pieces` deals
points out by their number, not by their place, so that nearly all of them have to move.
"""

import json
import math
import pathlib
import random

TABLE = json.loads(
    (pathlib.Path(__file__).resolve().parents[2] / "Support" / "settings.json").read_text(encoding="utf-8"))


# Settings that have an effect only with others, and these.
NEEDED = {"SourceHeights": {"SourceMode": 1}, "VoronoiPolygon": {"GenerateVoronoi": True, "VoronoiClip": 2},
          **{name + "ArrayName": {"MaximumError": 0.5} for name in ("Value", "Weight", "Keep")}}
# Settings of all ranks, and settings without effect that the last rank has besides.
WITHOUT_EFFECT = [
    ({"Rim": 1}, {"Rim": 0}),
    ({"Transform": True}, {"ProjectionPlaneMode": 1}),
    ({"SourceMode": 0}, {"SourceHeights": 1}),
    ({"VoronoiClip": 1}, {"VoronoiPolygon": "0 0, 1 1"}),
    ({"MaximumError": 0}, {"WeightArrayName": "w", "KeepArrayName": "k", "ValueArrayName": "v"}),
    ({"MaximumError": 0.5}, {"WeightArrayName": "None"}),
    ({"BoundingTriangulation": 1}, {"BoundingTriangulation": 2}),
]


def counts_of(table):
    """The measures that are counts."""
    return [name for name, row in TABLE[table]["measures"].items() if row["type"] == "id"]


def other_values(table):
    """Of each setting that must be the same on all ranks a value that is not its default, as arguments, and the
    settings that it needs to have an effect."""
    for name, row in TABLE[table]["settings"].items():
        default = row["default"]
        if row["ranks"] == "own":
            continue
        if row["type"] in ("bool", "flag"):
            other = not default
        elif row["values"]:
            other = (default - 1) % len(row["values"])
        elif row["type"] == "text":
            other = default + "s"
        else:
            other = (*default[:-1], default[-1] + 1) if isinstance(default, list) else 1 + (default or 0)
        yield name, other, NEEDED.get(name, {})


class Piece:
    """The input of one rank."""

    def __init__(self, points, number="double"):
        self.points = list(points)
        self.number = number
        self.marks = None  # ghost marks, one per point
        self.arrays = {}  # name: (type, values of each point)
        self.source = None  # (points, lines, polygons)
        self.source_arrays = {}  # of its points


def appended_id(i, first, count):
    """An id that is no point's on its rank is no point's on all."""
    return first + i if 0 <= i < count else i + 10 ** 7 if 0 <= i < 10 ** 5 else i


def appended(made, settings):
    """All pieces as one rank would have them."""
    numbers = {piece.number for piece in made if piece.points}
    whole = Piece([], "float" if numbers == {"float"} else "double")
    full = [piece for piece in made if piece.points] or [piece for piece in made if piece.arrays]
    common = [name for name in (full[0].arrays if full else ())
              if all(name in piece.arrays and piece.arrays[name][0] == full[0].arrays[name][0] for piece in full)]
    for name in common:
        whole.arrays[name] = (full[0].arrays[name][0], [value for piece in full for value in piece.arrays[name][1]])
    if any(piece.marks is not None for piece in made):
        whole.marks = [m for piece in made for m in (piece.marks or [0] * len(piece.points))]
    of_input = not settings.get("SourceMode")
    sources = [piece.source for piece in made]
    if not of_input and len(made) > 1 and all(source == sources[0] for source in sources):
        sources = sources[:1] + [None] * (len(made) - 1)
    points, lines, polygons = [], [], []
    for piece, source in zip(made, sources):
        if source:
            first = len(whole.points) if of_input else len(points)
            count = len(piece.points) if of_input else len(source[0])
            lines += [[appended_id(i, first, count) for i in ids] for ids in source[1]]
            polygons += [[appended_id(i, first, count) for i in ids] for ids in source[2]]
            points += source[0]
            for name, (kind, values) in piece.source_arrays.items():
                whole.source_arrays.setdefault(name, (kind, []))[1].extend(values)
        whole.points += piece.points
    whole.source = (points, lines, polygons) if any(sources) else None
    return whole


def pieces(points, ranks, number="double"):
    """Distributed in rows of 7 points each, with arrays that name them."""
    dealt = [[] for _ in range(ranks)]
    for i, point in enumerate(points):
        dealt[i // 7 % ranks].append(point)
    made = [Piece(own, number) for own in dealt]
    for rank, piece in enumerate(made):
        n = len(piece.points)
        piece.arrays = {
            "Float": ("float", [0.5 * i + rank for i in range(n)]),
            "Triple": ("double", [(i, rank, -i) for i in range(n)]),
            "Long": ("long", [2 ** 40 + i * ranks + rank for i in range(n)]),
            "Byte": ("byte", [(i + rank) % 256 for i in range(n)]),
            "Bit": ("bit", [(i + rank) % 2 for i in range(n)]),
            "Text": ("text", ["%d of %d" % (i, rank) * (i % 3) for i in range(n)]),
        }
    return made


def uniform(count, seed=1):
    draw = random.Random(seed)
    return [(draw.uniform(-1, 1), draw.uniform(-1, 1), draw.uniform(-1, 1)) for _ in range(count)]


def lattice(count, side, seed=1):
    """With many duplicates and cocircular points; z distinguishes the duplicates."""
    draw = random.Random(seed)
    return [(float(draw.randrange(side)), float(draw.randrange(side)), float(i % 5)) for i in range(count)]


def circle(count):
    turns = (0.1 + 2 * math.pi * i / count for i in range(count))
    return [(math.cos(turn), math.sin(turn), 0.0) for turn in turns]


def with_sources(made, segments, seed=3):
    """Each rank has lines between its own points, by their ids, and a polygon."""
    draw = random.Random(seed)
    for piece in made:
        n = len(piece.points)
        if n > 10:
            lines = [[draw.randrange(n) for _ in range(2 + k % 3)] for k in range(segments)]
            corners = sorted(draw.sample(range(n), 5), key=lambda i: math.atan2(piece.points[i][1], piece.points[i][0]))
            piece.source = ([], lines, [corners])
    return made


def with_unfit_ids(made, first):
    """A line of the last rank has ids of no point, `first` before others."""
    made = with_sources(made, 3)
    if made[-1].source:
        made[-1].source[1][1] = [0, first, 1, -5, len(made[-1].points)]
    return made


def bowed(side, seed=1):
    """A lattice whose sides bend inwards, but for noise: flat triangles all along its rim, some deep."""
    draw = random.Random(seed)
    at = [-1 + 2 * k / (side - 1) for k in range(side)]
    return [(x * (1 - 0.02 * (1 - abs(y))) + draw.uniform(-1, 1) * 1e-3,
             y * (1 - 0.02 * (1 - abs(x))) + draw.uniform(-1, 1) * 1e-3, 0.1 * x * y) for x in at for y in at]


def shuffled(points, seed=1):
    points = list(points)
    random.Random(seed).shuffle(points)
    return points


def tilted(points):
    """Far from the origin, in a plane that is nearly vertical."""
    return [(1e6 + 0.2 * x - 0.9 * y, 0.4 * x + 0.3 * y + z / 8, 50.0 + x + y / 3) for x, y, z in points]


def arc(count):
    """All triangles are flat."""
    return [(k / count, (k / count) ** 2 / 50, 0.0) for k in range(count)]


def ring(radius, count, turn=0.0):
    return [(radius * math.cos(turn + 2 * math.pi * k / count), radius * math.sin(turn + 2 * math.pi * k / count), 0.25)
            for k in range(count)]


def with_own_points(made):
    """Each rank's source has points of its own: a ring as a polygon, and a closed line."""
    for rank, piece in enumerate(made):
        outline = ring(0.9 - 0.1 * rank, 9, 0.3)
        inner = ring(0.2 + 0.05 * rank, 5, 0.1)
        closed = list(range(9, 14)) + [9]
        piece.source = (outline + inner, [closed], [list(range(9))])
    return made


def with_one_source(made):
    """All ranks have the same source."""
    for piece in made:
        piece.source = (ring(0.8, 12) + ring(0.4, 6), [], [list(range(12)), list(range(12, 18))])
    return made


def with_outline_in_pieces(made, missing=0):
    """Lines of two points that are one outline together, in any direction, dealt to the ranks; some are missing."""
    corners = ring(0.8, 12)
    for rank, piece in enumerate(made):
        own = [k for k in range(12 - missing) if k % len(made) == rank]
        points = [corners[(k + end) % 12] for k in own for end in ((0, 1) if k % 5 else (1, 0))]
        piece.source = (points, [[2 * i, 2 * i + 1] for i in range(len(own))], [])
    return made


def with_sources_moved(made, x=0.0, z=0.0, size=1.0):
    """Those of with_own_points, elsewhere or of another size."""
    for piece in with_own_points(made):
        points, lines, polygons = piece.source
        piece.source = ([(a * size + x, b * size, c + z) for a, b, c in points], lines, polygons)
    return made


def with_source_of_one_rank(points, ranks):
    """Points dealt by x; the first rank has the only source, among the points of the last."""
    points = sorted(points)
    size = -(-len(points) // ranks)
    made = [pieces(points[k * size:(k + 1) * size], 1)[0] for k in range(ranks)]
    made[0].source = ([(0.7 + x / 4, y / 4, z) for x, y, z in ring(1.0, 7)], [], [list(range(7))])
    return made


def with_marks(made):
    for piece in made[1:]:
        piece.marks = [(0, 1, 2, 0, 32)[i % 5] for i in range(len(piece.points))]
    return made


def uneven(points, ranks):
    """The last rank has everything, the others have nothing, not even arrays."""
    made = [Piece([]) for _ in range(ranks)]
    made[-1] = pieces(points, 1)[0]
    return made


def odd(points, ranks):
    """Points that are not finite, on one rank alone, and z and a value that are not."""
    made = pieces(points, ranks)
    own = made[-1].points
    own[3] = (math.nan, own[3][1], 0.0)
    own[4] = (own[4][0], math.inf, 0.0)
    own[5] = (own[5][0], own[5][1], math.nan)
    made[-1].arrays["Float"][1][-2] = math.nan
    return made


PARTIAL = ": Extra, Float, Long, Short, one without a name."


def partial(points, ranks):
    """Arrays that not all ranks have alike; a warning names them as PARTIAL does."""
    made = pieces(points, ranks)
    del made[0].arrays["Float"]
    made[-1].arrays["Long"] = ("float", [float(i) for i in range(len(made[-1].points))])
    made[-1].arrays["Extra"] = made[-1].arrays[None] = ("byte", [1] * len(made[-1].points))
    made[-1].arrays["Short"] = ("byte", [1])
    return made


def mixed(points, ranks):
    made = pieces(points, ranks)
    made[0].number = "float"
    made[0].points = [tuple(float(round(c * 64) / 64) for c in point) for point in made[0].points]
    return made


EVERYTHING = {"GeneratePointStatus": True, "GenerateConstraintEdges": True}
LOOPS = dict(EVERYTHING, FillRule=1)
COORDINATES = dict(LOOPS, SourceMode=1)


def cases(ranks):
    """name -> (pieces, settings)"""
    return dict(plain_cases(ranks), **ghost_cases(ranks), **plane_cases(ranks), **bounding_cases(ranks))


def plain_cases(ranks):
    return {
        "uniform": (pieces(uniform(2000), ranks), EVERYTHING),
        "floats": (pieces([tuple(round(c * 4096) / 4096 for c in p) for p in uniform(1500)], ranks, "float"),
                   EVERYTHING),
        "one point of floats on each rank": (
            [piece for i in range(ranks) for piece in pieces([(float(i), i * i / 4, 0.5)], 1, "float")], EVERYTHING),
        "mixed numbers": (mixed(uniform(500), ranks), EVERYTHING),
        "whole numbers": (pieces([tuple(float(round(c * 100)) for c in p) for p in uniform(500)], ranks, "int"),
                          EVERYTHING),
        "lattice": (pieces(lattice(3000, 25), ranks), EVERYTHING),
        "lowest of duplicates": (pieces(lattice(3000, 25), ranks), dict(EVERYTHING, DuplicatePolicy=1)),
        "mean of duplicates": (pieces(lattice(3000, 25), ranks), dict(EVERYTHING, DuplicatePolicy=3, GhostLevels=1)),
        "mean of floats": (pieces([(x / 7, y / 3, z / 11) for x, y, z in lattice(900, 12)], ranks, "float"),
                           dict(EVERYTHING, DuplicatePolicy=3)),
        "mean in a plane, not all finite": (odd([(x / 7, y / 3, x + z / 11) for x, y, z in lattice(900, 12)], ranks),
                                            dict(EVERYTHING, DuplicatePolicy=3, ProjectionPlaneMode=2)),
        "mean with sources' points": (with_own_points(pieces(lattice(900, 12), ranks)),
                                      dict(COORDINATES, DuplicatePolicy=3)),
        "highest of duplicates": (with_sources(pieces(lattice(2000, 25), ranks), 5),
                                  dict(EVERYTHING, DuplicatePolicy=2)),
        "circle": (pieces(circle(300), ranks), EVERYTHING),
        "one line": (pieces([(float(i), 2.0 * i, 0.0) for i in range(100)], ranks), EVERYTHING),
        "two points": (pieces([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0)], ranks), EVERYTHING),
        "nothing": (pieces([], ranks), EVERYTHING),
        "on one rank": (uneven(uniform(500), ranks), EVERYTHING),
        "marks": (with_marks(pieces(uniform(1000), ranks)), EVERYTHING),
        "not finite": (odd(uniform(500), ranks), EVERYTHING),
        "partial arrays": (partial(uniform(300), ranks), EVERYTHING),
        "lines and loops": (with_sources(pieces(uniform(1500), ranks), 12), EVERYTHING),
        "even-odd": (with_sources(pieces(uniform(1500), ranks), 4), LOOPS),
        "constraints on a lattice": (with_sources(pieces(lattice(1500, 30), ranks), 8), EVERYTHING),
        "sources' points": (with_own_points(pieces(uniform(800), ranks)), dict(COORDINATES, ClosedLines=1)),
        "sources' points, closed lines are lines": (with_own_points(pieces(uniform(800), ranks)), COORDINATES),
        "sources' points as floats": (with_own_points(pieces(uniform(200), ranks, "float")), COORDINATES),
        "source on an empty rank": (with_own_points(uneven(uniform(300), ranks)), COORDINATES),
        "outline in pieces": (with_outline_in_pieces(pieces(uniform(800), ranks)), dict(COORDINATES, ClosedLines=1)),
        "none is closed": (with_outline_in_pieces(pieces(uniform(800), ranks), 1), dict(COORDINATES, ClosedLines=1)),
        "sources elsewhere": (with_sources_moved(pieces(uniform(300), ranks), x=7.5), COORDINATES),
        "outlines around no point": (with_sources_moved(pieces(uniform(300), ranks), size=1e-4), COORDINATES),
        "sources without heights": (
            with_sources_moved(pieces([(x, y, z + 9) for x, y, z in uniform(300)], ranks), z=-0.25), COORDINATES),
        "source of one rank": (with_source_of_one_rank(uniform(400), ranks), COORDINATES),
        "one source": (with_one_source(pieces(uniform(800), ranks)), COORDINATES),
        "short edges": (with_sources(pieces(uniform(900), ranks), 4), dict(EVERYTHING, MaximumEdgeLength=0.09)),
        "no edge is short": (pieces(uniform(90), ranks), dict(EVERYTHING, MaximumEdgeLength=1e-9)),
        "a plane": (pieces(uniform(900), ranks), dict(EVERYTHING, Rim=1, Transform=True)),
        "unfit ids": (with_unfit_ids(pieces(uniform(60), ranks), 10 ** 6), EVERYTHING),
        "all dropped": (with_own_points(pieces([], ranks)), dict(COORDINATES, FillRule=0, turn=True)),
    }


def ghost_cases(ranks):
    return {
        "ghosts": (pieces(uniform(2000), ranks), dict(EVERYTHING, GhostLevels=1)),
        "two layers of ghosts": (with_sources(pieces(lattice(1500, 30), ranks), 8), dict(EVERYTHING, GhostLevels=2)),
        "three layers of ghosts": (with_sources(pieces(uniform(1500), ranks), 4), dict(LOOPS, GhostLevels=3)),
        "ghosts on a circle": (pieces(circle(100), ranks), dict(EVERYTHING, GhostLevels=1)),
        "short ghosts": (pieces(uniform(900), ranks), dict(EVERYTHING, MaximumEdgeLength=0.09, GhostLevels=2)),
        "ghosts with marks": (with_marks(pieces(uniform(1000), ranks)), dict(EVERYTHING, GhostLevels=1)),
        "ghosts of one rank": (uneven(uniform(500), ranks)[::-1], dict(EVERYTHING, GhostLevels=1)),
        "ghosts of nothing": (pieces([], ranks), dict(EVERYTHING, GhostLevels=2)),
        "all triangles are ghosts": (pieces(uniform(12), ranks), dict(EVERYTHING, GhostLevels=9)),
    }


def plane_cases(ranks):
    """Fitted planes, trimmed rims."""
    return {
        "a fitted plane": (pieces(tilted(uniform(1500)), ranks), dict(EVERYTHING, ProjectionPlaneMode=2)),
        "a fitted plane of floats": (pieces([tuple(round(c * 4096) / 4096 for c in p) for p in uniform(500)], ranks,
                                            "float"), dict(EVERYTHING, ProjectionPlaneMode=2)),
        "a fitted plane of floats and doubles": (mixed(uniform(300), ranks), dict(EVERYTHING, ProjectionPlaneMode=2)),
        "a fitted plane of marked points": (with_marks(pieces(tilted(uniform(900)), ranks)),
                                            dict(EVERYTHING, ProjectionPlaneMode=2)),
        "a fitted plane, not all finite": (odd(tilted(uniform(500)), ranks), dict(EVERYTHING, ProjectionPlaneMode=2)),
        "a fitted plane of one rank": (uneven(tilted(uniform(500)), ranks), dict(EVERYTHING, ProjectionPlaneMode=2)),
        "a fitted plane of a line": (pieces([(0.1 * i, 0.2 * i, 1.0) for i in range(90)], ranks),
                                     dict(EVERYTHING, ProjectionPlaneMode=2)),
        "a fitted plane of one z": (pieces([(x, y, 0.3) for x, y, _ in uniform(900)], ranks),
                                    dict(EVERYTHING, ProjectionPlaneMode=2)),
        "a fitted plane of one x": (pieces([(0.3, x, y) for x, y, _ in uniform(900)], ranks),
                                    dict(EVERYTHING, ProjectionPlaneMode=2, GhostLevels=1)),
        "a fitted plane of nothing": (pieces([], ranks), dict(EVERYTHING, ProjectionPlaneMode=2)),
        "a fitted plane and sources' points": (with_own_points(pieces(tilted(uniform(800)), ranks)),
                                               dict(COORDINATES, ProjectionPlaneMode=2, Rim=1)),
        "trimmed": (pieces(shuffled(bowed(40)), ranks), dict(EVERYTHING, Rim=2)),
        "trimmed, dealt by rows": (pieces(bowed(30), ranks), dict(EVERYTHING, Rim=2, GhostLevels=1)),
        "trimmed, where ranks know no corner beyond": (
            pieces(shuffled([(0.2 * x, 4 * y, z) for x, y, z in bowed(40)]), ranks),
            dict(EVERYTHING, Rim=2, GhostLevels=1)),
        "a hull edge of two ranks before a third": (
            pieces([(0.9 * x, 4 * y, z) for x, y, z in uniform(800)]
                   + [(1.0, -4.0, 0.0), (0.95, 0.01, 0.0), (1.0, 4.0, 0.0)], ranks), dict(EVERYTHING, Rim=2)),
        "trimmed in a fitted plane": (pieces(shuffled(tilted(bowed(30))), ranks),
                                      dict(EVERYTHING, ProjectionPlaneMode=2, GhostLevels=2)),
        "trimmed in a plane": (pieces(shuffled(bowed(20)), ranks), dict(EVERYTHING, Transform=True)),
        "all is trimmed": (pieces(shuffled(arc(300)), ranks), dict(EVERYTHING, Rim=2)),
    }


def bounding_cases(ranks):
    return {
        "bounding points": (pieces(uniform(700), ranks), dict(EVERYTHING, BoundingTriangulation=True, GhostLevels=1)),
        "bounding points of floats": (pieces([tuple(round(c * 64) / 64 for c in p) for p in uniform(300)], ranks,
                                             "float"), dict(EVERYTHING, BoundingTriangulation=True, Offset=2.5)),
        "bounding points of marked points": (with_marks(pieces(uniform(300), ranks)),
                                             dict(EVERYTHING, BoundingTriangulation=True)),
        "bounding points, not all finite": (odd(uniform(300), ranks), dict(EVERYTHING, BoundingTriangulation=True)),
        "bounding points of one rank": (uneven(uniform(300), ranks)[::-1],
                                        dict(EVERYTHING, BoundingTriangulation=True)),
        "bounding points of sources' points": (with_own_points(pieces(uniform(300), ranks)),
                                               dict(COORDINATES, BoundingTriangulation=True)),
        "bounding points and lines": (with_sources(pieces(uniform(300), ranks), 4),
                                      dict(EVERYTHING, BoundingTriangulation=True, MaximumEdgeLength=0.4)),
        "bounding points of one x": (pieces([(0.3, y, z) for _, y, z in uniform(50)], ranks),
                                     dict(EVERYTHING, BoundingTriangulation=True)),
        "bounding points of nothing": (pieces([], ranks), dict(EVERYTHING, BoundingTriangulation=True)),
    }


def with_values(made):
    """The sources' points have values in two arrays, of other types than the input's."""
    for piece in made:
        count = len(piece.source[0]) if piece.source else 0
        piece.source_arrays = {"Float": ("double", [0.1 * i for i in range(count)]),
                               "Long": ("float", [2.5 * i for i in range(count)])}
    return made


def with_points_alone(made):
    """Sources that constrain nothing, reported with the number of their points."""
    for piece in made:
        piece.source = (ring(0.5, 4), [], [])
    return made


def gathered_cases(ranks):
    """name -> (pieces, settings, the setting that makes one rank do all): of each such setting one case at least."""
    found = known_gathered_cases(ranks)
    known = {setting for _, _, setting in found.values()}
    return dict(found, **{
        name: (pieces(uniform(300), ranks), {name: other}, name) for name, other, _ in other_values("delaunay")
        if TABLE["delaunay"]["settings"][name]["ranks"] == "one" and name not in known})


def known_gathered_cases(ranks):
    everything, coordinates = EVERYTHING, COORDINATES
    few = uniform(300)
    lines = dict(everything, GenerateRegionIds=True)
    return {
        "limit": (pieces(few, ranks), dict(everything, InsertionLimit=50), "InsertionLimit"),
        "order": (pieces(few, ranks), {"GenerateInsertionRank": True}, "GenerateInsertionRank"),
        "curve": (pieces(few, ranks), {"GenerateInsertionCurve": True, "GenerateBoxes": True, "Nmax": 4},
                  "GenerateInsertionCurve"),
        "boxes": (pieces(few, ranks), {"GenerateBoxes": True}, "GenerateBoxes"),
        "work": (pieces(few, ranks), {"CountWork": True}, "CountWork"),
        "regions": (with_sources(pieces(few, ranks), 6), lines, "GenerateRegionIds"),
        "neighbours": (with_sources(pieces(few, ranks), 6), dict(everything, GenerateNeighbors=True),
                       "GenerateNeighbors"),
        "voronoi": (pieces(few, ranks), dict(everything, GenerateVoronoi=True), "GenerateVoronoi"),
        "voronoi in a polygon": (pieces(few, ranks), dict(
            GenerateVoronoi=True, VoronoiClip=2, VoronoiPolygon="0.2 0.1, 0.9 0.4, 0.3 0.8"), "GenerateVoronoi"),
        "voronoi, floats": (pieces([tuple(round(c * 4096) / 4096 for c in p) for p in few], ranks, "float"),
                            {"GenerateVoronoi": True}, "GenerateVoronoi"),
        "voronoi, whole numbers": (pieces([tuple(float(round(c * 100)) for c in p) for p in few], ranks, "int"),
                                   {"GenerateVoronoi": True}, "GenerateVoronoi"),
        "voronoi, marks": (with_marks(pieces(few, ranks)), dict(everything, GenerateVoronoi=True), "GenerateVoronoi"),
        "voronoi, not finite": (odd(few, ranks), dict(everything, GenerateVoronoi=True), "GenerateVoronoi"),
        "voronoi, partial arrays": (partial(few, ranks), {"GenerateVoronoi": True}, "GenerateVoronoi"),
        "voronoi, on one rank": (uneven(few, ranks), dict(everything, GenerateVoronoi=True), "GenerateVoronoi"),
        "voronoi of nothing": (pieces([], ranks), dict(everything, GenerateVoronoi=True), "GenerateVoronoi"),
        "voronoi of a plane": (pieces(few, ranks), dict(everything, GenerateVoronoi=True, Rim=1, Transform=True),
                               "GenerateVoronoi"),
        "alpha": (with_sources(pieces(few, ranks), 4),
                  dict(everything, Alpha=0.1, AlphaLines=True, AlphaVerts=True, MaximumEdgeLength=0.3), "Alpha"),
        "simplified": (with_sources(pieces(lattice(300, 12), ranks), 3),
                       dict(everything, MaximumError=0.2, SecondPass=True), "MaximumError"),
        "simplified by values": (with_own_points(pieces(few, ranks)), dict(
            coordinates, MaximumError=3.0, ValueArrayName="Float", WeightArrayName="Byte", KeepArrayName="Bit"),
            "MaximumError"),
        "simplified to a number": (pieces(few, ranks), dict(everything, MaximumNumberOfVertices=60),
                                   "MaximumNumberOfVertices"),
        "tolerance": (pieces(few, ranks), dict(everything, Tolerance=0.02), "Tolerance"),
        "trimmed, with lines": (with_sources(pieces(shuffled(bowed(16)), ranks), 3), dict(everything, Rim=2), "Rim"),
        "split": (with_sources(pieces(few, ranks), 5), dict(everything, CrossingMode=1), "CrossingMode"),
        "split on a lattice": (with_sources(pieces(lattice(300, 12), ranks), 5), dict(everything, CrossingMode=1),
                               "CrossingMode"),
        "unfit ids": (with_unfit_ids(pieces(few, ranks), 10 ** 6), lines, "GenerateRegionIds"),
        "an id just too high": (with_unfit_ids(pieces(few, ranks), 100), lines, "GenerateRegionIds"),
        "a negative id": (with_unfit_ids(pieces(few, ranks), -7), lines, "GenerateRegionIds"),
        "sources' points": (with_values(with_own_points(pieces(few, ranks))),
                            dict(coordinates, ClosedLines=1, GenerateRegionIds=True), "GenerateRegionIds"),
        "source on an empty rank": (with_values(with_own_points(uneven(few, ranks))),
                                    dict(coordinates, GenerateRegionIds=True), "GenerateRegionIds"),
        "voronoi, means": (pieces(lattice(300, 12), ranks), {"GenerateVoronoi": True, "DuplicatePolicy": 3},
                           "GenerateVoronoi"),
        "voronoi in a fitted plane": (pieces(few, ranks), {"GenerateVoronoi": True, "ProjectionPlaneMode": 2},
                                      "GenerateVoronoi"),
        "alpha, bounding": (pieces(few, ranks), dict(everything, Alpha=0.2, BoundingTriangulation=True), "Alpha"),
        "rim of a shore": (with_sources(pieces(few, ranks), 3), dict(everything, Rim=2, FillRule=1), "Rim Trimmed"),
        "points alone in sources": (with_points_alone(pieces(few, ranks)), lines, "GenerateRegionIds"),
        "one source": (with_values(with_one_source(pieces(few, ranks))), dict(coordinates, GenerateVoronoi=True),
                       "GenerateVoronoi"),
        "points as line": (with_points_alone(pieces(few, ranks)), dict(coordinates, PointsAsLine=True), "PointsAsLine"),
        "from surface": (with_values(with_own_points(pieces(few, ranks))), dict(coordinates, SourceHeights=1),
                         "SourceHeights"),
        "mixed heights": (with_values(with_own_points(pieces(few, ranks))),
                          dict(coordinates, SourceHeights=2, ZeroIsMissing=True), "SourceHeights Mixed"),
        "short segments": (with_values(with_own_points(pieces(few, ranks))),
                           dict(coordinates, MaximumSegmentLength=0.05), "MaximumSegmentLength"),
    }
