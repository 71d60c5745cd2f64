# SPDX-License-Identifier: BSD-3-Clause
"""DistributePoints with MergeBlocks off: block k of all ranks is triangulated over all, for each k.

    mpiexec -n RANKS pvbatch --sym RanksBlocks.py
"""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet,
    vtkMultiBlockDataSet,
    vtkMultiPieceDataSet,
    vtkPartitionedDataSet,
    vtkPartitionedDataSetCollection,
    vtkTable,
)

from RanksCompare import (
    RANK, RANKS, WANTED, Said, appended, attempt, check, compare, finish, make_array, make_filter, make_input,
    on_all_ranks, read, run,
)
from rankcases import Piece, pieces, uniform, with_one_source

STATUS = {"GeneratePointStatus": True}


class OfBlock:
    """Returns the filter's counts after this block, which are in the field data."""

    def __init__(self, out):
        self.GetOutput = lambda: out

    def __getattr__(self, name):
        array = self.GetOutput().GetFieldData().GetArray(name[3:])
        return lambda: int(array.GetValue(0)) if array else 0


def children_of(data):
    if isinstance(data, vtkMultiBlockDataSet):
        return [data.GetBlock(k) for k in range(data.GetNumberOfBlocks())]
    if isinstance(data, vtkPartitionedDataSetCollection):
        return [data.GetPartitionedDataSet(k) for k in range(data.GetNumberOfPartitionedDataSets())]
    return [data.GetPartitionAsDataObject(k) for k in range(data.GetNumberOfPartitions())]


def leaves(data):
    """Of a composite data set, with null for those that are missing, in order."""
    if not isinstance(data, vtkCompositeDataSet):
        return [data]
    return [leaf for child in children_of(data) for leaf in leaves(child)]


def classes(data):
    """Of all nodes and leaves."""
    if not isinstance(data, vtkCompositeDataSet):
        return data and data.GetClassName()
    return data.GetClassName(), [classes(child) for child in children_of(data)]


def structure(data):
    """The classes of the nodes and what blocks are called."""
    if isinstance(data, vtkMultiBlockDataSet):
        names = [data.GetMetaData(k).Get(vtkCompositeDataSet.NAME()) if data.HasMetaData(k) else None
                 for k in range(data.GetNumberOfBlocks())]
        return ("multi", names, [structure(data.GetBlock(k)) for k in range(data.GetNumberOfBlocks())])
    if isinstance(data, vtkPartitionedDataSetCollection):
        return ("collection", [structure(data.GetPartitionedDataSet(k))
                               for k in range(data.GetNumberOfPartitionedDataSets())])
    return "parts" if isinstance(data, vtkPartitionedDataSet) else "block"


def make_multi(blocks):
    """Of pieces, None for a missing one, and lists of these."""
    data = vtkMultiBlockDataSet()
    data.SetNumberOfBlocks(len(blocks))
    for k, block in enumerate(blocks):
        if isinstance(block, list):
            data.SetBlock(k, make_multi(block))
        elif block is not None:
            data.SetBlock(k, make_input(block))
            data.GetBlock(k).GetFieldData().AddArray(make_array("Number", "byte", [k]))
        data.GetMetaData(k).Set(vtkCompositeDataSet.NAME(), "block %d" % k)
    return data


def make_nodes(made):
    """Of (class of the node, children), a piece, or None for a missing one."""
    if not isinstance(made, tuple):
        return made and make_input(made)
    kind, children = made
    data = kind()
    setters = {vtkMultiBlockDataSet: ("NumberOfBlocks", "Block"),
               vtkPartitionedDataSetCollection: ("NumberOfPartitionedDataSets", "PartitionedDataSet")}
    count, child = setters.get(kind, ("NumberOfPartitions", "Partition"))
    getattr(data, "Set" + count)(len(children))
    for k, one in enumerate(children):
        if one is not None:
            getattr(data, "Set" + child)(k, make_nodes(one))
    return data


def run_blocks(data, settings, port=0):
    algorithm = make_filter(data, settings, True)
    said = Said(algorithm)
    algorithm.Update()
    out = algorithm.GetOutputDataObject(port)
    every = [leaf and read(OfBlock(leaf), said) for leaf in leaves(out)]
    numbers = [leaf and leaf.GetFieldData().GetArray("Number") for leaf in leaves(out)]
    return {"structure": structure(out), "blocks": every, "errors": said.errors, "warnings": said.warnings,
            "numbers": [array and int(array.GetValue(0)) for array in numbers],
            "triangulations": algorithm.GetNumberOfTriangulations()}


def three():
    """Of each rank three blocks: the second is missing on rank 1, the third is empty on the last rank."""
    first, second, third = (pieces(uniform(count, count), RANKS) for count in (400, 300, 200))
    lacking = [piece if rank != 1 else None for rank, piece in enumerate(second)]
    third[-1] = Piece([])
    return first, lacking, third


def compare_block(found, k, made, settings):
    made = [piece or Piece([]) for piece in made]
    parts = [dict(rank["blocks"][k], warnings=[]) for rank in found]
    compare(parts, run(appended(made, settings), settings, distribute=False))


def try_multi(settings):
    first, second, third = three()
    own = [first[RANK], [second[RANK], None, third[RANK]]]
    found = on_all_ranks("multi", lambda: run_blocks(make_multi(own), settings))
    if RANK:
        return
    # what one rank alone makes of the input of rank 0
    alone = make_filter(make_multi(own), settings, False)
    alone.Update()
    expected = structure(alone.GetOutputDataObject(0))
    for rank, part in enumerate(found):
        check(not part["errors"] and not part["warnings"], "rank %d says %r" % (rank, part))
        check(part["structure"] == expected, "rank %d: %r, not %r" % (rank, part["structure"], expected))
        check(part["triangulations"] == 3, "%d blocks were triangulated" % part["triangulations"])
        check(part["blocks"][2] is None, "a block that no rank has")
        numbers = [0, None if rank == 1 else 0, None, 2]
        check(part["numbers"] == numbers, "field data: %r, not %r" % (part["numbers"], numbers))
    for k, made in ((0, first), (1, second), (3, third)):
        compare_block(found, k, made, settings)


def try_gathered():
    """Where one rank does everything, it does so for each block; a diagram has blocks, too."""
    first, second, _ = three()
    settings = {"GenerateVoronoi": True}
    own = make_multi([first[RANK], second[RANK]])
    found = on_all_ranks("gathered", lambda: (run_blocks(own, settings), run_blocks(own, settings, 2)))
    if RANK:
        return
    compare_block([surface for surface, _ in found], 0, first, settings)
    compare_block([surface for surface, _ in found], 1, second, settings)
    check(len(found[0][0]["warnings"]) == 1, "said: %r" % found[0][0]["warnings"])
    for rank, (_, diagram) in enumerate(found):
        counts = [len(block["places"]) > 0 for block in diagram["blocks"]]
        check(counts == [rank == 0] * 2, "rank %d has Voronoi cells: %r" % (rank, counts))


def try_partitions(nothing):
    """Ranks have as many partitions as they have: one more each, but for the last, which has `nothing`."""
    made = [pieces(uniform(200 + k, 7 + k), RANKS) for k in range(RANKS - 1)]
    data = nothing
    if RANK < RANKS - 1:
        own = [made[k][RANK] for k in range(RANK + 1)]
        data = make_nodes((vtkPartitionedDataSetCollection, [(vtkPartitionedDataSet, own)]))
    found = on_all_ranks("partitions", lambda: run_blocks(data, STATUS))
    if RANK:
        return
    said = ["has no points" in text for part in found for text in part["warnings"]]
    check(said == [True] * (nothing is not None), "said: %r" % [part["warnings"] for part in found])
    for part in found:
        check(part["structure"] == ("collection", ["parts"]), "structure: %r" % (part["structure"],))
        check(len(part["blocks"]) == RANKS - 1, "%d partitions" % len(part["blocks"]))
    for k in range(RANKS - 1):
        had = [piece if k <= rank < RANKS - 1 else Piece([]) for rank, piece in enumerate(made[k])]
        compare_block(found, k, had, STATUS)


def try_fewer():
    """A rank without a block gets those of the others, also one that none has."""
    first, *_ = three()
    given = make_multi([first[RANK], [None], None]) if RANK < RANKS - 1 else vtkMultiBlockDataSet()
    found = on_all_ranks("fewer", lambda: run_blocks(given, STATUS))
    if RANK:
        return
    for rank, part in enumerate(found):
        kinds = part["structure"][2]
        check([kinds[0], kinds[1][0], len(kinds[1][2]), kinds[2:]] == ["block", "multi", 1, ["block"]],
              "rank %d: %r" % (rank, kinds))
    compare_block(found, 0, first[:-1] + [Piece([])], STATUS)


def try_kinds(make, lacking):
    """The last rank has `lacking`, the others blocks of each kind, the last of which no rank has: all put out the
    nodes of these, whatever their own input has."""
    first, _, third = three()
    first, third = first[:-1] + [Piece([])], third[:-1] + [Piece([])]
    own = make(first[RANK], third[RANK])

    def work():
        given = lacking and lacking() if RANK == RANKS - 1 else make_nodes(own)
        algorithm = make_filter(given, STATUS, True)
        said = Said(algorithm)
        algorithm.Update()
        out = algorithm.GetOutputDataObject(0)
        return {"classes": classes(out), "blocks": [leaf and read(OfBlock(leaf), said) for leaf in leaves(out)]}

    found = on_all_ranks("kinds", work)
    if RANK:
        return
    expected = classes(make_nodes(own))
    for rank, part in enumerate(found):
        check(part["classes"] == expected, "rank %d: %r, not %r" % (rank, part["classes"], expected))
        there = [k for k, block in enumerate(part["blocks"]) if block]
    for k, made in zip(there, (first, third), strict=True):
        compare_block(found, k, made, STATUS)


def try_source():
    """The same source is for each block."""
    first, second, _ = three()
    settings = dict(STATUS, SourceMode=1)
    made = with_one_source(first)

    def work():
        algorithm = make_filter(made[RANK], settings, True)
        algorithm.SetInputDataObject(0, make_multi([first[RANK], second[RANK]]))
        said = Said(algorithm)
        algorithm.Update()
        return {"blocks": [read(OfBlock(leaf), said) for leaf in leaves(algorithm.GetOutputDataObject(0))]}

    found = on_all_ranks("source", work)
    if found:
        compare_block(found, 0, made, settings)
        again = [piece or Piece([]) for piece in second]
        compare_block(found, 1, with_one_source(again), settings)


def try_different(data, rank):
    """One error on all, and no output."""
    found = on_all_ranks("different", lambda: run_blocks(data, {}))
    for part in found or ():
        check(len(part["errors"]) == 1 and part["errors"][0].startswith("The input of rank %d does not" % rank),
              "said: %r" % part["errors"])
        check(not any(block and block["names"] for block in part["blocks"]), "something is put out")


def try_changes():
    """Outputs have blocks where inputs have, and only then."""
    first, second, _ = three()
    own = make_multi([first[RANK], second[RANK]])

    def work():
        algorithm = make_filter(own, {}, True)
        kinds = []
        for change in (lambda: None, algorithm.MergeBlocksOn, algorithm.MergeBlocksOff,
                       lambda: algorithm.SetInputDataObject(0, make_input(first[RANK])),
                       lambda: algorithm.SetInputDataObject(0, own), algorithm.DistributePointsOff):
            change()
            algorithm.UpdateDataObject()
            kinds.append(algorithm.GetOutputDataObject(0).GetClassName())
            algorithm.Update()
            out = algorithm.GetOutputDataObject(0)
            kinds.append(out.GetClassName())
            check(all(leaf is None or leaf.GetNumberOfPolys() > 0 for leaf in leaves(out)), "no triangles")
        return kinds

    for kinds in on_all_ranks("changes", work) or ():
        blocks, one = "vtkMultiBlockDataSet", "vtkPolyData"
        check(kinds[1::2] == [blocks, one, blocks, one, blocks, blocks], repr(kinds))
        check(kinds[::2] == kinds[1::2], "outputs become others in the execution: %r" % kinds)


def try_nothing():
    found = run_blocks(make_multi([None, None]), {})
    check(found["triangulations"] == 0 and found["blocks"] == [None, None], "something was triangulated")


last = RANK == RANKS - 1
some = pieces(uniform(50), 4)
multi, parts, collection, in_pieces = (
    vtkMultiBlockDataSet, vtkPartitionedDataSet, vtkPartitionedDataSetCollection, vtkMultiPieceDataSet)
ways = {
    "multi-block": (lambda a, b: (multi, [a, b, None]), multi),
    "pieces": (lambda a, b: (in_pieces, [a, b, None]), in_pieces),
    "pieces of blocks": (lambda a, b: (multi, [(in_pieces, [a, None]), (multi, [(in_pieces, [b])]), None]), multi),
    "partitions": (lambda a, b: (parts, [a, b, None]), parts),
    "collection": (lambda a, b: (collection, [(parts, [a, None]), (parts, [b]), (parts, [])]), collection),
}
tries = {
    "multi-block": (try_multi, STATUS),
    "multi-block, one rank does it all": (try_gathered,),
    "partitions": (try_partitions, None),
    "partitions and a table": (try_partitions, vtkTable()),
    "fewer": (try_fewer,),
    **{"kinds: %s%s" % (name, ", no input on one" if lacking is None else ""): (try_kinds, make, lacking)
       for name, (make, empty) in ways.items() for lacking in (empty, None)},
    "source": (try_source,),
    "different counts": (try_different, make_multi(some[:3] if last else some[:2]), RANKS - 1),
    "different depths": (try_different, make_multi([[some[0]]] if last else [some[0]]), RANKS - 1),
    "no blocks on one": (try_different, make_input(some[0]) if RANK == 1 else make_multi(some), 1),
    "changes": (try_changes,),
    "no block at all": (try_nothing,),
}
for name, work in tries.items():
    if WANTED in name:
        attempt(name, *work)
finish()
