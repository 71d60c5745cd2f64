#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Write the sample for constraints: a bay that exists nowhere, its soundings and its coastline.

    python3 Data/make_bay.py [FOLDER]          (default: Bay beside this script)

soundings.csv   x, y, elevation in metres: a ship went to and fro 200 m apart, where there was water
                under its keel, a boat on the lagoon of the largest island.
coastline.vtp   polygonal data with points of its own and their elevation:
                polygons  the shore, closed by a line across the mouth of the bay, counterclockwise;
                          four islands, clockwise; the lagoon in the largest, counterclockwise
                line      the bed of the channel, from the river to the mouth of the bay

The channel begins and ends at points of the shore; nothing crosses anything else. The same bytes come
out every time: the random numbers are those of make_survey.py.
"""

import math
import os
import sys

from make_survey import SplitMix64, smooth_noise

EAST = 5200.0
# From the mouth of the bay, eastern end, along the shore to the western end; RIVER is one of these.
SHORE = [
    (5200, 0), (5060, 620), (5190, 1300), (4790, 1820), (4930, 2560), (4330, 2790), (3980, 3230),
    (3420, 3260), (3010, 3390), (2950, 3840), (2840, 3920), (2730, 3830), (2690, 3320), (2050, 2640),
    (1420, 3110), (800, 2960), (300, 2330), (540, 1480), (90, 760), (0, 0),
]  # fmt: skip
RIVER = 10
CHANNEL = [(2840, 3920), (2850, 3300), (2560, 2480), (2420, 1800), (2730, 1080), (2600, 480), (2600, 0)]
# Centre x, y, half axes, degrees by which the long axis is turned, seed of its outline.
ISLANDS = [
    (1290, 1790, 560, 390, 35, 3),
    (3660, 1350, 430, 250, -40, 4),
    (4270, 2180, 210, 130, 20, 5),
    (1830, 720, 260, 150, -15, 6),
]
LAGOON = (1230, 1760, 230, 140, 45, 7)
KEEL, TRACKS_APART, SOUNDINGS_APART = -1.5, 200.0, 75.0  # metres


def spline(points, step):
    """A smooth curve through the points (Catmull and Rom's), sampled about every `step` metres."""
    padded = [points[0]] + points + [points[-1]]
    curve = []
    for before, a, b, after in zip(padded, padded[1:], padded[2:], padded[3:]):
        count = max(1, round(math.dist(a, b) / step))
        for k in range(count):
            t = k / count
            weights = (
                -t + 2 * t * t - t**3,
                2 - 5 * t * t + 3 * t**3,
                t + 4 * t * t - 3 * t**3,
                t**3 - t * t,
            )
            ends = (before, a, b, after)
            curve.append(tuple(sum(w * p[i] for w, p in zip(weights, ends)) / 2 for i in (0, 1)))
    return curve + [tuple(float(c) for c in points[-1])]


def ragged(curve, keep):
    """The curve with small bays and headlands; the points with the numbers in `keep` stay."""
    result = []
    for k, (x, y) in enumerate(curve):
        room = min([8] + [abs(k - fixed) for fixed in keep]) / 8.0
        bays = [
            smooth_noise(x / size, y / size, 60 + i) * size / 7 for i, size in enumerate((260.0, 90.0, 60.0))
        ]
        result.append((x + room * sum(bays), y - room * sum(bays) * 0.8))
    return result


def ring(x, y, long, short, turned, seed, step=32.0):
    """The outline of an island, counterclockwise."""
    count = round(math.pi * (long + short) / step)
    outline = []
    for k in range(count):
        angle = 2 * math.pi * k / count
        u, v = math.cos(angle), math.sin(angle)
        size = (
            1
            + 0.28 * smooth_noise(1.6 * u + 5, 1.6 * v + 5, seed)
            + 0.10 * smooth_noise(5 * u + 9, 5 * v + 9, seed)
        )
        c, s = math.cos(math.radians(turned)), math.sin(math.radians(turned))
        outline.append((x + size * (long * u * c - short * v * s), y + size * (long * u * s + short * v * c)))
    return outline


def distance(x, y, chain):
    """How far the place is from a chain of points."""
    least = math.inf
    for (ax, ay), (bx, by) in zip(chain, chain[1:]):
        ux, uy = bx - ax, by - ay
        t = min(1.0, max(0.0, ((x - ax) * ux + (y - ay) * uy) / (ux * ux + uy * uy)))
        least = min(least, (x - ax - t * ux) ** 2 + (y - ay - t * uy) ** 2)
    return math.sqrt(least)


def inside(x, y, loop):
    """Is the place inside the loop (even-odd)?"""
    odd = False
    for (ax, ay), (bx, by) in zip(loop, loop[1:] + loop[:1]):
        if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * (bx - ax):
            odd = not odd
    return odd


class Bay:
    """The shores and what the water is like between them."""

    def __init__(self):
        shore = spline([tuple(map(float, p)) for p in SHORE], 45.0)
        river = min(range(len(shore)), key=lambda k: math.dist(shore[k], SHORE[RIVER]))
        self.shore = ragged(shore, [0, river, len(shore) - 1])
        self.mouth = [(EAST * k / 10, 0.0) for k in range(1, 10)]  # from west to east
        self.outer = self.mouth + self.shore  # counterclockwise, ends in the west
        self.islands = [ring(*island) for island in ISLANDS]
        self.lagoon = ring(*LAGOON)
        self.channel = spline([tuple(map(float, p)) for p in CHANNEL], 60.0)
        self.shallow = [self.shore] + [loop + loop[:1] for loop in self.islands + [self.lagoon]]

    def is_water(self, x, y):
        wet = inside(x, y, self.outer) and not any(inside(x, y, island) for island in self.islands)
        return wet or inside(x, y, self.lagoon)

    def elevation(self, x, y):
        """Metres above the sea; the bottom falls away from the shores and towards the mouth."""
        off_shore = min(distance(x, y, chain) for chain in self.shallow)
        floor = -(1 - math.exp(-off_shore / 230.0)) * (5.0 + 11.0 * (1 - y / 3700.0))
        bed = -7.5 * math.exp(-((distance(x, y, self.channel) / 62.0) ** 2))
        return floor + bed + 0.5 * smooth_noise(x / 170.0, y / 170.0, 71)


def sail(bay):
    """The ship's log: x, y, elevation."""
    random, log = SplitMix64(20160229), []
    for track in range(1, 20):
        x, places = random.uniform(0, SOUNDINGS_APART), []
        while x < EAST:
            y = TRACKS_APART * track - 100 + 22 * smooth_noise(x / 600.0, track * 7.3, 31)
            places.append((x, y))
            x += SOUNDINGS_APART * random.uniform(0.85, 1.15)
        for x, y in places if track % 2 else places[::-1]:
            if bay.is_water(x, y):
                z = bay.elevation(x, y) + 0.05 * random.bell()
                if z < KEEL and (not inside(x, y, bay.lagoon) or z < -0.5):
                    log.append((x, y, z))
    for k in range(60):  # the boat
        x, y = LAGOON[0] + random.uniform(-230, 230), LAGOON[1] + random.uniform(-230, 230)
        z = bay.elevation(x, y)
        if inside(x, y, bay.lagoon) and z < -0.4:
            log.append((x, y, z))
    return log


def coastline(bay):
    """The points with their elevation, the polygons and the channel as lists of their ids."""
    loops = [bay.outer] + [island[::-1] for island in bay.islands] + [bay.lagoon]
    points, polygons = [], []
    for loop in loops:
        polygons.append(list(range(len(points), len(points) + len(loop))))
        points += [(x, y, 0.0) for x, y in loop]
    # what is under water in the mouth of the bay
    points = [(x, y, bay.elevation(x, y) if k < len(bay.mouth) else z) for k, (x, y, z) in enumerate(points)]
    ids = []
    for x, y in bay.channel:
        same = [k for k, p in enumerate(points) if math.dist((x, y), p[:2]) < 1e-6]
        ids.append(same[0] if same else len(points))
        if not same:
            points.append((x, y, bay.elevation(x, y)))
    return points, polygons, ids


def data_array(name, values, kind="Int64", width=1):
    size = ' NumberOfComponents="%d"' % width if width > 1 else ""
    rows = [" ".join(values[k : k + 12]) for k in range(0, len(values), 12)]
    return '<DataArray type="%s" Name="%s"%s format="ascii">\n%s\n</DataArray>\n' % (
        kind,
        name,
        size,
        "\n".join(rows),
    )


def cells(tag, lists):
    ends = [str(sum(map(len, lists[: k + 1]))) for k in range(len(lists))]
    ids = data_array("connectivity", [str(i) for ids in lists for i in ids])
    return "<%s>\n%s%s</%s>\n" % (tag, ids, data_array("offsets", ends), tag)


def vtp(points, polygons, line):
    numbers = ["%.2f" % c for point in points for c in point]
    sizes = (len(points), len(polygons))
    return (
        '<?xml version="1.0"?>\n<!-- SPDX-License-Identifier: BSD-3-Clause\n'
        "     A coastline that exists nowhere, made by Data/make_bay.py. -->\n"
        '<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian">\n<PolyData>\n'
        '<Piece NumberOfPoints="%d" NumberOfLines="1" NumberOfPolys="%d">\n'
        % sizes
        + '<PointData Scalars="elevation">\n'
        + data_array("elevation", numbers[2::3], "Float64")
        + "</PointData>\n<Points>\n"
        + data_array("Points", numbers, "Float64", 3)
        + "</Points>\n"
        + cells("Lines", [line])
        + cells("Polys", polygons)
        + "</Piece>\n</PolyData>\n</VTKFile>\n"
    )


def main():
    default = os.path.join(os.path.dirname(os.path.abspath(__file__)), "Bay")
    folder = sys.argv[1] if len(sys.argv) > 1 else default
    os.makedirs(folder, exist_ok=True)
    bay = Bay()
    with open(os.path.join(folder, "soundings.csv"), "w", encoding="ascii", newline="\n") as file:
        file.write("x,y,elevation\n" + "".join("%.1f,%.1f,%.2f\n" % row for row in sail(bay)))
    with open(os.path.join(folder, "coastline.vtp"), "w", encoding="ascii", newline="\n") as file:
        file.write(vtp(*coastline(bay)))


if __name__ == "__main__":
    main()
