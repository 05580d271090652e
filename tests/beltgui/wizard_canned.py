"""Steps as the engine would show them, made up: for tests and screenshots of the page."""

from dataclasses import replace
from typing import Any

import numpy as np
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from beltgui.engine.messages import Question
from beltgui.steps.state import StepState
from beltgui.viewmodel.plot import Band, Bars, Curve, LimitLine, Map, Marks, Plot
from beltgui.viewmodel.scene import Frame, Points, Role, Scale, Scene
from beltgui.viewmodel.step import (
    Action,
    Check,
    Column,
    Number,
    ReasonView,
    SampleRow,
    StepContent,
    StepView,
    Suggestion,
    Use,
)

COLUMNS = (
    Column("stage_x", "Stage x", "mm", 2),
    Column("residual", "Residual", "mm", 4),
    Column("radius", "Radius", "mm", 4),
)


class FakeScene(QWidget):
    """A 3D view that only notes what it was told."""

    picked_point = Signal(str, object, bool)
    picked_face = Signal(int, bool)

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("scene_view")
        self.told: dict[str, Any] = {}

    def prepare(self) -> None:
        self.told["prepared"] = True

    def show_scene(self, scene: Any, second: Any = None) -> None:
        self.told["scene"] = (scene, second)

    def show_motion(self, path: Any) -> None:
        self.told["motion"] = path

    def show_robot(self, base_from_flange: Any) -> None:
        self.told["robot"] = base_from_flange

    def show_picks(self, first: Any = (), second: Any = ()) -> None:
        self.told["picks"] = (first, second)

    def set_pick_mode(self, mode: str) -> None:
        self.told["mode"] = mode

    def shut_down(self) -> None:
        self.told["closed"] = True


def rows(count: int = 20, first: int = 1) -> tuple[SampleRow, ...]:
    """Samples with residuals; one worst, one left out, two held out."""
    rng = np.random.default_rng(3)
    found = []
    for place in range(count):
        use = Use.HELD_OUT if place % 10 == 7 else Use.FIT
        cells = (float(rng.uniform(0, 200)), float(rng.normal(0, 0.02)), 12.7 + float(rng.normal(0, 0.002)))
        found.append(SampleRow(first + place, f"scan {place + 1}", cells, use))
    if count > 5:
        found[3] = replace(found[3], flag="worst", cells=(80.0, 0.071, 12.709), note="Farthest from the fit.")
        found[5] = replace(found[5], included=False, use=Use.EXCLUDED, cells=(90.0, None, float("nan")))
    return tuple(found)


def plots(samples: tuple[SampleRow, ...]) -> tuple[Plot, ...]:
    """Every kind of series."""
    x = np.arange(len(samples), dtype=float)
    y = np.array([1000.0 * row.cells[1] if isinstance(row.cells[1], float) else np.nan for row in samples])
    held = np.array([row.use is Use.HELD_OUT for row in samples], dtype=bool)
    ids = tuple(row.id for row in samples)
    marks = (
        Marks(x[~held], y[~held], Role.FIT, "fit", tuple(i for i, h in zip(ids, held, strict=True) if not h)),
        Marks(x[held], y[held], Role.HELD_OUT, "held out", tuple(i for i, h in zip(ids, held, strict=True) if h)),
    )
    u = np.linspace(0, 1, 60)
    grid = 40 * np.sin(6 * u)[None, :] * np.cos(4 * u)[:, None]
    grid[:5, :5] = np.nan
    wave = 30 * np.sin(6 * u)
    counts, edges = np.histogram(np.nan_to_num(y), 9)
    return (
        Plot("residuals", "Residuals", "sample", "residual, µm", marks, (LimitLine(60.0, "limit 60 µm"),)),
        Plot("section", "Section", "u, mm", "error, µm", (
            Band(70 * u, wave - 8, wave + 8, Role.FIT, "± (k = 2)"), Curve(70 * u, wave, Role.FIT, "spline"),
            Curve(70 * u, wave + 20, Role.PATH, "nominal", dashed=True),
        )),
        Plot("histogram", "Histogram", "residual, µm", "samples", (
            Bars((edges[1:] + edges[:-1]) / 2, counts.astype(float), Role.INLIER, "samples", width=1.0),
        )),
        Plot("faces", "Faces", "face", "RMS, µm", (
            Bars(np.arange(3.0), np.array([12.0, 15.0, 9.0]), Role.INLIER, "faces", ("pressure", "suction", "root")),
        )),
        Plot("map", "Map", "u, mm", "v, mm", (Map(grid, (0, 70), (0, 160), Scale("error, µm", -40, 40)),)),
    )  # fmt: skip


def scene() -> Scene:
    """A sphere of points with a frame."""
    rng = np.random.default_rng(1)
    xyz = rng.normal(size=(4000, 3))
    xyz = (12.7 * xyz / np.linalg.norm(xyz, axis=1, keepdims=True)).astype(np.float32)
    return Scene("Ball in the scans", "M", (Points("scan", xyz, Role.SCAN), Frame("{M}", np.eye(4), 20.0)), "ball",
                 ((Role.SCAN, "measured"),))  # fmt: skip


NUMBERS = (
    Number("Position of the scanner in {M}, x", 123.4567, "mm", 0.0121, 4, main=True),
    Number("RMS of the residuals", 0.0213, "mm", None, 4, 0.05, main=True),
    Number("Squareness xy", 0.0123, "deg", 0.0031, 4, 0.02),
    Number("Largest leave-one-out error", 0.061, "mm", None, 4, 0.05),
    Number("Scale of x", None, "ppm", None, 0),
)
CHECKS = (
    Check("RMS error of the predicted ball centres", 0.0231, "mm", 0.05, 4, True),
    Check("closing scan: ball has stayed", 0.083, "mm", 0.06, 1, False),
    Check("second closing scan", None, "mm", 0.06, 0, None),
)
REASON = ReasonView(
    "HELD_OUT_ERROR",
    "The ball has moved by 0.083 mm since the first scan, the limit is 0.06 mm. Tighten the ball's clamp and take the "
    "samples of this step again.",
)


def content(count: int = 20, **changes: Any) -> StepContent:
    """A solved and good step."""
    samples = rows(count)
    made = StepContent(
        columns=COLUMNS, rows=samples, numbers=NUMBERS, ok=True, checks=CHECKS[:1], progress=f"{count} of 20 scans",
        complete=count >= 20, headline="RMS 0.021 mm over 20 scans", scene=scene(), plots=plots(samples),
        suggestion=Suggestion("One more scan near x = 180 mm, turned by 40 deg.", "squareness xy 0.0031 to 0.0018 deg"),
    )  # fmt: skip
    return replace(made, **changes)


ALL = frozenset(Action)


def view(step: str = "ball", generation: int = 1, state: StepState = StepState.RUNNING, actions: Any = ALL,
         why: tuple[str, ...] = (), made: StepContent | None = None, **changes: Any) -> StepView:  # fmt: skip
    """A step's view; `changes` are of its content."""
    return StepView(step, generation, state, "RMS 0.021 mm", why, frozenset(actions),
                    made if made is not None else content(**changes))  # fmt: skip


def empty(step: str = "ball", **changes: Any) -> StepView:
    """A step that has not begun."""
    made = StepContent(progress="0 of 20 scans", **changes)
    return StepView(step, 1, StepState.NOT_STARTED, "", (), frozenset({Action.ACQUIRE}), made)


def motion(number: int = 1) -> Question:
    """A motion to be let go."""
    path = np.tile(np.eye(4), (20, 1, 1))
    path[:, 0, 3] = np.linspace(400, 700, 20)
    path[:, 2, 3] = 500 + 80 * np.sin(np.linspace(0, 3, 20))
    return Question(number, "motion", "motion", "The robot moves to bring the ball into the scanner's view.", path,
                    312.0, 3.4, 120.0)  # fmt: skip


def mounting(number: int = 1, picture: str = "mount ball") -> Question:
    """Something to mount."""
    return Question(number, "mount", picture, "Mount the ball on the flange, then confirm.")
