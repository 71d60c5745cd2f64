# SPDX-License-Identifier: BSD-3-Clause
"""The filter's messages, worded by the engine (Filters/Engine/Job/Catalogue.h), through VTK's channels: events, or its
output window if no observer handles these."""

import sys

from .. import _library as engine


def _say(backend, algorithm, event, word, text):
    if not backend.vtkObject.GetGlobalWarningDisplay():
        return
    address = algorithm.GetAddressAsString("vtkObject").split("=")[-1]
    caller = sys._getframe(2)
    full = "%s: In %s, line %d\n%s (%s): %s\n\n" % (
        word, caller.f_code.co_filename, caller.f_lineno, algorithm.GetClassName(), address, text)
    if algorithm.HasObserver(event):
        algorithm.InvokeEvent(event, full)
        return
    window = backend.vtkOutputWindow.GetInstance()
    (window.DisplayErrorText if word == "ERROR" else window.DisplayWarningText)(full)


class Speaker:
    """Reports warnings and errors of one filter."""

    def __init__(self, backend, algorithm):
        self.backend, self.algorithm = backend, algorithm

    def warn(self, text):
        _say(self.backend, self.algorithm, "WarningEvent", "Warning", text)

    def error(self, text):
        _say(self.backend, self.algorithm, "ErrorEvent", "ERROR", text)


class Silence:
    """A Speaker without an audience."""

    def warn(self, text):
        pass

    error = warn


def said(topic, facts, job=None):
    """The texts, in order, in the words of the class."""
    return list(engine.say(topic, engine.WORDS_OF_CLASS, facts, job).values())


def refusal(**facts):
    """The text of a refusal; None without a reason. Memory is in KiB."""
    return next(iter(said(engine.SAY_REFUSAL, dict(facts, is_in_kib=1))), None)


def error_text(status, job, more):
    """The error of an execution; None if it was aborted. `more`: the text for faults that are not in the catalogue."""
    if status == engine.CANCELLED:
        return None
    if status == engine.BAD_ARRAY:
        return not_computed(more.replace('"voronoi_polygon"', "VoronoiPolygon"))
    if status > engine.TOO_MANY_CROSSINGS and status != engine.BAD_VALUE:  # that of settings that exclude each other
        return "%s. The output is empty." % more
    return said(engine.SAY_REFUSAL, {"reason": status}, job)[0]


def not_computed(why):
    return why if why.endswith(" computed.") else "%s. Nothing was computed." % why.rstrip(".")


def warnings(job, values, found, limit_is_told):
    """The texts, in order. `found`: facts from outside the job, and adds_bounding."""
    facts = dict(vars(found), bounding_is_missing=values["BoundingTriangulation"] and not found.adds_bounding,
                 limit_is_told=limit_is_told)
    return said(engine.SAY_TRIANGULATION, facts, job)
