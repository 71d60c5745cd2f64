# SPDX-License-Identifier: BSD-3-Clause
"""Programs as type checkers see them: mypy --strict finds the lines marked "wrong", with this code, and no other
(with_mypy.py). Those that are right run, too.
"""

from __future__ import annotations

import sys
from typing import Any, List, Tuple

import numpy as np
import adaptivehilbertdelaunay
from adaptivehilbertdelaunay import (
    Boxes, Contours, DelaunayWarning, Kind, LinearInterpolator, Mesh, NaturalNeighborInterpolator,
    NearestInterpolator, Outline, Raster, Triangulation, Voronoi, delaunay, release_memory,
)  # fmt: skip


def survey() -> Tuple[np.ndarray, np.ndarray]:
    points = np.random.default_rng(1).random((1000, 2))
    return points, np.sin(points[:, 0])


def triangulated(points: np.ndarray) -> Triangulation:
    def told(phase: str, fraction: float) -> None:
        print(phase, fraction)

    made: Triangulation = delaunay(
        points, crossings="split", fill_rule="orientation", rim="trimmed", duplicates="first", plane="best_fit",
        want=["neighbors", "voronoi"], id_dtype=np.int64, tolerance=0, threads=1,
        progress=told if points.size < 0 else None,
    )  # fmt: skip
    delaunay(points, plane=np.eye(4), want="regions", skip=np.zeros(len(points), bool))
    light: Triangulation = delaunay(points, heights=points[:, 0], maximum_error=0.1, second_pass=True)
    light = made.simplify(maximum_vertices=100).simplify(0.1, values=points[:, 1])
    delaunay(light.points, plane=lambda xyz: xyz, constraints=[(0.2, 0.2), (0.8, 0.2), (0.5, 0.9)])
    return made


def looked_at(made: Triangulation) -> List[str]:
    diagram: Voronoi = made.voronoi("bounds")
    diagram = made.voronoi([[0, 0], [1, 1]])
    diagram = made.voronoi({"type": "Polygon", "coordinates": [[(0, 0), (1, 0), (0, 1)]]})
    boxes: Boxes = made.boxes
    where = made.locate([[0.5, 0.5]])
    edges: np.ndarray = made.edges
    shapes: List[Outline] = [made.outline(), made.alpha_shape(0.1)]
    bands: Contours = made.contours(made.points[:, 0], [0.2, 0.5], filled=True)
    mesh: Mesh = made.refine(30, maximum_area=0.1, sizes=lambda xy: 1 + xy[:, 0])
    pieces: np.ndarray = mesh.edges[mesh.on_boundary]
    count: int = made.counts["triangles"] + len(pieces) + len(mesh.triangulation.neighbors)
    names = [Kind(kind).name for kind in where.kind]
    return names + [str(len(diagram)), str(len(boxes.levels)), str(count + len(edges) + len(shapes) + len(bands))]


def interpolated(points: np.ndarray, values: np.ndarray) -> np.ndarray:
    made = delaunay(points)
    cells: Raster = made.raster(0.1, align=True).north_up()[:5]
    heights: np.ndarray = made.interpolate(values, cells, "natural", outside="nearest")
    heights, slopes = made.interpolate(values, (points[:, 0], points[:, 1]), gradient=True)
    weights: np.ndarray = made.weights(cells, "laplace").weights
    for kind in (LinearInterpolator, NaturalNeighborInterpolator):
        heights += kind(points, values, fill_value=0)(points)
    nearest: np.ndarray = NearestInterpolator(points, values)(0.5, 0.5)
    places: np.ndarray = Raster.from_geotransform((0, 1, 0, 0, 0, 1), (2, 2)).x
    total: np.ndarray = heights + slopes[:, 0] + weights.sum() + nearest + places[0]
    return total


def main() -> int:
    points, values = survey()
    print(looked_at(triangulated(points)), interpolated(points, values).mean(), adaptivehilbertdelaunay.__version__)
    print(DelaunayWarning.__name__)
    release_memory()
    return 0


def wrong(points: np.ndarray, made: Triangulation) -> Any:
    delaunay(points, crossings="splat")  # wrong: arg-type
    delaunay(points, rim="none")  # wrong: arg-type
    delaunay(points, duplicates=1)  # wrong: arg-type
    delaunay(points, tolerance="0.1")  # wrong: arg-type
    delaunay(points, bounding=3.5)  # wrong: arg-type
    delaunay(points, want=["triangles"])  # wrong: list-item
    delaunay(points, want="edges")  # wrong: arg-type
    delaunay(points, plane="xz")  # wrong: arg-type
    delaunay(points, alfa=3)  # wrong: call-arg
    delaunay(points, points)  # wrong: call-arg
    made.voronoi("hul")  # wrong: arg-type
    made.alpha_shape("0.1")  # wrong: arg-type
    made.refine("30")  # wrong: arg-type
    made.refine(30, 0.5)  # wrong: call-arg
    made.interpolate(points, points, "cubic")  # wrong: call-overload
    made.interpolate(points, points, outside="nearby")  # wrong: call-overload
    made.weights(points, "cubic")  # wrong: arg-type
    made.raster(2, (3, 4))  # wrong: call-arg
    heights: np.ndarray = made.interpolate(points, points, gradient=True)  # wrong: assignment
    text: str = made.counts["triangles"]  # wrong: assignment
    print(made.simplices, heights, text)  # wrong: attr-defined
    return adaptivehilbertdelaunay.delauny(points)  # wrong: attr-defined


if __name__ == "__main__":
    sys.exit(main())
