# SPDX-License-Identifier: BSD-3-Clause
"""Whether a PLY file can have the vertices that its header promises: VTK's reader believes what it is told."""

import os

from pointfiles import InputError, thousands

# Bytes of a number in a binary file.
SIZES = {
    "char": 1, "uchar": 1, "int8": 1, "uint8": 1, "short": 2, "ushort": 2, "int16": 2, "uint16": 2,
    "int": 4, "uint": 4, "int32": 4, "uint32": 4, "float": 4, "float32": 4, "double": 8, "float64": 8,
}  # fmt: skip
LONGEST = 1 << 16  # bytes of a line of the header, and lines


def check(path):
    """Raises InputError unless x, y and z of so many vertices have room in the file."""
    with open(path, "rb") as file:
        lines = list(header(file, path))
        begin = file.tell()
    room = os.path.getsize(path) - begin
    text = any(line[:2] == ["format", "ascii"] for line in lines)
    count, properties = vertices(lines, path)
    if count == 0:
        raise InputError("%s holds no points" % path)
    for axis in "xyz":
        kinds = [words[0] for words in properties if words[-1] == axis]
        if not kinds:
            raise InputError("%s: its vertices have no %s" % (path, axis))
        if kinds[0] == "list":
            raise InputError("%s: %s of its vertices is a list, not a number" % (path, axis))
    # a digit and what divides it from the next; of a list at least its length
    least = sum(2 if text else SIZES.get(words[1 if words[0] == "list" else 0], 1) for words in properties)
    if count < 0 or count * least > room + int(text):  # no new line may end the last
        raise InputError("%s is damaged: its header promises %s vertices, and %s bytes follow it" % (
            path, thousands(count), thousands(room)))
    if text:  # of a list at least its length
        check_words(path, begin, count, count * len(properties))


def check_words(path, begin, count, least):
    """Raises InputError unless so many words follow the header: VTK's reader makes up what is missing (9.3) or dies."""
    words = 0
    with open(path, "rb") as file:
        file.seek(begin)
        for line in file:
            words += len(line.split())
            if words >= least:
                return
    raise InputError("%s is damaged: its header promises %s vertices, which take %s numbers, and %s follow it" % (
        path, thousands(count), thousands(least), thousands(words)))


def header(file, path):
    """The words of each line up to end_header."""
    for number in range(LONGEST):
        words = file.readline(LONGEST).decode("ascii", errors="replace").split()
        if number == 0 and words != ["ply"]:
            raise InputError("%s is not a PLY file (its first line is not: ply)" % path)
        if words == ["end_header"]:
            return
        yield words
    raise InputError("%s is damaged: its header has no end" % path)


def vertices(lines, path):
    """The number of vertices, and the words of their properties without the first."""
    count, properties, element = None, [], ""
    for words in lines:
        if words[:1] == ["element"] and len(words) == 3:
            element = words[1]
            if element == "vertex":
                count = words[2]
        elif words[:1] == ["property"] and len(words) >= 3 and element == "vertex":
            properties.append(words[1:])
    try:
        return int(count), properties
    except (TypeError, ValueError):
        raise InputError("%s is damaged: its header does not say how many vertices there are" % path) from None
