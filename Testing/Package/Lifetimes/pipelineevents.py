# SPDX-License-Identifier: BSD-3-Clause
"""The steps of the world of pipelines that happen while a filter works: aborts, observers, Ctrl-C."""

import contextlib
import signal
import threading
import time

from vtkmodules.vtkCommonCore import vtkPoints
from worlds import Rubbish, step


class WhileItWorks:
    """Mixed into Pipelines."""

    def _observe(self, filter, at, act):
        rest = [at]

        def hear(*_):
            rest[0] -= 1
            if rest[0] == 0:
                act()

        return filter.AddObserver("ProgressEvent", hear)

    def _one_filter(self, rng):
        filter = rng.choice((self.surface, self.raster))
        return self.mesh if self.hasMesh and rng.random() < 0.3 else filter

    @step(3)
    def abort(self, rng):
        filter = self._one_filter(rng)
        tag = self._observe(filter, rng.randrange(1, 5), lambda: filter.SetAbortExecute(1))
        filter.Modified()
        filter.Update()
        filter.RemoveObserver(tag)
        filter.SetAbortExecute(0)
        filter.Modified()
        self.isCurrent = False

    @step(2)
    def change_in_observer(self, rng):
        """The filter's data are replaced or deleted; the next execution is correct. Memory that is read, such as that
        of an array, must not be changed meanwhile."""
        how = rng.randrange(5)

        def act():
            if how == 0:
                self.transform = None
                self.surface.SetTransform(None)
                self.raster.GetTriangulation().SetTransform(None)
                self.mesh.GetTriangulation().SetTransform(None)
            elif how == 1:
                self.data.Initialize()
            elif how == 2 and self.source is not None:
                self.source.Initialize()
            elif how <= 3:
                self.surface.SetSourceData(None)
                self.raster.SetSourceData(None)
                self.mesh.SetSourceData(None)
            else:
                self.data.SetPoints(vtkPoints())
            self.held.append(Rubbish.fill(rng))

        filter = self._one_filter(rng)
        tag = self._observe(filter, rng.randrange(1, 6), act)
        filter.Modified()
        filter.Update()
        filter.RemoveObserver(tag)
        self.settings["ProjectionPlaneMode"] = 0 if self.transform is None else 1
        self.new_input(rng)
        self.new_source(rng)

    @step(1)
    def interrupt(self, rng):
        """Ctrl-C while a filter works. Not while VTK calls Python code: VTK ends the process then, or loses the
        exception."""
        if self.route == "stream":
            return
        filter, asked, tags = self._one_filter(rng), threading.Event(), []

        def act():
            filter.RemoveObserver(tags[0])
            asked.set()

        def press():
            if asked.wait(5):
                time.sleep(0.001)  # until the observer has returned
                signal.raise_signal(signal.SIGINT)

        tags.append(self._observe(filter, rng.randrange(1, 4), act))
        thread = threading.Thread(target=press)
        with contextlib.suppress(KeyboardInterrupt):
            thread.start()
            filter.Modified()
            filter.Update()
            asked.set()
            thread.join()
            time.sleep(0.01)
        filter.RemoveObserver(tags[0])
        thread.join()
        self.isCurrent = False
