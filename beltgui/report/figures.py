"""Pictures of the report: plots by matplotlib without any window, each axis with its unit."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from core.error_surface import ErrorSurface

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = NDArray[np.float64]
BLUE, ORANGE = "#1f4e79", "#c55a11"
# Okabe and Ito's palette tells faces apart for colour-blind readers too.
PALETTE = ("#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#999933", "#882255")


def _canvas(rows: int, columns: int, size: tuple[float, float]) -> tuple[Any, NDArray[Any]]:
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=size, layout="constrained")
    FigureCanvasAgg(figure)
    return figure, np.atleast_2d(figure.subplots(rows, columns, squeeze=False))


def _png(figure: Any) -> bytes:
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=110)
    return buffer.getvalue()


def _bars(axes: Axes, labels: Sequence[str], values_um: Array, held_out: Sequence[bool]) -> None:
    colours = [ORANGE if held else BLUE for held in held_out]
    axes.bar(np.arange(len(values_um)), values_um, color=colours)
    axes.set_xticks(np.arange(len(values_um)), labels, rotation=60, ha="right", fontsize=7)
    axes.set_ylabel("distance in µm")
    axes.grid(axis="y", alpha=0.3)


def residual_bars(groups: Mapping[str, tuple[Array, Array]]) -> bytes:
    """Residuals of the fit (blue) and errors at held-out observations (orange), a plot for each group.

    Args:
        groups: Title to (lengths of the fit's residuals (N,), held-out errors (M,)), mm.
    """
    figure, axes = _canvas(1, len(groups), (4.2 * len(groups) + 1.0, 3.4))
    for panel, (title, (fitted, held)) in zip(axes[0], groups.items(), strict=True):
        values = 1000.0 * np.concatenate([fitted, held])
        names = [f"fit {i + 1}" for i in range(len(fitted))] + [f"held out {i + 1}" for i in range(len(held))]
        _bars(panel, names, values, [False] * len(fitted) + [True] * len(held))
        panel.set_title(title, fontsize=10)
    return _png(figure)


def face_histograms(distances_mm: Mapping[str, Array]) -> bytes:
    """Histogram of the signed distances of the scan to each face."""
    columns = min(3, len(distances_mm))
    rows = -(-len(distances_mm) // columns)
    figure, axes = _canvas(rows, columns, (3.6 * columns, 2.6 * rows))
    limit = max(float(np.quantile(np.abs(values), 0.999)) for values in distances_mm.values()) * 1000.0
    for number, panel in enumerate(axes.ravel()):
        if number >= len(distances_mm):
            panel.set_axis_off()
            continue
        label, values = list(distances_mm.items())[number]
        panel.hist(1000.0 * values, bins=60, range=(-limit, limit), color=PALETTE[number % len(PALETTE)])
        panel.axvline(0.0, color="black", lw=0.8)
        panel.set_title(f"{label}: {len(values)} points, RMS {1000.0 * np.sqrt(np.mean(values**2)):.0f} µm", fontsize=9)
        panel.set_xlabel("signed distance in µm")
        panel.set_yticks([])
    return _png(figure)


def error_map(surface: ErrorSurface) -> bytes:
    """The surface over (u, v) with rejected and missing samples, and its cross-sections."""
    low_u, high_u, low_v, high_v = surface.region.bounds
    u, v = np.linspace(low_u, high_u, 240), np.linspace(low_v, high_v, 240)
    values = surface.evaluate(u[:, None], v[None, :])
    limit = float(np.nanmax(np.abs(values)))
    figure, axes = _canvas(1, 2, (11.0, 4.2))
    panel = axes[0, 0]
    image = panel.pcolormesh(u, v, values.T, cmap="RdBu_r", vmin=-limit, vmax=limit, shading="auto", rasterized=True)
    figure.colorbar(image, ax=panel, label="normal error e(u, v) in mm")
    rejected, missing = surface.rejected, surface.missing
    panel.plot(surface.sample_u[rejected], surface.sample_v[rejected], "x", color="black", ms=4,
               label=f"{len(rejected)} rejected")  # fmt: skip
    panel.plot(surface.sample_u[missing], surface.sample_v[missing], "o", mfc="none", color="black", ms=4,
               label=f"{int(missing.sum())} missing")  # fmt: skip
    panel.legend(loc="upper right", fontsize=8)
    panel.set_xlabel("u, around the profile")
    panel.set_ylabel("v, along the span")
    sections = axes[0, 1]
    for number, at in enumerate(np.linspace(low_u, high_u, 5)):
        sections.plot(v, surface.evaluate(np.full(len(v), at), v), color=PALETTE[number], label=f"u = {at:.2f}")
    sections.set_xlabel("v, along the span")
    sections.set_ylabel("normal error in mm")
    sections.legend(fontsize=8)
    sections.grid(alpha=0.3)
    return _png(figure)


def leave_one_out_map(surface: ErrorSurface) -> bytes:
    """Leave-one-out errors of the samples used."""
    figure, axes = _canvas(1, 2, (11.0, 3.6))
    used = surface.used
    values = 1000.0 * surface.leave_one_out_mm[used]
    limit = float(np.quantile(np.abs(values), 0.995))
    points = axes[0, 0].scatter(surface.sample_u[used], surface.sample_v[used], c=values, s=3, cmap="RdBu_r",
                                vmin=-limit, vmax=limit)  # fmt: skip
    figure.colorbar(points, ax=axes[0, 0], label="leave-one-out error in µm")
    axes[0, 0].set_xlabel("u, around the profile")
    axes[0, 0].set_ylabel("v, along the span")
    axes[0, 1].hist(values, bins=80, range=(-limit, limit), color=BLUE)
    axes[0, 1].set_xlabel("leave-one-out error in µm")
    axes[0, 1].set_ylabel("samples")
    return _png(figure)


def before_and_after(strokes: Mapping[str, Sequence[tuple[Array, Array, Array]]], across: Mapping[str, str]) -> bytes:
    """True normal error along the strokes, nominal against compensated, on one scale.

    Args:
        strokes: Program to its strokes: (parameter along the stroke (N,), nominal mm (N,), compensated mm (N,)).
        across: Program to the label of its parameter axis.
    """
    figure, axes = _canvas(1, len(strokes), (5.6 * len(strokes), 3.8))
    for panel, (name, lines) in zip(axes[0], strokes.items(), strict=True):
        for number, (parameter, nominal, compensated) in enumerate(lines):
            panel.plot(parameter, nominal, color=ORANGE, lw=1.0, label="nominal path" if number == 0 else None)
            panel.plot(parameter, compensated, color=BLUE, lw=1.0, label="compensated path" if number == 0 else None)
        panel.set_title(f"{name}, {len(lines)} strokes", fontsize=10)
        panel.set_xlabel(across[name])
        panel.set_ylabel("normal error left in mm")
        panel.grid(alpha=0.3)
        panel.legend(fontsize=8)
    return _png(figure)
