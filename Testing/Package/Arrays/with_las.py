# SPDX-License-Identifier: BSD-3-Clause
"""Tiles of .las, .laz and COPC files, read by laspy and lazrs, which are fetched from PyPI into a venv of its own.

    with_las.py <folder of the venv>

77 if PyPI is out of reach.
"""

import os
import struct

import numpy as np
from tilesupport import TilesTest, kinds, needs_raster, raster_of, read_piece, tiles
from with_scipy import reached, run_with

from adaptivehilbertdelaunay.tiles import _read

POINTS = np.round(next(points for name, points in kinds(900) if name == "uniform"), 2)
CLASSES = np.arange(len(POINTS)) % 3
WKT = ('PROJCS["ETRS89 / UTM zone 32N",GEOGCS["ETRS89",DATUM["European_Terrestrial_Reference_System_1989",'
       'SPHEROID["GRS 1980",6378137,298.257222101]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],'
       'PROJECTION["Transverse_Mercator"],PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",9],'
       'PARAMETER["scale_factor",0.9996],PARAMETER["false_easting",500000],PARAMETER["false_northing",0],'
       'UNIT["metre",1],AUTHORITY["EPSG","25832"]]')  # fmt: skip


class LasTest(TilesTest):
    def las(self, name, rows=slice(None), scale=0.01, wkt=WKT):
        import laspy

        header = laspy.LasHeader(point_format=6, version="1.4")
        header.scales = [scale] * 3
        if wkt:
            header.vlrs.append(laspy.vlrs.VLR("LASF_Projection", 2112, "", wkt.encode() + b"\0"))
        made = laspy.LasData(header)
        made.x, made.y, made.z = POINTS[rows].T
        made.classification, made.intensity = CLASSES[rows], np.arange(len(POINTS))[rows]
        made.write(self.at(name))
        return self.at(name)

    def places(self, *names):
        """As laspy has them, the units of which are hundredths."""
        paths = [self.at(name) for name in names]
        return np.concatenate([chunk.xyz for path in paths for chunk in _read.chunks_of(path, _read.head_of(path))])

    def test_triangles_and_data(self):
        files = [self.las("a.las", slice(0, 500)), self.las("b.laz", slice(500, None))]
        made = tiles.make(files, tin=self.at("a.pvtp"), classes=[1, 2], leaf=100)
        self.assertEqual((made.plan.points, made.plan.other_class), (600, 300))
        places = self.places("a.las", "b.laz")
        np.testing.assert_allclose(places, POINTS, rtol=0, atol=1e-9)
        kept = places.copy()
        kept[CLASSES == 0] = np.nan
        self.assert_is_one_piece(kept, self.at("a.pvtp"))
        _, data, _ = read_piece(self.at("a", "0.vtp"))
        np.testing.assert_array_equal(data["classification"], CLASSES[data["GlobalPointIds"]])
        np.testing.assert_array_equal(data["intensity"], data["GlobalPointIds"])

    @needs_raster
    def test_the_reference_system_is_that_of_the_files(self):
        import rasterio

        tiles.make([self.las("a.laz")], raster=tiles.GeoTiff(self.at("a.tif"), 1), leaf=300)
        with rasterio.open(self.at("a.tif")) as file:
            self.assertEqual(file.crs.to_epsg(), 25832)
        self.assertEqual(raster_of(self.at("a.tif"))[0].shape, (60, 100))

    def test_reference_systems_by_number(self):
        """Keys as in GeoTIFFs: the projected one counts, not the one below it; a system of one's own has no number."""
        import laspy

        for keys, said in (((3072, 25832), "EPSG:25832"), ((2048, 4258, 3072, 25833), "EPSG:25833"),
                           ((2048, 4326), "EPSG:4326"), ((3072, 32767), None), ((1024, 1), None)):  # fmt: skip
            rows = b"".join(struct.pack("<4H", key, 0, 1, value) for key, value in zip(keys[::2], keys[1::2]))
            header = laspy.LasHeader(point_format=1, version="1.2")
            header.vlrs.append(laspy.vlrs.VLR(
                "LASF_Projection", 34735, "", struct.pack("<4H", 1, 1, 0, len(keys) // 2) + rows))  # fmt: skip
            made = laspy.LasData(header)
            made.x, made.y, made.z = POINTS.T
            made.write(self.at("keys.las"))
            self.assertEqual(_read.head_of(self.at("keys.las")).crs, said)

    def test_one_pass_where_the_header_is_right(self):
        from adaptivehilbertdelaunay.tiles import _points

        passes, count = [], _points._count
        _points._count = lambda *given: passes.append(count(*given)) or passes[-1]
        self.addCleanup(setattr, _points, "_count", count)
        tiles.make([self.las("a.laz")], tin=self.at("a.pvtp"))
        tiles.make([self.las("a.laz")], tin=self.at("b.pvtp"), classes=[1])
        self.assertEqual([one.passes for one in passes], [1, 2])

    def refused(self, path, said):
        with self.assertRaises(tiles.BadFile) as caught:
            tiles.make([self.las("good.las"), path], tin=self.at("bad.pvtp"))
        self.assertIn(path, str(caught.exception))
        self.assertIn(said, str(caught.exception))
        self.assertFalse(os.path.exists(self.at("bad.pvtp")))
        made = tiles.make([self.at("good.las"), path], tin=self.at("a.pvtp"), skip_bad=True, overwrite=True)
        self.assertEqual(list(made.skipped), [path])
        self.assert_is_one_piece(self.places("good.las"), self.at("a.pvtp"))

    def test_bad_files(self):
        for name in ("a.las", "a.laz"):
            with open(self.las(name), "rb") as file:
                octets = file.read()
            with open(self.at("short." + name), "wb") as file:
                file.write(octets[:-2000])
            self.refused(self.at("short." + name), "")
        self.refused(self.las("scale.las", scale=0.001), "has the scale (0.001")
        self.refused(self.las("system.las", wkt=WKT.replace("zone 32N", "zone 33N")), "has the reference system")

    def test_headers_that_lie(self):
        with open(self.las("a.las"), "rb") as file:
            octets = file.read()
        for name, at, kind, value, said in (("bounds.las", 179, "<d", 50.0, "has points from"),
                                            ("count.las", 247, "<Q", 500, "500 points, and has room for 900"),
                                            ("more.las", 247, "<Q", len(POINTS) + 9, "")):  # fmt: skip
            lying = bytearray(octets)
            struct.pack_into(kind, lying, at, value)
            with open(self.at(name), "wb") as file:
                file.write(lying)
            self.refused(self.at(name), said)


def with_readers(folder):
    return reached(folder, "import laspy, lazrs, rasterio, numpy", ("laspy[lazrs]", "rasterio"))


if __name__ == "__main__":
    run_with(with_readers, __file__)
