# SPDX-License-Identifier: BSD-3-Clause
"""Coastline and soundings with PyVista: the size of a notebook, in which it runs cell by cell.

    python bay_pyvista.py <soundings.csv> <coastline.vtp> [<picture.png>]

The table has the columns x, y and elevation. Without a picture a window opens.
"""

import sys

import numpy
import pyvista

import adaptivehilbertdelaunay.pyvista  # noqa: F401 (PyVista from 0.48 on finds an installed package by itself)

if not 3 <= len(sys.argv) <= 4:
    sys.exit("usage: python bay_pyvista.py <soundings.csv> <coastline.vtp> [<picture.png>]")
table, shores, *picture = sys.argv[1:]

# %% Points and outlines. PyVista's own reader for the one, NumPy for the other.
points = numpy.loadtxt(table, delimiter=",", skiprows=1)
soundings = pyvista.PolyData(points)
soundings["elevation"] = points[:, 2]
coastline = pyvista.read(shores)

# %% The surface of the points alone, and the one that ends at the shore. The coastline has points of its own, so it
# is given as `constraints`; which way its polygons run makes no difference. plane="xy": a map, seen from above.
alone = soundings.adaptive.delaunay_2d(plane="xy")
bay = soundings.adaptive.delaunay_2d(plane="xy", constraints=coastline)
print("%d soundings: %d triangles; with the coastline: %d points, %d triangles" % (
    soundings.n_points, alone.n_cells, bay.n_points, bay.n_cells))

# %% Whose water is it: the cell of each sounding, and those parts of the bay that are known to within 130 m.
cells = soundings.adaptive.voronoi_2d(plane="xy")
dense = soundings.adaptive.delaunay_2d(plane="xy", alpha=130.0)
print("cells of %.0f to %.0f square metres; dense: %.0f %% of the surface" % (
    *numpy.percentile(cells.compute_cell_sizes()["Area"], (1, 99)), 100 * dense.area / alone.area))

# %% Four pictures.
plotter = pyvista.Plotter(shape=(2, 2), border=False, window_size=(1400, 1120), off_screen=bool(picture))
shown = ((alone, "The soundings alone"), (bay, "constraints=coastline"), (cells, "voronoi_2d()"), (dense, "alpha=130"))
for place, (mesh, title) in enumerate(shown):
    plotter.subplot(*divmod(place, 2))
    plotter.set_background("#f0e8d6")
    plotter.add_mesh(mesh, scalars="elevation", cmap="Blues_r", show_edges=True, edge_color="#40667f", line_width=1,
                     show_scalar_bar=False, lighting=False)
    plotter.add_mesh(coastline.translate((0, 0, 100)), style="wireframe", color="#8c331a", line_width=2)
    plotter.add_text(title, font_size=12, color="#33261a")
    plotter.view_xy()
    plotter.camera.zoom(1.25)
plotter.show(screenshot=picture[0] if picture else None)
