# SPDX-License-Identifier: BSD-3-Clause
"""Panels that ParaView draws, flat and from above, and figures of several panels with their titles."""

import os
import tempfile

import matplotlib.font_manager
import numpy
from paraview import simple
from PIL import Image, ImageDraw, ImageFont

import meshes
from palette import BLUE, INK, PALE, PAPER, RAMP, rgb

FINE = 2  # panels are drawn so many times larger, and then made smaller: smooth lines
TEXT = 24  # height of the letters in pixels of the figure, which is shown at half its size
GAP = 28  # between panels, and around them


def font(size=TEXT, bold=False):
    weight = "bold" if bold else "normal"
    path = matplotlib.font_manager.findfont(
        matplotlib.font_manager.FontProperties(family="DejaVu Sans", weight=weight)
    )
    return ImageFont.truetype(path, size)


class Panel:
    """One drawing. Sizes of lines and points are pixels of the figure; what is added later lies on top."""

    view = None  # one for all panels, and its actors are used again: making them takes longer than drawing
    actors = {False: [], True: []}  # (source, display), without and with values
    scale = 1.0  # of all panels, for a quick look

    def __init__(self, low, high, width, margin=0.03):
        low, high = numpy.asarray(low, float), numpy.asarray(high, float)
        pad = margin * (high - low).max()
        self.low, self.high = low - pad, high + pad
        span = self.high - self.low
        width = round(width * Panel.scale)
        self.size = (width, round(width * span[1] / span[0]))
        self.layers = []

    # --- what is drawn ---

    def add(self, data, colour, **look):
        self.layers.append((data, dict(look, AmbientColor=rgb(colour), DiffuseColor=rgb(colour))))

    def faces(self, xy, faces, colour):
        """Filled polygons: ids, f × corners."""
        if len(faces):
            self.add(meshes.polydata(flat(xy), faces=faces), colour, Representation="Surface")

    def mesh(self, xy, faces, colour=PALE, width=1.5):
        """The edges of polygons."""
        if len(faces):
            data = meshes.polydata(flat(xy), faces=faces)
            self.add(data, colour, Representation="Wireframe", LineWidth=width * FINE)

    def lines(self, xy, lines, colour, width=2.0):
        if len(lines):
            data = meshes.polydata(flat(xy), lines=lines)
            self.add(data, colour, Representation="Wireframe", LineWidth=width * FINE)

    def boxes(self, boxes, colour=PALE, width=1.5):
        self.mesh(boxes.reshape(-1, 2), numpy.arange(4 * len(boxes)).reshape(-1, 4), colour, width)

    def way(self, xy, colour=BLUE, width=3.0):
        """A polyline with round corners."""
        self.lines(xy, [range(len(xy))], colour, width)
        if width > 2.0:
            self.points(xy, colour, width)

    def points(self, xy, colour=INK, size=4.0, values=None):
        """Round dots of this diameter; by values from 0 to 1, if given, in the colours of the ramp."""
        if len(xy):
            data = meshes.polydata(flat(xy), vertices=True, values=values)
            dots = {"Representation": "Points", "PointSize": size * FINE, "RenderPointsAsSpheres": 1}
            self.add(data, colour, **dots)

    def arrows(self, starts, ends, colour=BLUE, size=9.0):
        """Arrow heads in the middle between starts and ends; size in pixels."""
        middle, along = (starts + ends) / 2, ends - starts
        along = along / numpy.hypot(*along.T)[:, None]
        scale = size * Panel.scale * (self.high[0] - self.low[0]) / self.size[0]
        across = numpy.column_stack([-along[:, 1], along[:, 0]])
        corners = [
            middle + scale * along,
            middle + scale * (across - along),
            middle - scale * (along + across),
        ]
        faces = numpy.arange(3 * len(starts)).reshape(3, -1).T
        self.faces(numpy.vstack(corners), faces, colour)

    # --- drawing it ---

    def image(self):
        view = self.camera()
        for _, display in Panel.actors[False] + Panel.actors[True]:
            display.Visibility = 0
        used = {False: 0, True: 0}
        for height, (data, look) in enumerate(self.layers):
            kind = bool(data.GetPointData().HasArray("value"))
            self.show(view, kind, used[kind], data, look, self.lift(height))
            used[kind] += 1
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "panel.png")
            simple.SaveScreenshot(path, view, ImageResolution=[n * FINE for n in self.size])
            return Image.open(path).convert("RGB").resize(self.size, Image.LANCZOS)

    def lift(self, height):
        """How high a layer lies above the first: seen from above, that decides what covers what."""
        return 0.001 * height * float((self.high - self.low).max())

    def camera(self):
        if Panel.view is None:
            Panel.view = simple.CreateView("RenderView")
        view = Panel.view
        view.ViewSize = [n * FINE for n in self.size]
        view.OrientationAxesVisibility = 0
        view.UseColorPaletteForBackground = 0
        view.BackgroundColorMode = "Single Color"
        view.Background = rgb(PAPER)
        centre, span = (self.low + self.high) / 2, self.high - self.low
        view.CameraParallelProjection = 1
        view.CameraParallelScale = span[1] / 2
        view.CameraFocalPoint = [*centre, 0.0]
        view.CameraPosition = [*centre, 10.0 * span.max()]
        view.CameraViewUp = [0.0, 1.0, 0.0]
        return view

    def show(self, view, kind, number, data, look, height):
        """Gives the data to the actor of this kind and number, which is made if there is none."""
        actors = Panel.actors[kind]
        if number == len(actors):
            actors.append(new_actor(view, kind, data))
        source, display = actors[number]
        source.GetClientSideObject().SetOutput(data)
        source.MarkModified(source)
        source.UpdatePipeline()
        for name, value in dict(PLAIN, **look).items():
            if name in ("LineWidth", "PointSize"):
                value *= Panel.scale
            setattr(display, name, value)
        # its name since ParaView 5.13, and before
        moved = "Translation" if "Translation" in display.ListProperties() else "Position"
        setattr(display, moved, [0.0, 0.0, height])


PLAIN = {
    "Visibility": 1, "Ambient": 1.0, "Diffuse": 0.0, "Specular": 0.0, "RenderPointsAsSpheres": 0}  # fmt: skip


def new_actor(view, coloured, data):
    source = meshes.producer(data)
    display = simple.Show(source, view)
    if coloured:
        simple.ColorBy(display, ("POINTS", "value"))
        table = simple.GetColorTransferFunction("value")
        table.ColorSpace = "Lab"
        table.RGBPoints = [n for k, c in enumerate(RAMP) for n in [k / (len(RAMP) - 1)] + rgb(c)]
        display.SetScalarBarVisibility(view, False)
    return source, display


def flat(xy):
    return numpy.column_stack([xy, numpy.zeros(len(xy))])


def figure(path, panels, titles, columns=None, key=()):
    """Panels (pictures of one size) side by side with a title each, and a key below: (colour, kind, words),
    kind one of "line", "face", "dot". Writes a PNG of few colours."""
    columns = columns or len(panels)
    rows = -(-len(panels) // columns)
    width, height = (max(panel.size[axis] for panel in panels) for axis in (0, 1))
    heads = 12 + TEXT * (1 + max(title.count("\n") for title in titles)) * 13 // 10 if any(titles) else 0
    foot = 2 * TEXT if key else 0
    picture = Image.new(
        "RGB",
        (columns * (width + GAP) + GAP, rows * (height + heads + GAP // 2) + GAP + foot), PAPER)  # fmt: skip
    pen = ImageDraw.Draw(picture)
    for k, (panel, title) in enumerate(zip(panels, titles)):
        x = GAP + (k % columns) * (width + GAP)
        y = GAP // 2 + (k // columns) * (height + heads + GAP // 2)
        first, *rest = title.split("\n")
        pen.text((x + width / 2, y + TEXT * 0.6), first, INK, font(bold=True), "mm")
        for number, line in enumerate(rest):
            pen.text((x + width / 2, y + TEXT * (1.9 + 1.25 * number)), line, INK, font(TEXT - 2), "mm")
        picture.paste(panel, (x + (width - panel.width) // 2, y + heads + (height - panel.height) // 2))
    if key:
        draw_key(pen, key, picture.size)
    write(picture, path)


def draw_key(pen, key, size):
    letters = font(TEXT - 2)
    widths = [pen.textlength(words, letters) + 90 for _, _, words in key]
    x, y = (size[0] - sum(widths) + 40) / 2, size[1] - 1.4 * TEXT
    for (colour, kind, words), width in zip(key, widths):
        if kind == "line":
            pen.line((x, y, x + 40, y), colour, 5)
        elif kind == "dot":
            pen.ellipse((x + 20, y - 8, x + 36, y + 8), colour)
        else:
            pen.rectangle((x + 4, y - 11, x + 40, y + 11), colour)
        pen.text((x + 52, y), words, INK, letters, "lm")
        x += width


def write(picture, path):
    """As a PNG of 256 colours of its own: a fifth of the size, and no difference to be seen."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    few = picture.convert("RGBA").quantize(256, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
    colours = few.getpalette("RGB")
    paper = [255 if min(colours[k - k % 3 :][:3]) >= 250 else colour for k, colour in enumerate(colours)]
    few.putpalette(paper, "RGB")
    few.save(path, optimize=True)
    print("%s  %d × %d, %d KB" % (path, *picture.size, os.path.getsize(path) // 1024), flush=True)
