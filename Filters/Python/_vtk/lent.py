# SPDX-License-Identifier: BSD-3-Clause
"""The triangulation that a surface was written from, for who interpolates on it:
Filters/Execution/vtkAHDLentTriangulation.h."""

import weakref

from . import cache
from .arrays import held_places, held_points, must_be_converted
from .execution import let_go
from .raster import box_of
from .sampling import SampledSurface, skipped_of

_lent = weakref.WeakValueDictionary()  # by the corners of the surface


def _key(corners):
    """No two arrays that ever were have the same, nor one before and after a change that VTK knows of."""
    return corners.GetAddressAsString("vtkObject"), corners.GetMTime()


class _Shown:
    """Of a surface what is looked at again before its triangulation is lent."""

    triangles = added = 0

    def __init__(self, points, corners):
        self._arrays = [points, corners]

    def arrays(self):
        return self._arrays


class LentTriangulation:
    """A job with its result, and the input that it reads, which is held. It is lent to one at a time, and only until
    the filter that made it takes it back, or is gone."""

    def __init__(self, job, given, surface):
        """`given`: the points and marks of the run; `surface`: what was written of it."""
        job.set_progress(None)  # which refers to the filter, and VTK before 9.7 frees no filter in a cycle
        self.given, self._here, self._is_closed = given, [job], False
        self._corners = _key(surface.GetPolys().GetConnectivityArray())
        self._state = self._state_of(surface.GetPoints().GetData(), surface.GetPolys().GetConnectivityArray())
        if self._state is not None:
            _lent[self._corners] = self

    def _state_of(self, points, corners):
        """Of a surface and of what the job reads: fingerprints, and where the latter lies; None if that cannot be
        known."""
        now = cache.Inputs(self.given, None, _Shown(points, corners))
        prints = now.fingerprints()
        return prints and (prints, now.places()[:2])

    def fits(self, points, corners):
        """Are all what and where they were?"""
        return self._state == self._state_of(points, corners)

    def reads(self, given):
        """Is all that it reads of this input, and where it was?"""
        now = cache.Inputs(given, None)
        return now.are_the_same_arrays(cache.Inputs(self.given, None)) and (
            self._state is not None and now.places() == self._state[1])

    def take(self):
        """The job; None if another has it."""
        try:
            return self._here.pop()  # of several threads one succeeds
        except IndexError:
            return None

    def give_back(self, job):
        job.set_progress(None)
        if not self._is_closed:
            self._here.append(job)

    def close(self):
        """Lends it no more. The job, without input and result; None if another has it."""
        self._is_closed = True
        job = self.take()
        if job is not None:
            let_go(job)
        return job


def lent_of(execution, surface, most):
    """What an execution lends, with its job: None if that would be of no use, or more than `most` KiB."""
    given = execution.given
    is_fit = surface.GetNumberOfPolys() > 0 and not execution.copies_kept and not (
        execution.found.is_projected or must_be_converted(given.GetPoints()))
    fits = (execution.bytes_before + execution.bytes_converted() + execution.job.count("kept_estimate")) // 1024 < most
    return LentTriangulation(execution.job, held_places(execution.backend, given), surface) if is_fit and fits else None


def borrow(asked):
    """A LentSurface for the surface that is `asked` for, an execution; None if its triangulation is not there, or
    points or triangles are others now."""
    corners = asked.surface.arrays()[0]
    lent = None if asked.found.is_projected else _lent.get(_key(corners))
    job = lent and lent.take()
    if job is None:
        return None
    if asked.given.GetPoints() is None or not lent.fits(asked.given.GetPoints().GetData(), corners):
        lent.give_back(job)
        return None
    return LentSurface(asked, job, lent)


class LentSurface(SampledSurface):
    """In place of one that is made, for one execution."""

    is_lent, known = True, None

    def __init__(self, asked, job, lender):
        self.backend, self.job, self.lender = asked.backend, job, lender
        self.given, self.source, self.surface = held_points(asked.backend, asked.given), None, asked.surface
        self.execution, self.transform = asked, None

    def estimate(self, bytes_behind):
        """Bytes, as if it were made anew of the surface and so many more were taken."""
        self.execution.announce_all()
        self.execution.announce(bytes_behind)
        return self.execution.job.estimate()

    def point_data(self):
        """The surface has all points."""
        return self.given.GetPointData()

    def bounds(self):
        return box_of(self.plane_points(), skipped_of(self.lender.given, self.job.count("points")))

    def give_back(self):
        job, self.job = self.job, None
        if job is not None:
            self.lender.give_back(job)
