"""3D pictures of the report, drawn off-screen by pyvista: scan on CAD, error on the blade, paths."""

from __future__ import annotations

import io
import os
import sys
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from core.cad import CadModel
from core.error_surface import ErrorSurface
from core.path import AirfoilSurface

Array = NDArray[np.float64]
SIZE = (1100, 640)
CAD_GREY = "#ced4da"
# What a picture of this size can show; the numbers come from all points.
MOST_POINTS = 60_000
EXAGGERATION = 20.0
# The coloured patch is drawn on this grid, lifted off the grey blade so that the two do not flicker.
ACROSS, ALONG, LIFT_MM = 400, 120, 0.3


def _plotter() -> Any:
    import pyvista

    prepare_rendering()
    plotter = pyvista.Plotter(off_screen=True, window_size=SIZE)
    plotter.set_background("white")
    return plotter


def _png(plotter: Any, look_from: Sequence[float], up: Sequence[float]) -> bytes:
    plotter.view_vector(look_from, viewup=up)
    plotter.reset_camera(bounds=plotter.bounds)
    plotter.camera.zoom(1.35)
    plotter.add_axes(xlabel="x", ylabel="y", zlabel="z")
    return _shot(plotter)


def prepare_rendering() -> None:
    """Without a screen VTK would try one and complain before it renders by EGL; tell it at once."""
    if sys.platform.startswith("linux") and not os.environ.get("DISPLAY"):
        os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")


def _shot(plotter: Any) -> bytes:
    from PIL import Image

    pixels = plotter.screenshot(return_img=True)
    plotter.close()
    buffer = io.BytesIO()
    Image.fromarray(pixels).save(buffer, format="PNG", optimize=True)
    return buffer.getvalue()


def blade_mesh(model: CadModel, deflection_mm: float = 0.05) -> Any:
    """The blade as a pyvista mesh, {W}."""
    import pyvista

    mesh = model.tessellate(deflection_mm)
    faces = np.column_stack([np.full(len(mesh.triangles), 3), mesh.triangles]).ravel()
    return pyvista.PolyData(mesh.vertices, faces)


def _bar(title: str, digits: str) -> dict[str, Any]:
    return {"title": title, "color": "black", "fmt": digits, "vertical": True, "position_x": 0.9, "position_y": 0.1,
            "height": 0.8, "width": 0.06, "title_font_size": 14, "label_font_size": 13, "n_labels": 5}  # fmt: skip


def scan_on_cad(model: CadModel, points_in_work: Array, distances_mm: Array, limit_mm: float) -> bytes:
    """The scan over the CAD model, coloured by signed distance to its face.

    Args:
        model: The blade.
        points_in_work: (N, 3) mm.
        distances_mm: (N,) signed distance of points on a registration face, NaN for all others (drawn grey).
        limit_mm: End of the colour scale.
    """
    import pyvista

    plotter = _plotter()
    plotter.add_mesh(blade_mesh(model), color=CAD_GREY, opacity=0.55, smooth_shading=True, split_sharp_edges=True)
    step = max(1, len(points_in_work) // MOST_POINTS)
    points, distances = points_in_work[::step], distances_mm[::step]
    on_face = np.isfinite(distances)
    plotter.add_mesh(pyvista.PolyData(points[~on_face]), color="#868e96", point_size=2, opacity=0.5)
    cloud = pyvista.PolyData(points[on_face])
    cloud["µm"] = 1000.0 * distances[on_face]
    plotter.add_mesh(cloud, scalars="µm", cmap="RdBu_r", clim=(-1000.0 * limit_mm, 1000.0 * limit_mm), point_size=3,
                     scalar_bar_args=_bar("signed distance in µm", "%.0f"))  # fmt: skip
    return _png(plotter, (1.0, 1.0, 0.5), (1.0, -1.0, 0.0))


def error_on_blade(model: CadModel, airfoil: AirfoilSurface, surface: ErrorSurface) -> bytes:
    """The measured normal error on the airfoil, seen from both sides."""
    import pyvista

    low_u, high_u, low_v, high_v = surface.region.bounds
    u, v = (axis.ravel() for axis in np.meshgrid(np.linspace(low_u, high_u, ACROSS), np.linspace(low_v, high_v, ALONG)))
    points = airfoil.derivatives(u, v)[0] + LIFT_MM * airfoil.normal(u, v)
    patch = pyvista.StructuredGrid()
    patch.points = points
    patch.dimensions = (ACROSS, ALONG, 1)
    patch["mm"] = surface.evaluate(u, v)
    limit = float(np.nanmax(np.abs(patch["mm"])))
    blade = blade_mesh(model)
    prepare_rendering()
    plotter = pyvista.Plotter(off_screen=True, window_size=SIZE, shape=(2, 1), border=False)
    for row, (side, look_from) in enumerate((("suction side", (0.3, 1.0, 0.1)), ("pressure side", (0.3, -1.0, 0.1)))):
        plotter.subplot(row, 0)
        plotter.set_background("white")
        plotter.add_mesh(blade, color=CAD_GREY, smooth_shading=True, split_sharp_edges=True)
        plotter.add_mesh(patch, scalars="mm", cmap="RdBu_r", clim=(-limit, limit), nan_opacity=0.0,
                         show_scalar_bar=row == 1, scalar_bar_args=_bar("normal error in mm", "%.1f"))  # fmt: skip
        plotter.add_text(side, font_size=9, color="black")
        plotter.view_vector(look_from, viewup=(1.0, 0.0, 0.0))
        plotter.camera.zoom(2.1)
    return _shot(plotter)


def path_before_and_after(model: CadModel, strokes: Sequence[tuple[Array, Array]]) -> bytes:
    """Nominal contacts (orange) and compensated ones (blue), the difference exaggerated.

    Args:
        model: The blade.
        strokes: (nominal (N, 3), compensated (N, 3)) contact points of each stroke in {W}, mm.
    """
    plotter = _plotter()
    plotter.add_mesh(blade_mesh(model), color=CAD_GREY, opacity=0.35, smooth_shading=True, split_sharp_edges=True)
    for nominal, compensated in strokes:
        shown = nominal + EXAGGERATION * (compensated - nominal)
        plotter.add_lines(nominal, color="#c55a11", width=3, connected=True)
        plotter.add_lines(shown, color="#1f4e79", width=3, connected=True)
    plotter.add_text(f"difference drawn {EXAGGERATION:.0f} times", font_size=9, color="black")
    return _png(plotter, (0.4, 1.0, 0.1), (1.0, -0.4, 0.0))
