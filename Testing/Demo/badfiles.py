# SPDX-License-Identifier: BSD-3-Clause
"""Files that the demo must refuse, and the message for each."""

import struct


def ply(vertices, properties="xyz", rows=b"0 0 0\n", kind="ascii", number="float"):
    head = "ply\nformat %s 1.0\nelement vertex %s\n" % (kind, vertices)
    head += "".join("property %s %s\n" % (number, name) for name in properties)
    return head.encode() + b"end_header\n" + rows


def las(scale=(0.01, 0.01, 0.01), offset=(0.0, 0.0, 0.0), points=5):
    header = bytearray(227)
    header[:4] = b"LASF"
    struct.pack_into("<BB", header, 24, 1, 2)
    struct.pack_into("<HI", header, 94, 227, 227)
    struct.pack_into("<BHI", header, 104, 0, 20, points)
    struct.pack_into("<6d", header, 131, *scale, *offset)
    return bytes(header) + b"".join(struct.pack("<3i", k * k, 7 * k, k) + bytes(8) for k in range(points))


VTK = b"# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS %s float\n1 2 3\n"

# Those that crash VTK's readers, or that they accept.
FOR_VTK = {
    "much.vtk": (VTK % b"1000000000000", "its reader was stopped by SIGABRT, saying: Unable to allocate"),
    "short.vtk": (VTK % b"5", "Error reading ascii data"),
    "noise.vtk": (b"noise\n", "cannot read"),
    "noise.vtp": (b"noise\n", "cannot read"),
    "cut.vtp": (b'<?xml version="1.0"?>\n<VTKFile type="PolyData" version="0.1">\n<PolyData>\n', "cannot read"),
    "giant.ply": (ply(4000000000), "its header promises 4,000,000,000 vertices, and 6 bytes follow it"),
    "negative.ply": (ply(-5), "its header promises -5 vertices"),
    "cut.ply": (ply(9, rows=b"0 0 0\n1 0 0\n"), "its header promises 9 vertices, and 12 bytes follow it"),
    "rows.ply": (ply(9, rows=b"0.125 0.25 0.0625\n" * 5), "which take 27 numbers, and 15 follow it"),
    "binary.ply": (ply(3, rows=bytes(35), kind="binary_little_endian"), "promises 3 vertices, and 35 bytes"),
    "x-only.ply": (ply(3, "x", b"1\n2\n3\n"), "its vertices have no y"),
    "list.ply": (ply(3, "x", b"\3\xff\xff\xff", "binary_little_endian", "list uchar float"), "is a list, not a"),
    "none.ply": (ply(0, rows=b""), "holds no points"),
    "word.ply": (ply("many"), "does not say how many vertices there are"),
    "open.ply": (b"ply\nformat ascii 1.0\n", "its header has no end"),
    "noise.ply": (b"noise\n", "is not a PLY file"),
}  # fmt: skip

HILL = b"".join(b"%d,%d,%d\n" % (i % 20, i // 20, i % 7) for i in range(400))
QUOTED = b'x,y,z,n\n4,5,6,"a"\n1,2,3,"' + b"q" * 200000 + b'"\n7,8,1,b\n'

FOR_THE_DEMO = {
    "field.csv": (QUOTED, "field larger than field limit (131072), as if a quote were not closed"),
    "field-late.csv": (b'x,y,z,n\n4,5,6,"a"\n' + b"1,2,3,b\n" * 500 + QUOTED[18:], "field larger than field limit"),
    "null.csv": (b"x,y,z\n" + b"1,2,3\n2,5,3\n" * 1000 + b"1,2\0,3\n", "is not a text file: byte 12,010 is zero"),
    "scale.las": (las(scale=(0.0, 0.01, 0.01)), "the scale of x is 0"),
    "scale-nan.las": (las(scale=(1.0, float("nan"), 1.0)), "the scale of y is nan"),
    "offset.las": (las(offset=(0.0, 0.0, float("inf"))), "the offset of z is inf"),
}

# Surfaces that cannot be drawn.
FOR_THE_PICTURE = {
    "huge.csv": (b"x,y,z\n1e308,-1e308,1e308\n-1e308,1e308,0\n1e308,1e308,3\n0,0,0\n", "as large as 1e+308 cannot"),
    "high.csv": (b"x,y,z\n0,0,1e308\n1,0,-1e308\n0,1,0\n", "as large as 1e+308 cannot"),
    "tiny.csv": (b"x,y,z\n0,0,1\n1e-300,0,1\n0,1e-300,1\n", "an extent as small as 1.41e-300 cannot"),
}
