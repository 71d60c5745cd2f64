# SPDX-License-Identifier: BSD-3-Clause
"""What one door warns of the others warn of, too: the compiled classes, those in Python, and NumPy. Whoever adds a
warning at one of them has to add it at the others, or say here why it cannot come up there.

What is told of data sets of VTK, blocks and ranks has no counterpart and is made elsewhere.
"""

import ast
import re
import unittest

import arraysupport  # noqa: F401 (its folder's is on the path now)
import literals

# A piece of each warning of vtkAdaptiveHilbertDelaunay2D, and one of NumPy's; or why there is none in `why not`.
OF_TRIANGULATIONS = (
    ("asks for a Transform", "why not: a plane is given with its matrix"),
    ("There is no bounding triangulation", "why not: ValueError"),
    ("does not have one value for each of the", "why not: ValueError"),
    (" points were left out, since ", " points were left out, since "),
    ("have a z that is NaN or infinite", "have a z that is NaN or infinite"),
    ("The Voronoi diagram lies in the plane z = 0", "why not: its corners are always put out in the plane"),
    ("and MaximumEdgeLength leave|MaximumEdgeLength leave", "alpha and maximum_edge_length leave"),
    ("There is no triangle yet", "There is no triangle yet"),
    ("all distinct points are collinear: ", " among "),
    ("of each stack one ", "of each stack one "),
    ("polygons of the source keep none of the", "the loops keep none of the"),
    (" the rim took ", "Trimming the rim took "),
    ("The source constrains nothing", "The source_points constrain nothing"),
    (" ignored: lines and polygons constrain", "why not: there are no strips"),
    ("lie outside the surface", "lie outside the surface"),
    ("were left out, since they cross others", "were left out, since they cross others"),
    (" by rounding, led through a point", " by rounding, led through a point"),
    ("of the ids in its cells are not those of points", "why not: ValueError"),
    ("since an end of theirs is a point that", "since an end of theirs is a point that"),
)  # fmt: skip
# The same of vtkAdaptiveHilbertInterpolation2D. At NumPy what has no value is NaN in what comes out, or what `outside`
# says.
OF_INTERPOLATIONS = (
    ("Point arrays that are no numbers", "why not: TypeError"),
    ("whose names are those of arrays that are made", "why not: arrays have no names"),
    ("There are no gradients", "why not: ValueError"),
    ("places have no value, since", "why not: NaN"),
    (" places is on the surface", "why not: NaN"),
    ("values at places on the surface are none", "why not: NaN"),
    ("without some of their natural neighbours", "why not: NaN among the values of one call, whose caller has them"),
)
ONLY_COMPILED = ("keep none (see FillRule), or",)  # where a triangulation was borrowed: its triangles are not known


def said_in_python(name, functions):
    """What each `yield` of a module says: all its literals; and each `return` of a function that makes one text."""
    tree = ast.parse((literals.PYTHON / name).read_text(encoding="utf-8"))
    for function in ast.walk(tree):
        if not isinstance(function, ast.FunctionDef) or not re.match(functions, function.name):
            continue
        for node in ast.walk(function):
            isText = isinstance(node, ast.Return) and function.name == "_of_no_triangle"
            if isText or (isinstance(node, ast.Yield) and not isinstance(node.value, ast.Call)):
                yield "#".join(piece for _, piece in literals.pieces_of(node))


def said_in_cxx(name):
    text = literals.CXX_COMMENT.sub("", (literals.ROOT / "Filters" / name).read_text(encoding="utf-8"))
    for statement in re.findall(r"vtkWarningWithObjectMacro\((.*?)\);\n", text, re.S):
        yield "#".join(literals.CXX_LITERAL.findall(literals.CXX_JOINT.sub("", statement)))


class DoorsTest(unittest.TestCase):
    maxDiff = None

    def check(self, said, pieces):
        """Each text has exactly one of the pieces, and each piece is in exactly one text."""
        found = {piece: [text for text in said if any(one in text for one in piece.split("|"))] for piece in pieces}
        for piece, texts in found.items():
            self.assertEqual(len(texts), 1, (piece, texts))
        known = [text for texts in found.values() for text in texts]
        self.assertEqual([text for text in said if text not in known], [])
        self.assertEqual(len(known), len(set(known)))

    def test_of_triangulations(self):
        of_class = [row[0] for row in OF_TRIANGULATIONS]
        of_numpy = [row[1] for row in OF_TRIANGULATIONS if not row[1].startswith("why not: ")]
        self.check(list(said_in_cxx("Execution/vtkAHDMessages.cxx")), of_class + list(ONLY_COMPILED))
        self.check(list(said_in_python("_vtk/messages.py", "_of_")), of_class)
        self.check(list(said_in_python("_warnings.py", "_of_")), of_numpy)

    def test_of_interpolations(self):
        of_class = [row[0] for row in OF_INTERPOLATIONS]
        self.check(list(said_in_cxx("Sampling/vtkAHDSampleMessages.cxx")), of_class)
        self.check(list(said_in_python("_vtk/raster_messages.py", "of_(arrays|places)")), of_class)


if __name__ == "__main__":
    unittest.main()
