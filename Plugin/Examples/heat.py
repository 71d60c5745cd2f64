# SPDX-License-Identifier: BSD-3-Clause
"""From a polygon to a solution: the temperature of a plate with a hole, by linear finite elements.

    python3 heat.py <picture.png>

Needs NumPy and the package adaptivehilbertdelaunay (`pip install .`); for the picture matplotlib. Where scikit-fem is
installed (`pip install scikit-fem`), it solves the same problem on the same mesh.

The plate is heated all over, -div(grad u) = 1. Its outline is kept at 0 degrees; nothing flows through the hole.
"""

import sys

import numpy as np
from adaptivehilbertdelaunay import delaunay


def plate():
    """Corners, and their ids along the outline and the hole."""
    outline = [(0, 0), (6, 0), (6, 2), (4, 2), (4, 4), (0, 4)]
    angles = np.arange(24) * np.pi / 12
    hole = np.column_stack((1.8 + 0.9 * np.cos(angles), 2 + 0.9 * np.sin(angles)))
    return np.concatenate((outline, hole)), [np.arange(6), np.arange(6, 30)]


def elements(points, triangles):
    """Of each triangle the stiffness matrix, (t, 3, 3), and the area."""
    x, y = np.moveaxis(points[triangles], 2, 0)
    b, c = (np.roll(v, -1, axis=1) - np.roll(v, 1, axis=1) for v in (y, -x))
    area = (b[:, 0] * c[:, 1] - b[:, 1] * c[:, 0]) / 2
    return (b[:, :, None] * b[:, None] + c[:, :, None] * c[:, None]) / (4 * area)[:, None, None], area


def solved(matrices, triangles, right, is_fixed):
    """Values at the points, 0 where fixed: by conjugate gradients, which need only products with the matrix."""
    free = ~is_fixed
    rows, columns = np.repeat(triangles, 3, axis=1).ravel(), np.tile(triangles, 3).ravel()

    def product(v):
        return free * np.bincount(rows, matrices.ravel() * v[columns], len(v))

    u, rest = np.zeros_like(right), free * right
    way, size = rest, rest @ rest
    least = 1e-24 * size
    while size > least:
        change = product(way)
        step = size / (way @ change)
        u, rest = u + step * way, rest - step * change
        before, size = size, rest @ rest
        way = rest + size / before * way
    return u


def solved_by_scikit_fem(mesh, is_fixed):
    """The same, for those who have it."""
    import skfem
    from skfem.models.poisson import laplace, unit_load

    basis = skfem.Basis(skfem.MeshTri(mesh.points.T, mesh.triangles.T), skfem.ElementTriP1())
    return skfem.solve(*skfem.condense(laplace.assemble(basis), unit_load.assemble(basis), D=np.flatnonzero(is_fixed)))


def show(mesh, u, file):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axis = plt.subplots(figsize=(9, 5.6), constrained_layout=True)
    shown = axis.tricontourf(mesh.triangulation.to_matplotlib(), u, 16, cmap="inferno")
    axis.triplot(mesh.triangulation.to_matplotlib(), lw=0.3, color="white", alpha=0.6)
    for chain, colour in ((0, "tab:blue"), (1, "black")):
        ends = mesh.points[mesh.edges[mesh.markers[:, 0] == chain]]
        axis.plot(*np.moveaxis(ends, 2, 0).transpose(0, 2, 1), color=colour, lw=2)
    axis.set(aspect="equal", xlim=(-0.1, 6.1), ylim=(-0.1, 4.1))
    axis.set(title="%d triangles; blue: kept at 0, black: insulated" % len(mesh.triangles))
    figure.colorbar(shown, ax=axis, label="temperature")
    figure.savefig(file, dpi=80)


def main(file):
    corners, (outline, hole) = plate()
    made = delaunay(corners, loops=[outline, hole])
    # finer towards the inner corner at (4, 2), where the gradient has no limit
    mesh = made.refine(30, maximum_area=0.02, sizes=lambda xy: 0.03 + 0.2 * np.hypot(*(xy - (4, 2)).T))
    is_cold = np.zeros(len(mesh.points), bool)
    is_cold[mesh.edges[mesh.markers[:, 0] == 0]] = True  # chain 0 is the outline, chain 1 the hole
    matrices, area = elements(mesh.points, mesh.triangles)
    heat = np.bincount(mesh.triangles.ravel(), np.repeat(area / 3, 3))
    u = solved(matrices, mesh.triangles, heat, is_cold)
    at = u[mesh.triangles]
    flow = np.bincount(mesh.triangles.ravel(), (matrices @ at[:, :, None]).ravel()) - heat
    print(mesh)
    print("heat in %.6f, out through the outline %.6f" % (area.sum(), -flow[is_cold].sum()))
    print("hottest: %.4f at (%.2f, %.2f)" % (u.max(), *mesh.points[u.argmax()]))
    try:
        print("scikit-fem differs by %.0e" % abs(solved_by_scikit_fem(mesh, is_cold) - u).max())
    except ImportError:
        print("no scikit-fem here")
    try:
        show(mesh, u, file)
    except ImportError:
        print("no matplotlib here, so no picture")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python3 heat.py <picture.png>")
    main(sys.argv[1])
