"""Draws scenes into pixels with VTK, off-screen; no Qt here, so that it can run in a process of its own.

VTK is used directly, not through pyvista: its four modules needed here load in a third of a second instead of two.
"""

from __future__ import annotations

import itertools
import os
import sys
import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beltgui.viewmodel.scene import Item, Mesh
from beltgui.widgets.scene_draw_colours import rgb_of
from beltgui.widgets.scene_draw_geometry import Geometry, geometry_of

BACKGROUND = "scene"
# In units of about 1/65000 of the scene's depth, negative towards the eye: half a mm for a blade.
NEARER = -150.0


@dataclass(frozen=True, eq=False)
class ViewRequest:
    """What one viewport is to show.

    Attributes:
        position: (3,) of the eye, mm, in the scene's frame.
        target: (3,) what is in the middle of the picture.
        up: (3,).
        angle_deg: Vertical opening of the camera.
        items: New content; None leaves what is there.
        extras: New content of the layer of small things that move (robot, planned motion); None leaves it.
        hover_face: Under the pointer.
    """

    position: NDArray[np.float64]
    target: NDArray[np.float64]
    up: NDArray[np.float64]
    angle_deg: float
    items: tuple[Item, ...] | None = None
    extras: tuple[Item, ...] | None = None
    hover_face: int | None = None


@dataclass(frozen=True, eq=False)
class Request:
    """One picture: one viewport, or two side by side.

    Attributes:
        width: Of the picture in pixels.
        height: Of the picture in pixels.
        ratio: Pixels of the picture for one of the screen's logical pixels.
        views: One or two.
        palette: `#rrggbb` of each role and of the background.
    """

    width: int
    height: int
    ratio: float
    views: tuple[ViewRequest, ...]
    palette: Mapping[str, str]


def split(width: int, count: int) -> list[tuple[int, int]]:
    """First pixel and end of each of `count` viewports across a width."""
    edges = [round(width * place / count) for place in range(count + 1)]
    return list(itertools.pairwise(edges))


class _Drawn:
    """An actor that is kept as long as its item keeps its name."""

    def __init__(self, renderer: Any, swapped: bool) -> None:
        from vtkmodules.vtkCommonDataModel import vtkPolyData
        from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

        self.item: Item | None = None
        self.hover: int | None = None
        self._geometry: Geometry | None = None
        self._renderer = renderer
        self._swapped = swapped
        self._data = vtkPolyData()
        self._mapper = vtkPolyDataMapper()
        self._mapper.SetInputData(self._data)
        self._mapper.SetResolveCoincidentTopologyToPolygonOffset()
        # Scanned points scatter about their faces; they and lines are drawn a little nearer to the eye than they are.
        self._mapper.SetRelativeCoincidentTopologyPointOffsetParameter(NEARER)
        self._mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0.0, NEARER)
        self._actor = vtkActor()
        self._actor.SetMapper(self._mapper)
        renderer.AddActor(self._actor)

    def show(self, item: Item, palette: Mapping[str, str], ratio: float, hover: int | None) -> None:
        self.item, self.hover = item, hover
        self._geometry = geometry_of(item, palette, hover)
        self._actor.SetVisibility(self._geometry is not None)
        if self._geometry is not None:
            self._fill(self._geometry)
            self._paint(self._geometry)
            self.size(ratio)

    def size(self, ratio: float) -> None:
        """Points and lines as thick as asked for on a screen of this density."""
        if self._geometry is not None:
            look = self._actor.GetProperty()
            look.SetPointSize(max(1.0, self._geometry.size_px * ratio))
            look.SetLineWidth(max(1.0, self._geometry.size_px * ratio))

    def _fill(self, geometry: Geometry) -> None:
        from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
        from vtkmodules.vtkCommonCore import vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkCellArray

        data = self._data
        data.Initialize()
        points = vtkPoints()
        points.SetData(numpy_to_vtk(geometry.points))
        data.SetPoints(points)
        cells = vtkCellArray()
        cells.SetData(numpy_to_vtkIdTypeArray(geometry.offsets), numpy_to_vtkIdTypeArray(geometry.cells))
        {"points": data.SetVerts, "lines": data.SetLines, "triangles": data.SetPolys}[geometry.kind](cells)
        if geometry.normals is not None:
            data.GetPointData().SetNormals(numpy_to_vtk(geometry.normals))
        of_points, of_cells = geometry.point_colours, geometry.cell_colours
        for colours, owner in ((of_points, data.GetPointData()), (of_cells, data.GetCellData())):
            if colours is not None:
                owner.SetScalars(numpy_to_vtk(np.ascontiguousarray(colours[:, ::-1] if self._swapped else colours)))
        if geometry.cell_colours is not None:
            self._mapper.SetScalarModeToUseCellData()
        else:
            self._mapper.SetScalarModeToUsePointData()
        data.Modified()

    def _paint(self, geometry: Geometry) -> None:
        look = self._actor.GetProperty()
        look.SetColor(*_parts(geometry.colour, self._swapped))
        look.SetOpacity(geometry.opacity)
        look.SetLighting(geometry.lit)
        look.SetAmbient(0.38)
        look.SetDiffuse(0.68)
        if geometry.normals is not None:
            look.SetInterpolationToPhong()
        else:
            look.SetInterpolationToFlat()
        if geometry.wireframe:
            look.SetRepresentationToWireframe()
        else:
            look.SetRepresentationToSurface()

    def remove(self) -> None:
        self._renderer.RemoveActor(self._actor)


@dataclass
class _View:
    renderer: Any
    layers: tuple[dict[str, _Drawn], dict[str, _Drawn]] = field(default_factory=lambda: ({}, {}))


class Scenery:
    """What is drawn in a render window, and with which cameras; shows one request after the other.

    Args:
        window: A `vtkRenderWindow`; it is not rendered here.
        swapped: Red and blue change places in all colours: the pixels are read in Qt's order then, without a pass
            over them.
    """

    def __init__(self, window: Any, *, swapped: bool) -> None:
        self._window = window
        self._swapped = swapped
        self._views: list[_View] = []
        self._palette: Mapping[str, str] = {}
        self._ratio = 1.0

    def show(self, request: Request) -> None:
        """Take over what is new in a request; the next rendering of the window shows it."""
        self._arrange(request)
        anew = request.palette != self._palette
        self._palette = request.palette
        if request.ratio != self._ratio:
            self._ratio = request.ratio
            for drawn in (one for view in self._views for layer in view.layers for one in layer.values()):
                drawn.size(self._ratio)
        for view, wanted in zip(self._views, request.views, strict=True):
            view.renderer.SetBackground(*_parts(request.palette[BACKGROUND], self._swapped))
            self._fill(view.layers[0], wanted.items, view.renderer, wanted.hover_face, anew)
            self._fill(view.layers[1], wanted.extras, view.renderer, None, anew)
            camera = view.renderer.GetActiveCamera()
            camera.SetPosition(*wanted.position)
            camera.SetFocalPoint(*wanted.target)
            camera.SetViewUp(*wanted.up)
            camera.SetViewAngle(wanted.angle_deg)
            view.renderer.ResetCameraClippingRange()

    def clear(self) -> None:
        """Take everything out of the window."""
        for view in self._views:
            self._window.RemoveRenderer(view.renderer)
        self._views.clear()

    def _arrange(self, request: Request) -> None:
        from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer

        while len(self._views) > len(request.views):
            self._window.RemoveRenderer(self._views.pop().renderer)
        while len(self._views) < len(request.views):
            renderer = vtkRenderer()
            for place, strength in (((-0.4, 0.5, 1.0), 0.85), ((0.9, -0.2, 0.5), 0.35)):
                light = vtkLight()  # over the person's left shoulder, and a weaker one from the right
                light.SetLightTypeToCameraLight()
                light.SetPosition(*place)
                light.SetIntensity(strength)
                renderer.AddLight(light)
            self._window.AddRenderer(renderer)
            self._views.append(_View(renderer))
        for view, (begin, end) in zip(self._views, split(request.width, len(self._views)), strict=True):
            view.renderer.SetViewport(begin / request.width, 0.0, end / request.width, 1.0)

    def _fill(
        self, drawn: dict[str, _Drawn], items: tuple[Item, ...] | None, renderer: Any, hover: int | None, anew: bool
    ) -> None:
        if items is None:
            for one in drawn.values():
                under = isinstance(one.item, Mesh) and one.item.pickable and hover != one.hover
                if one.item is not None and (anew or under):
                    one.show(one.item, self._palette, self._ratio, hover)
            return
        names = {item.name for item in items}
        for name in [name for name in drawn if name not in names]:
            drawn.pop(name).remove()
        for item in items:
            if item.name not in drawn:
                drawn[item.name] = _Drawn(renderer, self._swapped)
            drawn[item.name].show(item, self._palette, self._ratio, hover)


class Stage:
    """Renders requests off-screen into pixels; one for each 3D view. `close` frees it."""

    def __init__(self) -> None:
        if sys.platform.startswith("linux") and not os.environ.get("DISPLAY"):
            os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")
        import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (registers the OpenGL classes)
        from vtkmodules.vtkRenderingCore import vtkRenderWindow

        self._window = vtkRenderWindow()
        self._window.SetOffScreenRendering(1)
        self._window.SetMultiSamples(0)
        self._scenery = Scenery(self._window, swapped=True)

    def draw(self, request: Request, into: NDArray[np.uint8] | None = None) -> NDArray[np.uint8]:
        """Pixels (height, width, 4), top row first, blue green red (unused): what Qt calls RGB32.

        Args:
            request: What to draw.
            into: Array for the pixels; None makes one.
        """
        self._window.SetSize(request.width, request.height)
        self._scenery.show(request)
        self._window.Render()
        return self._pixels(request, into)

    def close(self) -> None:
        """Free the OpenGL objects."""
        self._scenery.clear()
        self._window.Finalize()

    def _pixels(self, request: Request, into: NDArray[np.uint8] | None) -> NDArray[np.uint8]:
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkCommonCore import vtkUnsignedCharArray

        shape = (request.height, request.width, 4)
        read = vtkUnsignedCharArray()
        self._window.GetRGBACharPixelData(0, 0, request.width - 1, request.height - 1, 0, read)
        pixels = np.empty(shape, dtype=np.uint8) if into is None else into
        pixels[...] = vtk_to_numpy(read).reshape(shape)[::-1]
        return pixels


def _parts(text: str, swapped: bool) -> tuple[float, float, float]:
    """Red, green and blue of `#rrggbb`, 0 to 1; swapped: blue first."""
    red, green, blue = (part / 255.0 for part in rgb_of(text))
    return (blue, green, red) if swapped else (red, green, blue)


def serve(connection: Any) -> None:
    """The drawing process: takes (request, name of the shared memory), answers with the seconds it took.

    It ends when the other side of the connection is gone.
    """
    from multiprocessing.shared_memory import SharedMemory

    if hasattr(os, "nice"):
        os.nice(3)  # the screen's own process goes first
    stage = Stage()
    memory: SharedMemory | None = None
    while True:
        try:
            request, name = connection.recv()
        except (EOFError, ConnectionResetError):
            break
        if memory is None or memory.name != name:
            if memory is not None:
                memory.close()
            memory = SharedMemory(name=name)
        begun = time.monotonic()
        shape = (request.height, request.width, 4)
        stage.draw(request, np.ndarray(shape, dtype=np.uint8, buffer=memory.buf))
        connection.send(time.monotonic() - begun)
    if memory is not None:
        memory.close()
    stage.close()
