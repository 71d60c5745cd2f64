# SPDX-License-Identifier: BSD-3-Clause
"""The peers, how each is started, and what its time covers."""
import os
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent


@dataclass(frozen=True)
class Peer:
    name: str
    title: str
    kind: str  # program: C++, in --bin; pypi: Python, in the venv; vtk91, paraview: Debian's VTK
    licence: str
    options: str  # settings, changed and default
    gives: str  # the results when the clock stops
    threads: bool = False
    package: str = ""  # of PyPI


_BSD = "BSD-3-Clause"
_VTK_GIVES = "polydata, ids"

PEERS = [
    Peer("ours", "this engine", "program", _BSD, "defaults, one thread", "ids"),
    Peer("ours-threads", "this engine, all threads", "program", _BSD, "defaults", "ids", threads=True),
    Peer("cgal", "CGAL", "program", "GPL-3.0 or commercial",
         "Delaunay_triangulation_2, EPICK, range insertion", "CGAL's mesh, no ids"),
    Peer("cgal-ids", "CGAL with ids", "program", "GPL-3.0 or commercial",
         "the same, vertices carry ids", "CGAL's mesh and an array of ids"),
    Peer("vtk91", "vtkDelaunay2D 9.1 (Debian)", "vtk91", _BSD, "defaults (Tolerance 1e-5)", _VTK_GIVES),
    Peer("paraview", "vtkDelaunay2D 9.2 (Debian's ParaView)", "paraview", _BSD, "defaults (Tolerance 1e-5)",
         _VTK_GIVES),
    Peer("vtk97", "vtkDelaunay2D 9.7", "pypi", _BSD, "defaults (Tolerance 1e-5)", _VTK_GIVES,
         package="vtk"),
    Peer("vtk97-hilbert", "vtkDelaunay2D 9.7, Hilbert", "pypi", _BSD, "UseHilbertSorter on", _VTK_GIVES,
         package="vtk"),
    Peer("vtk97-hilbert-tolerance0", "vtkDelaunay2D 9.7, Hilbert, Tolerance 0", "pypi", _BSD,
         "UseHilbertSorter on, Tolerance 0", _VTK_GIVES, package="vtk"),
    Peer("vtk97-flower", "vtkVoronoiFlower2D 9.7", "pypi", _BSD,
         "OutputType Delaunay, SMP backend Sequential", _VTK_GIVES, package="vtk"),
    Peer("vtk97-flower-careful", "vtkVoronoiFlower2D 9.7, careful", "pypi", _BSD,
         "also the largest Padding (0.25), Validate on", _VTK_GIVES, package="vtk"),
    Peer("vtk97-flower-threads", "vtkVoronoiFlower2D 9.7, all threads", "pypi", _BSD,
         "OutputType Delaunay, SMP backend STDThread", _VTK_GIVES, threads=True, package="vtk"),
    Peer("scipy", "scipy (Qhull)", "pypi", "BSD-3-Clause (Qhull: its own)",
         "defaults (Qbb Qc Qz Q12)", "ids, neighbours", package="scipy"),
    Peer("geos", "GEOS (shapely)", "pypi", "LGPL-2.1 (shapely: BSD-3-Clause)",
         "delaunay_triangles, defaults", "polygons, no ids", package="shapely"),
    Peer("startinpy", "startinpy", "pypi", "MIT", "defaults (snap_tolerance 0.001)", "ids of its own",
         package="startinpy"),
    Peer("startinpy-nosnap", "startinpy, nothing snapped", "pypi", "MIT",
         "snap_tolerance 1e-300, jump_and_walk on, as its manual advises for shuffled points", "ids of its own",
         package="startinpy"),
    Peer("triangle", "Triangle (Shewchuk's)", "pypi",
         "Shewchuk's, no commercial use (wrapper: LGPL-3.0)", "delaunay(), defaults", "ids",
         package="triangle"),
    Peer("dylaunator", "delaunator in Python (dylaunator)", "pypi", "ISC", "defaults, pure Python",
         "ids", package="dylaunator"),
    Peer("cdt", "CDT (pythoncdt)", "pypi", "MPL-2.0", "AUTO order, no constraints",
         "its triangles, ids", package="pythoncdt"),
]
BY_NAME = {peer.name: peer for peer in PEERS}

# The inputs by their names in Support/Points/Distributions.h: the six of the paper and harder ones.
INPUTS = ["Uniform", "Line", "Cross", "Circle", "Spiral", "Mixed", "Lattice", "DecimalLattice", "OnCircle",
          "NearlyCollinear", "Utm"]
QUICK_INPUTS = ["Uniform", "DecimalLattice", "Utm"]
REAL_FILES = ["lidar.csv", "soundings.csv"]  # in the folder of --data


class Places:
    """Paths of the peers on this machine."""

    def __init__(self, programs, venv, vtk91):
        self.programs = Path(programs)
        self.python = Path(venv) / "bin" / "python"
        self.vtk91 = Path(vtk91)  # the root that Debian's packages were unpacked in

    def environment(self, peer):
        env = {k: v for k, v in os.environ.items() if k not in ("PYTHONPATH", "LD_LIBRARY_PATH")}
        env.update(PYTHONDONTWRITEBYTECODE="1", PYTHONNOUSERSITE="1")
        if not peer.threads:
            env.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", VTK_SMP_MAX_THREADS="1")
        if peer.kind == "vtk91":
            libraries = next(self.vtk91.glob("usr/lib/*/libvtkFiltersCore-9.1.so.1"), self.vtk91).parent
            env.update(LD_LIBRARY_PATH=str(libraries),
                       PYTHONPATH=str(self.vtk91 / "usr/lib/python3/dist-packages"))
        return env

    def command(self, peer, files):
        """The peer on these files (points, triangles, vertices), or with --version alone."""
        if peer.kind == "program":
            ours = peer.name.startswith("ours")
            program = str(self.programs / ("PeerOurs" if ours else "PeerCgal"))
            if len(files) == 1:
                return [program, *files]
            more = [str(len(os.sched_getaffinity(0)))] if peer.name == "ours-threads" else []
            more += ["--ids"] if peer.name == "cgal-ids" else []
            return [program, *(files[:2] if ours else files), *more]
        python = str(self.python) if peer.kind == "pypi" else "/usr/bin/python3"
        return [python, str(HERE / "peer_process.py"), peer.name, *files]
