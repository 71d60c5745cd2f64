#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes Report.md: for every feature and door what is estimated beside what is taken. Run as Package.Memory is:

    LD_PRELOAD=build/lib/libAhdCountedMemory.so PYTHONPATH=build/lib/python3.11/dist-packages python3 report.py
"""

from pathlib import Path

from memorycases import CLASSES, COUNT, FEATURES, SAMPLINGS, of_arrays, of_class, of_sampler, warm

HEAD = """# What is estimated and what is taken

Written by [`report.py`](report.py): bytes a point, of %(count)d uniform points on one thread, the input not counted.
*Estimate*: what `MemoryEstimate` is in the end, by [`RunMemory`](../../../Filters/Engine/Job/RunMemory.h), the same
for both classes; a megabyte of it (%(small)d bytes a point here) is for all that does not grow with the points.
*Compiled*, *in Python*: the most that `Update()` held at a time, its outputs among it, counted at `malloc`; and the
estimate over the smaller one. *NumPy*: the estimate of `delaunay` and what it and its arrays held, with ids of 32 bits.
[`test_memory.py`](test_memory.py) holds all to these factors: 1.5 for uniform points; 2 where the input is the worst
there is, or decides how much there is to put out, and for NumPy, whose ids take half.

Where the estimate is far above: of pairs of points there are fewer vertices than there is room for, and so with what
`tolerance` merges; with `alpha` there may be lines in place of triangles, three a point; regions may be as many as
triangles, and places lie outside. What segments need that cross others or are long is asked for while they are
inserted, and part of the estimate then.

"""


def row(name, *columns):
    return "| %s | %s |\n" % (name, " | ".join(columns))


def per_point(size):
    return "%.0f" % (size / COUNT)


def of_classes(cases, measure):
    for of in cases:
        compiled, in_python = (measure(of, door) for door in CLASSES)
        least = min(compiled.most, in_python.most)
        yield of, [per_point(compiled.estimate), per_point(compiled.most), per_point(in_python.most),
                   "%.2f" % (compiled.estimate / least)]


def main():
    warm()
    text = HEAD % dict(count=COUNT, small=round(2**20 / COUNT))
    text += row("", "estimate", "compiled", "in Python", "factor", "NumPy: estimate", "taken", "factor")
    text += row("---", *7 * ["---:"])
    for of, columns in of_classes(FEATURES, of_class):
        arrays = of_arrays(of) if of.keywords is not None else None
        columns += [per_point(arrays.estimate), per_point(arrays.most), "%.2f" % (arrays.estimate / arrays.most)
                    ] if arrays else 3 * [""]
        text += row(of.name, *columns)
    text += "\nInterpolation, on a raster of as many cells unless it is said otherwise:\n\n"
    text += row("", "estimate", "compiled", "in Python", "factor")
    text += row("---", *4 * ["---:"])
    for of, columns in of_classes(SAMPLINGS, of_sampler):
        text += row(of.name, *columns)
    Path(__file__).with_name("Report.md").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
