# SPDX-License-Identifier: BSD-3-Clause
"""The demo's readers of tables and LAS files: exact coordinates, or the message that is promised."""

import math
import os
import struct
import sys
import tempfile
import unittest

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Plugin", "Demo"))

import nodata
import pointfiles
from pointfiles import InputError, read_points

POINTS = [[637177.98, 849393.95, 411.19], [-0.1, 1e-300, 3.0], [1e300, -2.5, 0.0]]


class FileTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def write(self, content, name="points.csv"):
        path = os.path.join(self.folder.name, name)
        with open(path, "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode("utf-8"))
        return path

    def read(self, content, *columns, name="points.csv"):
        return read_points(self.write(content, name), tuple(columns) + (None,) * (3 - len(columns)))

    def assert_points(self, found, expected):
        numpy.testing.assert_array_equal(found.xyz, numpy.array(expected, dtype=float))
        self.assertEqual(found.xyz.dtype, numpy.float64)

    def assert_refused(self, words, content, *columns, name="points.csv"):
        with self.assertRaises(InputError) as caught:
            self.read(content, *columns, name=name)
        self.assertIn(words, str(caught.exception))


class Delimiters(FileTest):
    def check(self, delimiter, header=""):
        rows = "\n".join(delimiter.join(repr(value) for value in point) for point in POINTS)
        found = self.read(header + rows + "\n")
        self.assert_points(found, POINTS)
        self.assertEqual(found.bad_rows, 0)

    def test_each_with_and_without_header(self):
        for delimiter in (",", ", ", ";", "\t", " ", "   "):
            for header in ("", delimiter.join("xyz") + "\n"):
                with self.subTest(delimiter=delimiter, header=header):
                    self.check(delimiter, header)

    def test_line_ends_and_byte_order_marks(self):
        self.assert_points(self.read(b"\xef\xbb\xbfy,x,z\r\n1,2,3\r\n4,5,6"), [[2, 1, 3], [5, 4, 6]])
        self.assertEqual(self.read(b"\xef\xbb\xbfy,x,z\n1,2,3\n").names, ("x", "y", "z"))
        self.assert_points(self.read("x;y;z\n1;2;3\n".encode("utf-16")), [[1, 2, 3]])

    def test_line_ends_of_old_macs(self):
        self.assert_points(self.read("x,y,z\r1,2,3\r4,5,6\r"), [[1, 2, 3], [4, 5, 6]])

    def test_decimal_commas(self):
        for text in ("1,5;2,25;-3\n4;5,5;6\n", "1,5 2,25 -3,0\n4,0 5,5 6,0\n", "1,5\t2,25\t-3\n4\t5,5\t6\n"):
            with self.subTest(text=text):
                self.assert_points(self.read(text), [[1.5, 2.25, -3], [4, 5.5, 6]])

    def test_commas_in_text(self):
        for text in ("1 2 3 rock,grey\n4 5 6 sand,red\n", "1\t2\t3\trock, grey\n4\t5\t6\tsand, red\n",
                     "x y z note\n1 2 3 a;b\n4 5 6 a;b\n", "1;2;3;a,b,c\n4;5;6;a,b,c\n"):
            with self.subTest(text=text):
                found = self.read(text)
                self.assert_points(found, [[1, 2, 3], [4, 5, 6]])
                self.assertEqual(found.bad_rows, 0)

    def test_minus_as_word_processors_write_it(self):
        for minus in "\u2212\u2013\uff0d":
            with self.subTest(minus=minus):
                text = "x,y,z\n%s1,2e%s1,%s.5\n4,5,6\n" % (minus, minus, minus)
                self.assert_points(self.read(text), [[-1, 0.2, -0.5], [4, 5, 6]])
                self.assert_points(self.read("%s1,5;2;0\n4;5;6\n" % minus), [[-1.5, 2, 0], [4, 5, 6]])

    def test_quotes(self):
        self.assert_points(self.read('"x","y","z"\n"1","2.5","3"\n"4","5","6"\n'), [[1, 2.5, 3], [4, 5, 6]])

    def test_quotes_that_come_late(self):
        rows = ["a,%d,%d,0" % (i, i * i) for i in range(500)] + ['"b,6,7,8,c",1,2,3']
        found = self.read("t,x,y,z\n" + "\n".join(rows))
        self.assertEqual(found.bad_rows, 0)
        self.assertEqual(list(found.xyz[-1]), [1.0, 2.0, 3.0])

    def test_number_signs_in_names_are_no_comments(self):
        self.assert_points(self.read("name,x,y,z\nBuoy#1,1,2,3\nBuoy#2,4,5,6 # good\n"), [[1, 2, 3], [4, 5, 6]])

    def test_work_grows_with_the_file_whatever_is_in_it(self):
        many = 200_000  # work that grows with its square would not end in time
        for name in ("(" * many, "[" * many + "m", "x" + "_" * many + "m_", "()" * many):
            found = self.read("x,y,%s\n1,2,3\n4,5,6\n" % name, "1", "2", "3")
            self.assert_points(found, [[1, 2, 3], [4, 5, 6]])
        for line in ("4 5 6%sa#" % (" " * many), "4 5 6 a%s" % ("#" * many), "4 5 6 %s #" % ("a#" * many)):
            self.assert_points(self.read("1 2 3\n%s\n" % line), [[1, 2, 3], [4, 5, 6]])

    def test_where_a_comment_begins(self):
        for text, kept in (("1 2 3#a", "1 2 3"), ("a#b", "a#b"), ("a#b #c", "a#b"), ("1,#", "1,"), ("a  #b#c", "a"),
                           ("a#b3#c", "a#b3"), ("é#b", "é#b"), ("#", "")):
            self.assertEqual(pointfiles.without_comment(text).rstrip(), kept)

    def test_units_of_names(self):
        for name, kept in (("Depth (m)", "depth"), ("depth_m", "depth"), ("Lon [deg] ", "lon"), ("m", "m"),
                           ("z(a)(b)", "z"), ("z (", "z ("), ("(", "("), ("h [a(b]", "h"), ("alt-feet", "alt"),
                           ("(m)", "")):
            self.assertEqual(pointfiles.plain(name), kept)

    def test_a_row_of_units_below_the_names(self):
        found = self.read("lat,lon,depth\ndeg,deg,m\n1,2,3\n4,5,6\n")
        self.assert_points(found, [[2, 1, 3], [5, 4, 6]])
        self.assertEqual(found.bad_rows, 1)
        self.assertEqual(found.names, ("lon", "lat", "depth"))

    def test_a_first_row_of_text_among_others_is_no_header(self):
        rows = "a,1,2,3\nb,4,5,6\n7,7,8,9\nc,0,0,0\n"
        self.assert_points(self.read(rows), [[1, 2, 3], [4, 5, 6], [7, 8, 9], [0, 0, 0]])

    def test_comments(self):
        text = "# made by hand\n% and\n// by\n> foot\n\n1 2 3 # the first\n! more\n4 5 6\n"
        self.assert_points(self.read(text, name="points.xyz"), [[1, 2, 3], [4, 5, 6]])

    def test_names_in_a_comment(self):
        found = self.read("# lat lon depth\n1 2 3\n4 5 6\n", name="points.txt")
        self.assert_points(found, [[2, 1, 3], [5, 4, 6]])
        self.assertEqual(found.names, ("lon", "lat", "depth"))


class Columns(FileTest):
    TEXT = "id;name;Northing [m];Easting (m);Depth (m);quality\n1;a;20;10;-5;0.5\n2;b;21;11;-6;0.7\n"

    def test_guessed_by_name(self):
        found = self.read(self.TEXT)
        self.assert_points(found, [[10, 20, -5], [11, 21, -6]])
        self.assertEqual(found.names[2], "Depth (m)")

    def test_chosen_by_name_in_any_case_and_by_number(self):
        expected = [[20, 10, 0.5], [21, 11, 0.7]]
        self.assert_points(self.read(self.TEXT, "northing", "Easting (m)", "quality"), expected)
        self.assert_points(self.read(self.TEXT, "3", "4", "6"), expected)

    def test_without_names_the_first_columns_of_numbers(self):
        found = self.read("a,1,2,3,9\nb,4,5,6,9\n")
        self.assert_points(found, [[1, 2, 3], [4, 5, 6]])
        self.assertIn("5 columns without names; choose others with --columns X,Y,Z", found.notes)

    def test_two_columns_are_flat_and_it_is_said(self):
        found = self.read("lon,lat\n1,2\n3,4\n")
        self.assert_points(found, [[1, 2, 0], [3, 4, 0]])
        self.assertFalse(found.has_z)
        self.assertIn("no third column of numbers: z is 0 everywhere", found.notes)

    def test_z_none(self):
        self.assert_points(self.read("1,2,3\n4,5,6\n", "1", "2", "none"), [[1, 2, 0], [4, 5, 0]])

    def test_a_guess_against_the_names_is_said(self):
        found = self.read("lon,lat,flux\n1,2,3\n")
        self.assert_points(found, [[1, 2, 3]])
        self.assertIn("no column is called z or depth or elevation: took flux", found.notes)

    def check_names(self, names, expected):
        """Rows under these names give the columns with these indexes as x, y and z."""
        rows = [[10.0 * row + column for column in range(len(names.split(",")))] for row in range(1, 4)]
        text = "\n".join(",".join(map(repr, row)) for row in rows)
        found = self.read(names + "\n" + text + "\n")
        self.assert_points(found, [[row[column] for column in expected] for row in rows])
        return found

    def test_words_within_names(self):
        for names, expected in (
                ("ID,Easting,Northing,Elevation_NAVD88", (1, 2, 3)), ("Tiefe,Rechtswert,Hochwert", (1, 2, 0)),
                ("PunktNr,Höhe ü. NN,Hochwert (GK3),Rechtswert (GK3)", (3, 2, 1)),
                ("FID,Nr,OBJECTID,Water depth,POINT_X,POINT_Y", (4, 5, 3)),
                ("row,lat_wgs84,Lon_wgs84,altGPS", (2, 1, 3)),
                ("Wassertiefe,Breitengrad,Längengrad", (2, 1, 0)), ("X (ETRS89),Y (ETRS89),HOEHE_DHHN", (0, 1, 2)),
                ("elevation_err,UTM_N,UTM_E,Elevation_NGVD", (2, 1, 3)), ("least,x,y,Surface_Elevation", (1, 2, 3)),
                ("latest,north_m,east_m,depth_std,z_min", (2, 1, 4)), (",x,y,z", (1, 2, 3)),
                ("Unnamed: 0,x,y,z", (1, 2, 3)),
                ("depth_sensor,x,y,height", (1, 2, 3))):
            with self.subTest(names=names):
                self.check_names(names, expected)
        found = self.read("Rechts;H\xf6he;Hoch\n1;2;3\n4;5;6\n".encode("cp1252"))
        self.assert_points(found, [[1, 3, 2], [4, 6, 5]])
        self.assertEqual(found.names, ("Rechts", "Hoch", "H\u00f6he"))

    def test_one_column_left_is_the_missing_one_and_counting_is_none(self):
        self.assert_points(self.read("x,y,ID\n1,2,3\n4,5,6\n"), [[1, 2, 0], [4, 5, 0]])
        self.check_names("OID,flux,x,y", (2, 3, 1))
        self.check_names("x,z,across", (0, 2, 1))

    def test_names_that_tell_too_little_are_refused(self):
        end = "choose with --columns X,Y,Z, by name or number, such as --columns "
        for names, words, example in (
                ("ID,foo,bar,baz", "which column is x and y and z? (no name says it)", "2,3,4"),
                ("x,y,temperature,salinity", "which column is z? (no name says it)", "1,2,3"),
                ("x,y,Elevation_NAVD88,Elevation_NGVD29",
                 "which column is z? (several could be: Elevation_NAVD88, Elevation_NGVD29)", "1,2,3"),
                ("foo,bar,depth,ID", "which column is x and y? (no name says it)", "1,2,3")):
            with self.subTest(names=names):
                text = names + "\n" + "\n".join(["1,2,3,4", "5,6,7,8"])
                listed = ", ".join("%d %s" % pair for pair in enumerate(names.split(","), 1))
                self.assert_refused(words, text)
                self.assert_refused(" This file has %s" % listed, text)
                self.assert_refused(end + example, text)
        chosen = self.read("ID,foo,bar,baz\n1,2,3,4\n5,6,7,8\n", "foo", "bar", "4")
        self.assert_points(chosen, [[2, 3, 4], [6, 7, 8]])

    def test_a_comment_or_a_row_with_numbers_that_names_nothing_is_no_header(self):
        for comment in ("made by hand", "depth in metres"):
            self.assert_points(self.read("# %s\n1 2 3\n4 5 6\n" % comment), [[1, 2, 3], [4, 5, 6]])
        self.assert_points(self.read("Bay 2020\n1 2 3\n4 5 6\n"), [[1, 2, 3], [4, 5, 6]])

    def test_longitude_and_latitude_in_words(self):
        for names, degrees in ((("Longitude_WGS84", "lat (deg)"), True), (("Längengrad", "Breitengrad"), True),
                               (("long", "latitude"), True), (("Easting", "lat"), False), (("x", "y"), False)):
            self.assertEqual(pointfiles.are_degrees(names + ("z",), -90.0, 90.0), degrees)
            self.assertFalse(pointfiles.are_degrees(names + ("z",), -90.0, 90.5))

    def test_unknown_names_and_numbers(self):
        self.assert_refused('no column "height" for z; this file has x, y, z', "x,y,z\n1,2,3\n", None, None, "height")
        self.assert_refused('no column "4" for x; this file has numbers 1 to 3', "1,2,3\n", "4")
        self.assert_refused('no column "0" for x', "1,2,3\n", "0")
        self.assert_refused('no column "\u00b2" for x; this file has numbers 1 to 3', "1,2,3\n", "\u00b2")
        self.assert_refused('no column "%s" for x' % ("9" * 5000), "1,2,3\n", "9" * 5000)


class BadRows(FileTest):
    def test_counted_and_shown(self):
        text = "x,y,z\n1,2,3\n4,five,6\n7,8\n,,\n9,10,11\nnan,1,2\n1_0,2,3\n"
        found = self.read(text)
        self.assertEqual(found.bad_rows, 4)
        self.assertEqual(found.xyz.shape, (3, 3))
        numpy.testing.assert_array_equal(found.xyz[:2], [[1, 2, 3], [9, 10, 11]])
        self.assertTrue(numpy.isnan(found.xyz[2, 0]), "nan is a number; the filter rejects it, not the reader")
        self.assertIn("4 of 7 rows cannot be read and are left out:", found.notes)
        self.assertIn("  line 3: 4,five,6", found.notes)

    def test_same_numbers_with_and_without_a_bad_row(self):
        """The fast reader and the careful one round alike."""
        rows = ["%r %r %r" % (x / 7, x / 11, 10.0 ** (x - 300)) for x in range(600)]
        fast = self.read("\n".join(rows))
        careful = self.read("\n".join(rows + ["a b c"]))
        self.assertEqual((fast.bad_rows, careful.bad_rows), (0, 1))
        self.assert_points(careful, fast.xyz)

    def test_an_empty_field_between_tabs_is_a_bad_row(self):
        found = self.read("1\t2\t3\t9\n4\t5\t\t9\n\t5\t6\t9\n6\t7\t8\t9\n")
        self.assertEqual(found.bad_rows, 2)
        self.assert_points(found, [[1, 2, 3], [6, 7, 8]])

    def test_files_that_cannot_be_used(self):
        self.assert_refused("holds no data", "")
        self.assert_refused("holds no data", "# nothing\n\n")
        self.assert_refused("holds a header and no data", "x,y,z\n")
        self.assert_refused("fewer than two columns", "1\n2\n3\n")
        self.assert_refused("none of its 2 rows has numbers in x = 1, y = 2, z = 3", "a,b,c\nd,e,f\n", "1", "2", "3")
        self.assert_refused("is not a text file", b"\x89PNG\r\n\0\0\0")


# Bytes of a record, from the tables of the LAS 1.4 R15 specification: point formats 0 to 10.
LAS_RECORD = (20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67)


def las(point_format=0, version=(1, 2), count=None, extra=0, points=POINTS, legacy=True):
    """A LAS file of integer coordinates 0.01 apart: the header fields the reader uses, and points."""
    header_size = {0: 227, 1: 227, 2: 227, 3: 235, 4: 375}[version[1]]
    start = header_size + 54  # as if a variable length record lay between
    length = LAS_RECORD[point_format & 0x3F] + extra
    header = bytearray(start)
    header[:4] = b"LASF"
    struct.pack_into("<BB", header, 24, *version)
    struct.pack_into("<HI", header, 94, header_size, start)
    count = len(points) if count is None else count
    struct.pack_into("<BHI", header, 104, point_format, length, count if legacy else 0)
    struct.pack_into("<6d", header, 131, 0.01, 0.01, 0.001, 1000.0, -500.0, 0.25)
    if version[1] >= 4:
        struct.pack_into("<Q", header, 247, count)
    records = b"".join(struct.pack("<3i", *point) + b"\xaa" * (length - 12) for point in points)
    return bytes(header) + records


class NoData(FileTest):
    def points(self, *heights):
        return self.read("x,y,depth\n" + "".join("%d,%d,%r\n" % (i, i * i, z) for i, z in enumerate(heights)))

    def test_a_number_that_repeats_and_lies_far_off_is_said(self):
        for number, word in (
            (-9999, "-9999"), (-32768.0, "-32768"), (1e20, "1e+20"), (-9999999, "-9999999"), (-99999.99, "-99999.99"),
            (-3.4028234663852886e38, "-3.4028234663852886e+38"),
        ):  # fmt: skip
            given = self.points(1, 2, 3.5, number, number, number)
            (said,) = nodata.notes(given)
            self.assertIn("3 points have a depth of %s, far" % word, said)
            self.assertIn("--nodata %s leaves" % word, said)
            self.assertEqual(len(nodata.without(given, float(word)).xyz), 3)
        for heights in ((1, 2, 3, -9999, -9999), (1, 2, 9, -4, -4, -4), (5, 5, 5, 7, 7, 7), (0, 0, 0)):
            self.assertEqual(nodata.notes(self.points(*heights)), [], heights)

    def test_points_that_have_it_are_left_out(self):
        given = self.points(1, -9999, 2, -9999, -9998)
        left = nodata.without(given, -9999.0)
        self.assertEqual(left.xyz[:, 2].tolist(), [1, 2, -9998])
        self.assertEqual(left.notes[:-1], given.notes)
        self.assertIn("2 points left out, as their depth is -9999", left.notes[-1])
        without_number = given._replace(xyz=numpy.where(given.xyz == -9999, numpy.nan, given.xyz))
        self.assertEqual(nodata.without(without_number, math.nan).xyz[:, 2].tolist(), [1, 2, -9998])
        with self.assertRaisesRegex(InputError, "no point has another depth"):
            nodata.without(self.points(7, 7), 7.0)


class Las(FileTest):
    INTEGERS = [[0, 0, 0], [63717798, -84939395, 411190], [-(2**31), 2**31 - 1, 7]]

    def expected(self):
        return numpy.array(self.INTEGERS) * numpy.array([0.01, 0.01, 0.001]) + numpy.array([1000.0, -500.0, 0.25])

    def test_every_version_and_format(self):
        for minor in range(5):
            for point_format in range(11):
                for extra in (0, 5):
                    with self.subTest(minor=minor, point_format=point_format, extra=extra):
                        data = las(point_format, (1, minor), extra=extra, points=self.INTEGERS)
                        found = self.read(data, name="points.las")
                        self.assert_points(found, self.expected())
                        self.assertEqual(found.bad_rows, 0)

    def test_14_counts_beyond_the_old_field(self):
        data = las(6, (1, 4), points=self.INTEGERS, legacy=False)
        self.assert_points(self.read(data, name="points.las"), self.expected())

    def test_a_file_that_ends_early_is_read_as_far_as_it_goes_and_that_is_said(self):
        found = self.read(las(count=10, points=self.INTEGERS) + b"\1" * 7, name="points.las")
        self.assert_points(found, self.expected())
        self.assertEqual(found.bad_rows, 7)
        self.assertIn("the file ends early: 7 points its header promises are missing", found.notes)

    def test_files_that_cannot_be_used(self):
        good = las(points=self.INTEGERS)
        self.assert_refused("is compressed (LAZ)", las(3 | 0x80, points=self.INTEGERS), name="points.las")
        self.assert_points(self.read(good, name="points.laz"), self.expected())  # not compressed, whatever its name
        self.assert_refused("does not begin with LASF", b"LASS" + good[4:], name="points.las")
        self.assert_refused("does not begin with LASF", b"", name="points.las")
        self.assert_refused("LAS 2.0 with point format 0", good[:24] + b"\2\0" + good[26:], name="points.las")
        self.assert_refused("with point format 11", good[:104] + b"\x0b" + good[105:], name="points.las")
        short = good[:105] + b"\5\0" + good[107:]
        self.assert_refused("records have 5 bytes, point format 0 needs 20", short, name="points.las")
        self.assert_refused("holds no points", las(points=[]), name="points.las")
        for start in (0, 226):
            lying = good[:96] + struct.pack("<I", start) + good[100:]
            self.assert_refused("begin at byte %d, inside the header" % start, lying, name="points.las")
        self.assert_refused("columns are for tables", good, "1", "2", name="points.las")


if __name__ == "__main__":
    unittest.main()
