# SPDX-License-Identifier: BSD-3-Clause
"""Blocks of a composite data set as one: Filters/Input/vtkAHDBlocks.h and Filters/Execution/vtkAHDMergedBlocks.h."""

import numpy

from .. import _library as engine
from . import messages
from .arrays import (GHOSTS, BadCells, cells_of, ghost_marks, held, held_points, ids_of, new_array, put_tuples,
                     remove_arrays_of_one_name)

MOST_POINTS = 2**28 - 2


class Blocks:
    """The blocks that have points, in the order of the data set's iterator. `with_cells`: of a source, whose blocks are
    vtkPolyData. Others are counted."""

    def __init__(self, backend, given, with_cells=False, ids_stay=False):
        self.backend, self.with_cells, self.ids_stay = backend, with_cells, ids_stay
        self.blocks, self.others, self.first_other, self.unfit_marks = [], 0, None, 0
        kind = backend.vtkPolyData if with_cells else backend.vtkPointSet
        iterator = given.NewIterator()
        iterator.InitTraversal()
        while not iterator.IsDoneWithTraversal():
            self._take(iterator.GetCurrentDataObject(), kind)
            iterator.GoToNextItem()
        self.count = sum(block.GetNumberOfPoints() for block in self.blocks)

    def _take(self, block, kind):
        if isinstance(block, kind):
            if block.GetNumberOfPoints() or (self.with_cells and block.GetNumberOfCells()):
                self.blocks.append(block)
                self.unfit_marks += ghost_marks(block)[1]
        elif block is not None:
            self.first_other = self.first_other or block.GetClassName()
            self.others += 1

    def estimate_bytes(self):
        kibibytes = 1 + sum(
            1 + (block if self.with_cells else block.GetPointData()).GetActualMemorySize() for block in self.blocks)
        return kibibytes * 1024 + self.count * 25

    def merge(self):
        """One vtkPolyData of all. MemoryError."""
        vtk = self.backend
        merged, points = vtk.vtkPolyData(), vtk.vtkPoints()
        floats = all(block.GetNumberOfPoints() == 0 or block.GetPoints().GetDataType() == vtk.VTK_FLOAT
                     for block in self.blocks)
        places, _ = new_array(vtk.vtkFloatArray if floats else vtk.vtkDoubleArray, self.count, 3)
        begin = 0
        for block in self.blocks:
            count = block.GetNumberOfPoints()
            if count:
                put_tuples(places, begin, count, block.GetPoints().GetData())
            begin += count
        points.SetData(places)
        merged.SetPoints(points)
        self._merge_point_data(merged.GetPointData())
        if self.with_cells:
            self._merge_cells(merged)
        return merged

    def _merge_cells(self, merged):
        for kind, what in (("Lines", "lines"), ("Polys", "polygons")):
            offsets, ids, begin, end = [numpy.zeros(1, numpy.int64)], [numpy.empty(0, numpy.int64)], 0, 0
            for block in self.blocks:
                own, of_cells = ids_of(self.backend, getattr(block, "Get" + kind)(), what + " of a block of the source")
                if own is None:
                    own, of_cells = numpy.zeros(1 + self._count(block, kind), numpy.int64), ids[0]
                offsets.append(own[1:].astype(numpy.int64) + (end - int(own[0])))
                end += int(own[-1] - own[0])
                ids.append(of_cells[own[0]:own[-1]].astype(numpy.int64) + begin)
                begin += 0 if self.ids_stay else block.GetNumberOfPoints()
            getattr(merged, "Set" + kind)(cells_of(self.backend, numpy.concatenate(offsets), numpy.concatenate(ids)))
        for kind in ("Verts", "Strips"):  # which are counted, and no more
            count = sum(self._count(block, kind) for block in self.blocks)
            getattr(merged, "Set" + kind)(cells_of(self.backend, numpy.zeros(1 + count), ()))

    @staticmethod
    def _count(block, kind):
        """How many cells; an array without a single offset gives -1."""
        return max(0, getattr(block, "Get" + kind)().GetNumberOfCells())

    def _merge_point_data(self, all_):
        """The arrays that all blocks have, by name, type and number of components, with a value for each point: in the
        order of their names, as VTK has them (vtkDataSetAttributes::FieldList). Those without a name one by one."""
        marked = any(ghost_marks(block)[0] is not None for block in self.blocks)
        data = [self._usable(block, marked) for block in self.blocks]
        by_name = [self._by_name(part) for part in data]
        for name in sorted(set.intersection(*map(set, by_name))) if data else ():
            for members in zip(*(arrays[name] for arrays in by_name)):
                if len({(member.GetDataType(), member.GetNumberOfComponents()) for member in members}) == 1:
                    index = all_.AddArray(self._appended(members))
                    for kind in range(all_.NUM_ATTRIBUTES):
                        if all(part.GetAbstractAttribute(kind) is member for part, member in zip(data, members)):
                            all_.SetActiveAttribute(index, kind)

    @staticmethod
    def _by_name(data):
        found = {}
        for i in range(data.GetNumberOfArrays()):
            found.setdefault(data.GetArrayName(i) or "", []).append(data.GetAbstractArray(i))
        return found

    def _appended(self, members):
        """One array of these, which are alike, with their properties."""
        first = members[0]
        made = self.backend.vtkAbstractArray.CreateArray(first.GetDataType())
        made.SetName(first.GetName())
        made.SetNumberOfComponents(first.GetNumberOfComponents())
        for c in range(first.GetNumberOfComponents()):
            name = next(filter(None, (member.GetComponentName(c) for member in members)), None)
            if name:
                made.SetComponentName(c, name)
        if first.HasInformation():
            made.CopyInformation(first.GetInformation(), 1)
        if made.IsA("vtkDataArray"):
            made.SetLookupTable(next(filter(None, (member.GetLookupTable() for member in members)), None))
        made.SetNumberOfTuples(self.count)
        begin = 0
        for member in members:
            put_tuples(made, begin, member.GetNumberOfTuples(), member)
            begin += member.GetNumberOfTuples()
        return made

    def _usable(self, block, marked):
        """The block's arrays that have a value for each point; ghost marks of its own, or those of no ghost."""
        usable = self.backend.vtkPointData()
        usable.ShallowCopy(block.GetPointData())
        remove_arrays_of_one_name(usable)
        for i in range(usable.GetNumberOfArrays() - 1, -1, -1):
            if usable.GetAbstractArray(i).GetNumberOfTuples() != block.GetNumberOfPoints():
                usable.RemoveArray(i)
        has_marks = ghost_marks(block)[0] is not None
        if not has_marks:
            usable.RemoveArray(GHOSTS)
        if marked and not has_marks:
            none, write = new_array(self.backend.vtkUnsignedCharArray, block.GetNumberOfPoints(), 1, GHOSTS)
            write[:] = 0
            usable.AddArray(none)
        return usable


class Merged:
    """Input and source of an execution, merged where they are composite, else held whatever observers do to the data
    sets; `input` is None where merging failed, which has been said, or where there are no points. `bytes`: that merging
    took."""

    def __init__(self, backend, speaker, values, given, source):
        self.backend, self.speaker, self.limit = backend, speaker, values["MemoryLimit"]
        self.given, self.given_source, self.bytes = given, source, 0
        self.input = held_points(backend, given) if isinstance(given, backend.vtkPointSet) else None
        self.source = held(backend, source) if isinstance(source, backend.vtkPolyData) else None
        if isinstance(given, backend.vtkCompositeDataSet):
            merged = self._merge(Blocks(backend, given))
            self.input = merged and held_points(backend, merged)
        if isinstance(source, backend.vtkCompositeDataSet) and self.input is not None:
            self.source = held(backend, self._merge(Blocks(backend, source, True, values["SourceMode"] == 0)))
            if self.source is None:
                self.input = None  # a surface without its constraints was not requested

    def _merge(self, blocks):
        if blocks.count > MOST_POINTS:
            self.speaker.error(messages.refusal(reason=engine.TOO_MANY_POINTS, points=blocks.count))
            return None
        self.bytes += blocks.estimate_bytes()
        needed = self.bytes // 1024
        limit = self.limit or engine.available_memory() // 1024
        try:
            if needed <= limit:
                return blocks.merge()
        except BadCells as bad:
            self.speaker.error(str(bad))
            return None
        except MemoryError:
            pass
        self.speaker.error(messages.refusal(
            reason=engine.MEMORY_LIMIT, doing="merging", points=blocks.count, memory_estimate=needed,
            memory_allowed=limit, memory_limit=self.limit))
        return None

    def hand_on_points(self, surface):
        """Gives a surface that has no points of its own those of the input."""
        if surface.GetPoints() is None:
            self.input.give_points(surface)

    def warn(self):
        """Of blocks that are left out."""
        vtk, facts = self.backend, {}
        if isinstance(self.given, vtk.vtkCompositeDataSet):
            blocks = Blocks(vtk, self.given)
            facts.update(other_blocks=blocks.others, first_other=blocks.first_other or "",
                         unfit_marks=blocks.unfit_marks)
        elif not isinstance(self.given, vtk.vtkPointSet):
            # A block of a composite data set: their types are not looked at by the pipeline.
            facts.update(without_points=self.given.GetClassName() if self.given else "missing block")
        if isinstance(self.given_source, vtk.vtkCompositeDataSet):
            blocks = Blocks(vtk, self.given_source, True)
            facts.update(other_sources=blocks.others, first_other_source=blocks.first_other or "")
        for text in messages.said(engine.SAY_BLOCKS, facts):
            self.speaker.warn(text)
