# SPDX-License-Identifier: BSD-3-Clause
"""Points out of text tables and LAS files, with numpy alone.

read_points(path) gives a PointSet. Nothing is left out silently: rows that cannot be read are
counted, and the count and the first of them stand in PointSet.notes. A file that cannot be used
at all raises InputError with a message for the person who gave the file.
"""

import codecs
import collections
import csv
import math
import os
import re
import string
import struct
import unicodedata

import numpy

TABLES = (".csv", ".xyz", ".txt")
LAS = (".las", ".laz")

COMMENTS = ("#", "%", "//", "!", ">")  # what a line that is no data begins with

MINUS = dict.fromkeys(map(ord, "\u2212\u2010\u2011\u2013\ufe63\uff0d"), "-")  # as word processors write it

# Column names taken for x, y and z, most telling first: as spelled() writes them.
NAMES = {
    "x": ("x", "lon", "long", "longitude", "easting", "east", "e", "utm_x", "utm_e", "x_coord", "xcoord", "point_x"),
    "y": ("y", "lat", "latitude", "northing", "north", "n", "utm_y", "utm_n", "y_coord", "ycoord", "point_y"),
    "z": ("z", "depth", "elevation", "elev", "height", "altitude", "alt", "bathymetry", "topography",
          "h", "z_coord", "zcoord", "point_z"),
}  # fmt: skip
# Words in other names that say the same: a whole word; what one begins with; what one begins or ends with.
WORDS = {
    "x": "x|lon|long|east|este|rechts|(longitude|easting|rechtswert|langengrad|laengengrad|ostwert).*",
    "y": "y|lat|north|norte|hoch|(latitude|northing|hochwert|breitengrad|nordwert).*",
    "z": "z|alt|cota|quota|(elev|altitude|altura|bathym|topogr|profond|profund|hauteur|hoogte|diepte).*"
         "|(height|depth|hohe|hoehe|tiefe).*|.*(height|depth|hohe|hoehe|tiefe)",
}  # fmt: skip
# Words of columns that count or tell of another column: never x, y or z by themselves.
COUNTING = frozenset("""id ids fid oid gid uid objectid pointid rowid nr no num number nummer numero index idx row line
    count unnamed punktnr punktnummer pktnr""".split())
TELLING = frozenset("""err error std stddev sigma rms rmse variance uncertainty accuracy quality flag source datum
    date time unit""".split())
METRES_PER_DEGREE = 111195.0  # of latitude, on a sphere of 6371 km
DEGREES = "lon|long|lat|(longitude|latitude|langengrad|laengengrad|breitengrad).*"

# Bytes of a point record, by LAS point format 0 to 10. Longer ones carry extra bytes.
LAS_RECORD = (20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67)


class InputError(Exception):
    """The file cannot be used. The message says why and what to do."""


# xyz: n × 3 float64 · names: of the three columns · notes: lines the user should read
# bad_rows: rows that could not be read · has_z: False where z was made up as 0
PointSet = collections.namedtuple("PointSet", "xyz names notes bad_rows has_z")


def read_points(path, columns=(None, None, None)):
    """Points of a table (.csv, .xyz, .txt) or a LAS file, by the name's ending."""
    ending = os.path.splitext(path)[1].lower()
    if ending in LAS:
        if any(column is not None for column in columns):
            raise InputError("columns are for tables; a LAS file has x, y and z of its own")
        return read_las(path)
    return read_table(path, columns)


# --- tables -------------------------------------------------------------------------------------


def read_table(path, columns=(None, None, None)):
    """A text table. columns: for x, y, z a name, a number counted from 1, or None for a guess;
    "none" for z makes a flat set."""
    try:
        return read_rows(path, columns)
    except csv.Error as error:  # the one that is left: a field is too long
        raise InputError("%s: %s, as if a quote were not closed" % (path, error)) from error


def read_rows(path, columns):
    rows, comment = significant_lines(read_text(path))
    if not rows:
        raise InputError("%s holds no data" % path)
    layout = Layout.of([line for _, line in rows[:200]], any('"' in line for _, line in rows))
    header = find_header(rows, comment, layout)
    if header and header.in_data:
        rows = rows[1:]
    if not rows:
        raise InputError("%s holds a header and no data" % path)
    width = max(len(layout.split(line)) for _, line in rows[:200])
    names = header.names if header else []
    names = names + [str(i + 1) for i in range(len(names), width)]
    chosen, notes = choose_columns(columns, names, layout, rows, header)
    values, bad = parse(rows, layout, chosen)
    if not len(values):
        raise InputError(
            "%s: none of its %d rows has numbers in %s; choose with --columns X,Y,Z"
            % (path, len(rows), describe(chosen, names))
        )
    notes.insert(0, "columns: " + describe(chosen, names) + ", " + layout.words())
    notes += bad_row_notes(bad, len(rows))
    has_z = chosen[2] is not None
    xyz = values if has_z else numpy.column_stack([values, numpy.zeros(len(values))])
    return PointSet(xyz, column_names(chosen, names, bool(header)), notes, len(bad), has_z)


def read_text(path):
    with open(path, "rb") as file:
        data = file.read()
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return data.decode("utf-16", errors="replace")
    zero = data.find(b"\0")
    if zero >= 0:
        raise InputError("%s is not a text file: byte %s is zero" % (path, thousands(zero + 1)))
    return data.decode("utf-8-sig", errors="as cp1252")


# What is not UTF-8 is taken for the one other way in which text tables are written.
codecs.register_error(
    "as cp1252", lambda error: (error.object[error.start : error.end].decode("cp1252", "replace"), error.end))


def significant_lines(text):
    """[(line number, line)] without blank lines and comments, and the last comment before them."""
    rows, comment = [], ""
    if "\r" in text:
        text = text.replace("\r\n", "\n").replace("\r", "\n")
    for number, line in enumerate(text.split("\n"), 1):
        line = line.strip(" ")  # a tab may stand for an empty field
        if not line.strip():
            continue
        if line.lstrip().startswith(COMMENTS):
            if not rows:
                comment = line.lstrip().lstrip("#%/!> ")
            continue
        rows.append((number, without_comment(line) if "#" in line else line))
    return rows, comment


def without_comment(line):
    """Up to a # that begins the line or stands behind a space, a number or what divides fields: not the # of a name
    such as Buoy#3. Once through the line, whatever is in it."""
    at, begin = line.find("#"), 0
    while at >= 0:
        end = at
        while end > begin and line[end - 1] == " ":
            end -= 1
        if end < at or end == 0 or re.match(r"[\s,;\d.]", line[end - 1]):
            return line[:end]
        at, begin = line.find("#", at + 1), at + 1
    return line


class Layout:
    """How a line of the table is cut into fields."""

    WORDS = {",": "commas", ";": "semicolons", "\t": "tabs", None: "spaces"}
    DECIMAL_COMMA = re.compile(r"[+-]?\d*,\d+([eE][+-]?\d+)?$", re.ASCII)

    def __init__(self, delimiter, decimal_comma, quoted):
        self.delimiter, self.decimal_comma, self.quoted = delimiter, decimal_comma, quoted

    @classmethod
    def of(cls, lines, quoted):
        """Told from the first lines: a delimiter that nearly all of them have, tab and semicolon
        before comma, as a comma may also be a decimal one; of several the first that cuts them into
        numbers, as the others may stand in text. quoted: whether any line has quotes."""
        found = [cls.by(delimiter, lines, quoted) for delimiter in ("\t", ";", ",")
                 if sum(delimiter in line for line in lines) >= 0.8 * len(lines)]
        found.append(cls.by(None, lines, False))
        return next((layout for layout in found if layout.gives_numbers(lines)), found[0])

    @classmethod
    def by(cls, delimiter, lines, quoted):
        if delimiter == "," and cls.spaced_decimal_commas(lines):
            return cls(None, True, False)
        fields = [field for line in lines for field in line.split(delimiter)]
        return cls(delimiter, delimiter != "," and cls.any_decimal_comma(fields), quoted)

    def gives_numbers(self, lines):
        """Do half of the lines have two numbers at least?"""
        good = sum(sum(map(self.is_number, self.split(line))) > 1 for line in lines)
        return 2 * good >= len(lines)

    @classmethod
    def any_decimal_comma(cls, fields):
        return any(cls.DECIMAL_COMMA.match(field.strip(' "').translate(MINUS)) for field in fields)

    @classmethod
    def spaced_decimal_commas(cls, lines):
        """Lines like 1,5 2,25 -3,0: spaces between, commas within the numbers."""
        good = 0
        for line in lines:
            fields = line.split()
            good += len(fields) > 1 and all(cls.DECIMAL_COMMA.match(field.translate(MINUS)) for field in fields)
        return good >= 0.8 * len(lines)

    def split(self, line):
        if self.delimiter is None:
            return line.split()
        if self.quoted:
            return [f.strip() for f in next(csv.reader([line], delimiter=self.delimiter, skipinitialspace=True))]
        return [field.strip() for field in line.split(self.delimiter)]

    def number(self, field):
        """The field as a float; ValueError where it is none (Python also takes 1_000: we do not)."""
        if "_" in field:
            raise ValueError(field)
        field = field.translate(MINUS) if not field.isascii() else field
        return float(field.replace(",", ".") if self.decimal_comma else field)

    def is_number(self, field):
        try:
            self.number(field)
        except ValueError:
            return False
        return True

    def words(self):
        return self.WORDS[self.delimiter] + " between" + (", decimal commas" if self.decimal_comma else "")


Header = collections.namedtuple("Header", "names in_data")


def find_header(rows, comment, layout):
    """The first row is a header if it has text where the second, or half of the next (below a row
    of units), has a number. Else the comment above the data is one if it has as many words as the
    data has columns, none a number."""
    first = layout.split(rows[0][1])
    below = [layout.split(line) for _, line in rows[1:20]]
    for column, here in enumerate(first):
        numbers = [column < len(fields) and layout.is_number(fields[column]) for fields in below]
        if here and not layout.is_number(here) and below and (numbers[0] or 2 * sum(numbers) >= len(numbers)):
            return Header(first, True)
    if len(rows) == 1 and not any(layout.is_number(field) for field in first):
        return Header(first, True)
    names = layout.split(comment) if comment else []
    if len(names) == len(first) and not any(layout.is_number(name) for name in names):
        return Header(names, False)
    return None


def plain(name):
    """A column's name in lower case, without quotes and without its unit: "Depth (m)" is depth."""
    name = without_brackets(name.strip(' "\'').lower()).strip()
    unit = re.search(r"(degrees|metres|meters|feet|deg|ft|m)$", name)
    return name[: unit.start()].rstrip("_.-" + string.whitespace) or name if unit else name


def without_brackets(text):
    """Without what stands in round or square brackets. Once through the text, whatever is in it."""
    kept, begin = [], 0
    while True:
        opening = re.compile(r"[(\[]").search(text, begin)
        closing = opening and re.compile(r"[)\]]").search(text, opening.end())
        if not closing:
            return "".join(kept) + text[begin:]
        kept.append(text[begin : opening.start()])
        begin = closing.end()


def spelled(name):
    """plain(name) without accents: "Höhe [m]" is hohe."""
    parts = unicodedata.normalize("NFKD", plain(name).casefold())
    return "".join(part for part in parts if not unicodedata.combining(part))


def words_of(name):
    """The words in a column's name, as spelled() writes them: of PunktNr_2 punkt and nr."""
    name = re.sub(r"(?<=[a-zäöü])(?=[A-ZÄÖÜ])", " ", without_brackets(name))
    return re.findall(r"[a-z]+", spelled(name))


def counts(name):
    """Does a column of this name count its rows (ID, FID, Nr)? One without a name among others does."""
    return not name.strip(' "\'') or not COUNTING.isdisjoint(words_of(name))


def says(pattern, name):
    """Does one of the words in a column's name say this?"""
    words = words_of(name)
    return TELLING.isdisjoint(words) and any(re.fullmatch(pattern, word) for word in words)


def are_degrees(names, south, north):
    """Do the names of x and y say longitude and latitude, and can the range of y be one of latitudes?"""
    return all(says(DEGREES, name) for name in names[:2]) and abs(south) <= 90 and abs(north) <= 90


def choose_columns(wanted, names, layout, rows, header):
    """Index of the x, y and z columns (z may be None), and notes on what was guessed."""
    no_z = wanted[2] is not None and wanted[2].lower() == "none"
    chosen = [None, None, None]
    for axis, want in enumerate(wanted):
        if want is not None and not (axis == 2 and no_z):
            chosen[axis] = named_column(want, names, "xyz"[axis], bool(header))
    axes = range(2 if no_z else 3)
    numbers = columns_of_numbers(layout, rows)
    guess = list(chosen)
    told = header and guess_by_names(axes, names, numbers, guess)
    # a comment that does not name x and y is prose
    told = told and (header.in_data or guess[0] is not None and guess[1] is not None)
    chosen = guess if told else chosen
    free = [column for column in numbers if column not in chosen and not (header and counts(names[column]))]
    missing = [axis for axis in axes if chosen[axis] is None]
    if len(numbers) < 2 and any(axis < 2 for axis in missing):
        raise InputError("fewer than two columns of numbers: x and y are needed")
    # a row that has numbers, too, need not be a header
    if told or header and header.in_data and not any(map(layout.is_number, header.names)):
        if len(missing) > 1 or len(missing) == 1 and len(free) != 1 and (free or missing != [2]):
            refuse_to_guess(missing, names, numbers)
    notes = []
    for axis, column in zip(missing, free):
        chosen[axis] = column
        if header:
            notes.append("no column is called %s: took %s" % (" or ".join(NAMES["xyz"[axis]][:3]), names[column]))
    if chosen[0] is None or chosen[1] is None:
        raise InputError("fewer than two columns of numbers: x and y are needed")
    if chosen[2] is None and not no_z:
        notes.append("no third column of numbers: z is 0 everywhere")
    if not header and len(names) > 3 and not any(wanted):
        notes.append("%d columns without names; choose others with --columns X,Y,Z" % len(names))
    return chosen, notes


def refuse_to_guess(missing, names, numbers, found=()):
    """Raises InputError: these axes have no column, or one of several that are found."""
    which = " and ".join("xyz"[axis] for axis in missing)
    why = "several could be: " + ", ".join(found) if found else "no name says it"
    listed = ", ".join("%d %s" % pair for pair in enumerate(names, 1))
    example = ",".join(str(column + 1) for column in [c for c in numbers if not counts(names[c])][:3])
    raise InputError("which column is %s? (%s) This file has %s; choose with --columns X,Y,Z, by name or number, "
                     "such as --columns %s" % (which, why, listed, example or "1,2,3"))


def named_column(want, names, axis, has_header):
    """The index of the column the user asked for, by exact name, name in any case, or number."""
    for same in (lambda name: name == want, lambda name: plain(name) == plain(want)):
        if has_header and any(same(name) for name in names):
            return next(i for i, name in enumerate(names) if same(name))
    if want.isdecimal() and len(want) < 10 and 1 <= int(want) <= len(names):
        return int(want) - 1
    known = ", ".join(names) if has_header else "numbers 1 to %d" % len(names)
    raise InputError('no column "%s" for %s; this file has %s' % (want, axis, known))


def guess_by_names(axes, names, numbers, chosen):
    """Sets what the names tell: whole names first, then words in those of columns of numbers. True if one told."""
    bare = ["" if counts(name) else spelled(name) for name in names]
    open_axes = [axis for axis in axes if chosen[axis] is None]
    for axis in open_axes:
        chosen[axis] = next((bare.index(candidate) for candidate in NAMES["xyz"[axis]]
                             if candidate in bare and bare.index(candidate) not in chosen), None)
    for axis in open_axes:
        found = [column for column in numbers if column not in chosen and bare[column]
                 and says(WORDS["xyz"[axis]], names[column])]
        if chosen[axis] is None and len(found) > 1:
            refuse_to_guess([axis], names, numbers, [names[column] for column in found])
        if chosen[axis] is None and found:
            chosen[axis] = found[0]
    return any(chosen[axis] is not None for axis in open_axes)


def columns_of_numbers(layout, rows):
    """The columns that hold a number in most of the first rows."""
    sample = [layout.split(line) for _, line in rows[:20]]
    return [column for column in range(max(map(len, sample))) if 2 * sum(
        column < len(fields) and layout.is_number(fields[column]) for fields in sample) >= len(sample)]


def parse(rows, layout, chosen):
    """The chosen columns as floats, and the rows that do not have them as [(number, line)]."""
    use = [column for column in chosen if column is not None]
    if not layout.quoted and not layout.decimal_comma:
        try:  # fast, but gives up at the first bad row
            lines = [line for _, line in rows]
            values = numpy.loadtxt(lines, delimiter=layout.delimiter, usecols=use, comments=None, ndmin=2)
            return values, []
        except ValueError:
            pass
    good, bad = [], []
    for number, line in rows:
        try:
            fields = layout.split(line)
            good.append([layout.number(fields[column]) for column in use])
        except (ValueError, IndexError):
            bad.append((number, line))
    return numpy.array(good, dtype=float).reshape(-1, len(use)), bad


def bad_row_notes(bad, total):
    if not bad:
        return []
    notes = ["%s of %s rows cannot be read and are left out:" % (thousands(len(bad)), thousands(total))]
    notes += ["  line %d: %s" % (number, line[:60]) for number, line in bad[:3]]
    return notes + (["  ..."] if len(bad) > 3 else [])


def describe(chosen, names):
    parts = ["%s = %s" % ("xyz"[axis], names[column]) for axis, column in enumerate(chosen) if column is not None]
    return ", ".join(parts)


def column_names(chosen, names, has_header):
    if not has_header:
        return ("x", "y", "z")
    return tuple("z" if column is None else names[column].strip(' "') for column in chosen)


def thousands(number):
    """12345 as 12,345."""
    return "{:,}".format(number)


# --- LAS ----------------------------------------------------------------------------------------


def read_las(path):
    """An uncompressed LAS file, versions 1.0 to 1.4, point formats 0 to 10; every return is a
    point, coordinates are integer · scale + offset as the format says."""
    with open(path, "rb") as file:
        head = file.read(375)
    if head[:4] != b"LASF" or len(head) < 227:
        raise InputError("%s is not a LAS file (it does not begin with LASF)" % path)
    version = struct.unpack_from("<BB", head, 24)
    start, = struct.unpack_from("<I", head, 96)
    point_format, length, count = struct.unpack_from("<BHI", head, 104)
    scale, offset = struct.unpack_from("<3d", head, 131), struct.unpack_from("<3d", head, 155)
    if version >= (1, 4) and len(head) >= 255:
        count, = struct.unpack_from("<Q", head, 247)
    check_las(path, version, point_format, length)
    check_scales(path, scale, offset)
    if start < 227:  # bytes of the shortest header
        raise InputError("%s is damaged: its points are said to begin at byte %d, inside the header" % (path, start))
    available = max(0, os.path.getsize(path) - start) // length
    notes = ["LAS %d.%d, point format %d, %s points" % (version + (point_format, thousands(count)))]
    missing = max(0, count - available)
    if missing:
        notes.append("the file ends early: %s points its header promises are missing" % thousands(missing))
    if count == missing:
        raise InputError("%s holds no points" % path)
    record = numpy.dtype({"names": ["xyz"], "formats": ["(3,)<i4"], "offsets": [0], "itemsize": length})
    raw = numpy.memmap(path, dtype=record, mode="r", offset=start, shape=(count - missing,))["xyz"]
    return PointSet(raw * numpy.array(scale) + numpy.array(offset), ("x", "y", "z"), notes, missing, True)


def check_las(path, version, point_format, length):
    if point_format & 0xC0:
        raise InputError("%s is compressed (LAZ); give it a name that ends in .laz" % path)
    if version[0] != 1 or version[1] > 4 or point_format >= len(LAS_RECORD):
        raise InputError(
            "%s is LAS %d.%d with point format %d; known are LAS 1.0 to 1.4 with formats 0 to 10"
            % (path, version[0], version[1], point_format)
        )
    if length < LAS_RECORD[point_format]:
        raise InputError(
            "%s is damaged: its records have %d bytes, point format %d needs %d"
            % (path, length, point_format, LAS_RECORD[point_format])
        )


def check_scales(path, scale, offset):
    for axis, factor, zero in zip("xyz", scale, offset):
        if not (math.isfinite(factor) and factor != 0):
            raise InputError("%s is damaged: the scale of %s is %g" % (path, axis, factor))
        if not math.isfinite(zero):
            raise InputError("%s is damaged: the offset of %s is %g" % (path, axis, zero))


def is_compressed(path):
    """Is it a LAS file whose points are compressed, as those of a .laz are?"""
    with open(path, "rb") as file:
        head = file.read(105)
    return head[:4] == b"LASF" and len(head) == 105 and head[104] & 0x80 != 0
