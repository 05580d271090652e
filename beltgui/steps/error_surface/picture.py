"""The step's picture, {W}: error on the airfoil, probed points, nominal and compensated path, wheel at a contact."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from beltgui.steps.error_surface.clamped import with_frames
from beltgui.steps.error_surface.probing import CLEAR_MM
from beltgui.steps.error_surface.series import STEP
from beltgui.steps.error_surface.shown import Shown, airfoil_of, maps_of, net_of
from beltgui.steps.error_surface.step import ErrorSurfaceOutcome
from beltgui.steps.views import blade, drawing
from beltgui.steps.views.common import UM_PER_MM
from beltgui.viewmodel.scene import Frame, Item, Lines, Mesh, Points, Role, Scale, Scene
from beltgui.viewmodel.step import Use
from core.frames import inverse
from core.path import CellFrames

Array = NDArray[np.float64]
DEFLECTION_MM, TURN_RAD = 0.2, 0.3
# Drawn this far off the airfoil, so that points and lines do not flicker in it.
LIFT_MM = 0.3
# Onto the side of the airfoil that the wheel is drawn at, and past the wheel.
LOOK_FROM = (0.35, -0.85, 0.4)
SCALE_TITLE = "normal error, µm"
LEAST_SCALE_UM = 10.0


def scene_of(shown: Shown) -> Scene:
    """The picture for what there is so far."""
    scale = _scale(shown)
    items: list[Item | None] = [_blade(shown), _airfoil(shown, scale), *_points(shown, scale), *_todo(shown)]
    legend = [
        (Role.INLIER, "probed"),
        (Role.HELD_OUT, "held out"),
        (Role.OUTLIER, "rejected"),
        (Role.EXCLUDED, "left out"),
    ]
    title = "Blade in {W}: points probed so far"
    if shown.outcome is not None:
        title = "Blade in {W}: normal error of the airfoil"
        if shown.outcome.programs:
            items += _paths(shown, shown.outcome)
            legend += [(Role.PATH, "nominal path"), (Role.PATH_COMPENSATED, "compensated path")]
            legend.append((Role.PATH_COMPENSATED, f"compensation drawn x{shown.settings.exaggeration:g}"))
    items += [*_wheel(shown), drawing.frame("W", np.eye(4))]
    if shown.todo:
        legend += [(Role.SUGGESTION, "line that is probed next"), (Role.MUTED, "lines to come")]
    return drawing.scene(
        title, "W", items, view=f"error_surface {shown.settings.grinder}", legend=legend, look_from=LOOK_FROM,
        up=blade.lying(np.array(LOOK_FROM)), fit_to=("blade", "airfoil", "wheel", "compensated"),
    )  # fmt: skip


def scale_of_um(values_mm: Array) -> Scale:
    """Symmetric about zero, to the next round number of µm."""
    known = np.abs(values_mm[np.isfinite(values_mm)])
    largest = max(UM_PER_MM * float(known.max()), LEAST_SCALE_UM) if len(known) else LEAST_SCALE_UM
    step = 10.0 ** np.floor(np.log10(largest))
    end = float(np.ceil(2.0 * largest / step) * step / 2.0)
    return Scale(SCALE_TITLE, -end, end)


def _scale(shown: Shown) -> Scale:
    if shown.outcome is not None:
        return scale_of_um(maps_of(shown.bench, shown.outcome.surface)[0])
    return scale_of_um(np.concatenate([np.zeros(1), *(line.error_mm for line in shown.counted)]))


def _blade(shown: Shown) -> Mesh:
    """All faces but the airfoil, which is drawn with its errors."""
    key = (STEP, "blade mesh")
    cache = shown.bench.cache
    if key not in cache:
        mesh = shown.bench.model.tessellate(DEFLECTION_MM, TURN_RAD)
        keep = mesh.face_ids != shown.bench.model.face(shown.bench.blade.airfoil).id
        cache[key] = Mesh(
            "blade", drawing.display(mesh.vertices), mesh.triangles[keep].astype(np.int32), Role.BLADE,
            face_id=mesh.face_ids[keep].astype(np.int32),
        )  # fmt: skip
    blade: Mesh = cache[key]
    return blade


def _airfoil(shown: Shown, scale: Scale) -> Mesh:
    net = net_of(shown.bench)
    if shown.outcome is None:
        return Mesh("airfoil", drawing.display(net.points), net.triangles, Role.BLADE)
    values = UM_PER_MM * maps_of(shown.bench, shown.outcome.surface)[0].ravel()
    return Mesh(
        "airfoil", drawing.display(net.points), net.triangles, Role.BLADE, values=values.astype(np.float32), scale=scale
    )


def _lifted(shown: Shown, u: Array, v: Array) -> Array:
    surface = airfoil_of(shown.bench)
    return np.asarray(surface.derivatives(u, v)[0] + LIFT_MM * surface.normal(u, v))


def _points(shown: Shown, scale: Scale) -> list[Item | None]:
    """Probed points: coloured by their error until there is a surface, then by what they are used for."""
    lines = shown.counted
    if not lines:
        return []
    joined = [np.concatenate([getattr(line, name) for line in lines]) for name in ("u", "v", "error_mm", "rejected")]
    u, v, error, rejected = joined[0], joined[1], joined[2], joined[3].astype(bool)
    use = np.concatenate([np.full(len(line.u), line.use.value) for line in lines])
    xyz = _lifted(shown, u, v)
    read = np.isfinite(error)
    groups = (
        ("probed", (use == Use.FIT.value) & ~rejected, Role.INLIER, 2.0),
        ("held out", use == Use.HELD_OUT.value, Role.HELD_OUT, 6.0),
        ("rejected", rejected, Role.OUTLIER, 8.0),
        ("left out", use == Use.EXCLUDED.value, Role.EXCLUDED, 4.0),
    )
    items: list[Item | None] = []
    for name, chosen, role, size in groups:
        chosen = chosen & read
        coloured = shown.outcome is None and role in (Role.INLIER, Role.HELD_OUT)
        values = (UM_PER_MM * error[chosen]).astype(np.float32) if coloured else None
        items.append(Points(name, drawing.display(xyz[chosen]), role, values, scale if coloured else None,
                            2.0 * size if coloured else size))  # fmt: skip
    return items


def _todo(shown: Shown) -> list[Item | None]:
    """Lines that are still to be probed, the next one first."""
    if shown.series is None or not shown.todo:
        return []
    ways = [drawing.display(_lifted(shown, line.u, line.v)) for line in shown.todo]
    return [
        Lines("next line", (ways[0],), Role.SUGGESTION, 3.0),
        Lines("lines to come", tuple(ways[1:]), Role.MUTED, 1.0),
    ]


def _paths(shown: Shown, outcome: ErrorSurfaceOutcome) -> list[Item | None]:
    program = outcome.programs.get(shown.settings.path)
    if program is None:
        return []
    times = shown.settings.exaggeration
    nominal, compensated = [], []
    for stroke in program.plan.strokes:
        contacts = stroke.nominal_work_from_contact
        normals, at = contacts[:, :3, 2], contacts[:, :3, 3] + LIFT_MM * contacts[:, :3, 2]
        nominal.append(drawing.display(at))
        compensated.append(drawing.display(at + times * stroke.error_mm[:, None] * normals))
    return [
        Lines("nominal path", tuple(nominal), Role.PATH, 1.0),
        Lines("compensated path", tuple(compensated), Role.PATH_COMPENSATED, 2.0),
    ]


def _wheel(shown: Shown) -> list[Item | None]:
    """The contact wheel where it touches, or clear of where it will touch next."""
    presenting = None
    if shown.series is not None:
        presenting = with_frames(shown.bench, shown.series.frames, shown.series.grinder)
    if presenting is None:
        return []
    if shown.todo:
        line = shown.todo[0]
        pose = presenting.poses(line.u[:1], line.v[:1], CLEAR_MM)[0]
    else:
        grid = shown.bench.blade.probing
        middle = np.array([0.25 * grid.u_max + 0.75 * grid.u_min])
        pose = presenting.poses(middle, np.array([shown.settings.section_v]))[0]
    work_from_tool = _work_from_tool(pose, presenting.frames)
    plan = shown.bench.plan.grinders[shown.settings.grinder]
    wheel = drawing.cylinder(
        "wheel", work_from_tool[:3, 3], work_from_tool[:3, 2], plan.wheel_radius_mm, plan.wheel_width_mm, Role.WHEEL,
        0.5,
    )  # fmt: skip
    return [wheel, Frame("{H}", work_from_tool, 30.0)]


def _work_from_tool(base_from_flange: Array, frames: CellFrames) -> Array:
    return np.asarray(inverse(base_from_flange @ frames.flange_from_work) @ frames.base_from_tool)
