"""Each picture of the report is a PNG that shows something."""

import io
from collections.abc import Callable

import numpy as np
import pytest
from PIL import Image

from beltgui.report import figures, scenes
from core.error_surface import ErrorSurface, fit_error_surface
from tests.beltgui.live import blade_and_model


@pytest.fixture(scope="module")
def surface() -> ErrorSurface:
    """A cosine over the span with a missing and a bounced sample."""
    rng = np.random.default_rng(0)
    u, v = (axis.ravel() for axis in np.meshgrid(np.linspace(0.1, 0.9, 20), np.linspace(0.1, 0.9, 16)))
    error = 0.5 * np.cos(4.0 * np.pi * v) + rng.normal(0.0, 0.01, len(u))
    error[40] = np.nan
    error[100] += 1.0
    found = fit_error_surface(u, v, error, mode="smooth")
    assert len(found.rejected) >= 1 and found.missing.sum() == 1
    return found


def decoded(png: bytes) -> np.ndarray:
    with Image.open(io.BytesIO(png)) as image:
        assert image.format == "PNG"
        return np.asarray(image.convert("RGB"), dtype=float)


def shows_something(picture: np.ndarray) -> None:
    """Not uniform in any of its colours, and more than a frame: thousands of pixels differ from the corner."""
    assert picture.shape[0] > 200 and picture.shape[1] > 300
    assert picture.std(axis=(0, 1)).min() > 3.0
    assert (np.abs(picture - picture[0, 0]).max(axis=2) > 20.0).sum() > 5_000


def residuals(seed: int) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    return np.abs(rng.normal(0.0, 0.02, 9)), np.abs(rng.normal(0.0, 0.03, 3))


def stroke(seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    along = np.linspace(0.0, 1.0, 30)
    return along, 0.5 * np.cos(6.0 * along + seed), 0.01 * np.cos(20.0 * along)


PLOTS: dict[str, Callable[[ErrorSurface], bytes]] = {
    "bars of one group": lambda surface: figures.residual_bars({"ball": residuals(0)}),
    "bars of three groups": lambda surface: figures.residual_bars({str(i): residuals(i) for i in range(3)}),
    "bars with nothing held out": lambda surface: figures.residual_bars({"ball": (residuals(0)[0], np.zeros(0))}),
    "histogram of one face": lambda surface: figures.face_histograms({"S2": np.random.default_rng(0).normal(size=99)}),
    "histograms of five faces": lambda surface: figures.face_histograms(
        {f"S{i}": np.random.default_rng(i).normal(0.0, 0.03, 500) for i in range(2, 7)}
    ),
    "map": figures.error_map,
    "leave one out": figures.leave_one_out_map,
    "before and after": lambda surface: figures.before_and_after(
        {"transverse": [stroke(0), stroke(1)], "longitudinal": [stroke(2)]},
        {"transverse": "u, around the profile", "longitudinal": "v, along the span"},
    ),
}


@pytest.mark.parametrize("name", PLOTS)
def test_a_plot_shows_something(surface: ErrorSurface, name: str) -> None:
    shows_something(decoded(PLOTS[name](surface)))


def test_the_scan_is_coloured_on_the_blade() -> None:
    _, model = blade_and_model()
    points = model.tessellate(0.05).vertices
    distances = np.where(points[:, 2] > 150.0, 0.05 * np.sin(points[:, 0]), np.nan)
    picture = decoded(scenes.scan_on_cad(model, points, distances, 0.05))
    shows_something(picture)
    coloured = np.ptp(picture, axis=2) > 60.0
    assert coloured.sum() > 500


def test_the_error_is_coloured_on_both_sides_of_the_blade(surface: ErrorSurface) -> None:
    blade, model = blade_and_model()
    picture = decoded(scenes.error_on_blade(model, model.spline_surface(blade.airfoil), surface))
    shows_something(picture)
    red = picture[..., 0] > picture[..., 2] + 60.0
    blue = picture[..., 2] > picture[..., 0] + 60.0
    half = len(picture) // 2
    for side in (slice(0, half), slice(half, None)):
        assert red[side].sum() > 500 and blue[side].sum() > 500


def test_paths_before_and_after_are_drawn_apart() -> None:
    blade, model = blade_and_model()
    airfoil = model.spline_surface(blade.airfoil)
    along = np.linspace(0.1, 0.9, 60)
    strokes = []
    for u in (0.2, 0.6, 0.7, 0.8):
        nominal = airfoil.derivatives(np.full(60, u), along)[0]
        strokes.append((nominal, nominal + 0.5 * airfoil.normal(np.full(60, u), along)))
    picture = decoded(scenes.path_before_and_after(model, strokes))
    shows_something(picture)
    orange = (picture[..., 0] > 150.0) & (picture[..., 2] < 80.0)
    blue = picture[..., 2] > picture[..., 0] + 60.0
    assert orange.sum() > 300
    assert blue.sum() > 300
