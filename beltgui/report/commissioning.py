"""The report of a commissioning, put together from what its steps found."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from beltgui.commissioning import Commissioning
from beltgui.report import figures, scenes
from beltgui.report.page import Figure, Page, Section, Table, vector_text
from beltgui.steps.held_out import HeldOut
from beltgui.steps.state import STEPS, TITLES
from core.cad import CadModel
from core.fine import assign_points
from core.frames import euler_zyx_from_rotation, inverse, transform_points

if TYPE_CHECKING:
    from beltgui.demo.proof import Proof
    from beltgui.demo.truth_table import Row

Array = NDArray[np.float64]
SCALE_SIGMAS = 3.0


def commissioning_page(
    found: Commissioning,
    info: Mapping[str, Any],
    *,
    accepted: bool,
    headline: str,
    rows: Sequence[Row] = (),
    proof: Proof | None = None,
) -> Page:
    """The whole report.

    Args:
        found: Outcomes of the steps; those not reached are left out.
        info: Software, serial, cell, date.
        accepted: The verdict over all.
        headline: Its sentence.
        rows: Truth against estimate, where the cell is simulated.
        proof: True normal errors along the paths, where the cell is simulated.
    """
    model, blade = found.bench.model, found.bench.blade
    made = {
        "ball": lambda: _ball(found),
        "base": lambda: _base(found),
        "rough": lambda: _rough(found),
        "fine": lambda: _fine(found, model),
        "tool": lambda: _tool(found),
        "error_surface": lambda: _error_surface(found, model),
    }
    sections = [_truth(rows, found)] if rows else []
    sections += [made[step]() for step in STEPS if step in found.verdicts]
    if found.programs:
        sections.append(_programs(found, model, proof))
    lead = (
        f"Blade {info['serial']} of type {blade.name} ({blade.description}). Cell file {info['cell']}, grinder "
        f"{info['grinder']}, {info['date']}, beltcal {info['software']}"
        + (f", simulated cell with seed {info['seed']}." if info.get("simulated") else ".")
        + " Lengths in mm or µm, angles in degrees, as stated."
    )
    return Page("Commissioning of the belt grinding cell", lead, accepted, headline, sections)


def _truth(rows: Sequence[Row], found: Commissioning) -> Section:
    cells = []
    for step in STEPS:
        for number, row in enumerate(row for row in rows if row.step == step):
            verdict = ("accepted" if found.verdicts[step].ok else "rejected") if number == 0 else ""
            name = f"{STEPS.index(step) + 1} {TITLES[step]}" if number == 0 else ""
            cells.append((name, row.quantity, row.truth, row.estimate, row.error, verdict))
    text = (
        "The cell is simulated, so the truth is known. Frames that involve the robot carry its absolute error of some "
        "tenths of a millimetre; the error surface measures what reaches the contact, and the paths compensate it."
    )
    table = Table(("step", "quantity", "truth", "estimate", "error", "verdict"), cells)
    return Section("Truth against estimate", text, tables=[table])


def _section(
    step: str, found: Commissioning, text: str, tables: Sequence[Table], pictures: Sequence[Figure]
) -> Section:
    verdict = found.verdicts[step]
    title = f"{STEPS.index(step) + 1} {TITLES[step]}"
    return Section(title, text, verdict.ok, [reason.message for reason in verdict.reasons], tables, pictures)


def _ball(found: Commissioning) -> Section:
    outcome = found.ball
    assert outcome is not None
    stage, spheres = outcome.stage, outcome.spheres
    rows = [
        ("scans of the ball", str(len(spheres)), ""),
        ("ball centre, noise along the radius", _um(np.mean([sphere.sigma_mm for sphere in spheres])), "mean of scans"),
        ("share of the sphere seen", f"{100.0 * np.mean([sphere.coverage for sphere in spheres]):.0f} %", "mean"),
        ("stage model, RMS", _um(stage.rms_mm), "residuals of the fit"),
        *((f"squareness {name}", f"{np.degrees(value):+.4f} °", "deviation from 90°")
          for name, value in zip(("xy", "yz", "zx"), stage.squareness_rad, strict=True)),
        _held_row(outcome.held_out),
    ]  # fmt: skip
    lengths = np.linalg.norm(stage.residuals_mm, axis=1)
    png = figures.residual_bars({"ball centre in {M}": (lengths, outcome.held_out.errors_mm)})
    return _section("ball", found, "The ball stands still, the stage moves the scanner.", [_facts(rows)],
                    [Figure(png, "Distance of the ball centre from the model: scans in the fit, and scans kept out.")])


def _base(found: Commissioning) -> Section:
    outcome = found.base
    assert outcome is not None
    fit = outcome.fit
    sigma = np.sqrt(np.diag(fit.covariance.matrix))
    rows = [
        ("robot poses in the fit", str(len(fit.residuals_mm)), ""),
        *_pose_rows("measure in base", fit.base_from_measure),
        ("uncertainty of the position, k = 2", _um(2.0 * np.linalg.norm(sigma[3:])), "at the middle of the poses"),
        ("uncertainty of the orientation, k = 2", f"{np.degrees(2.0 * np.linalg.norm(sigma[:3])):.4f} °", ""),
        ("ball in flange", vector_text(fit.ball_in_flange_mm), "{F}"),
        ("RMS", _um(fit.rms_mm), "residuals of the fit"),
        ("weakest direction", fit.conditioning.description, f"condition {fit.conditioning.condition:.1f}"),
        _held_row(outcome.held_out),
    ]
    lengths = np.linalg.norm(fit.residuals_mm, axis=1)
    png = figures.residual_bars({"ball by scanner against ball by robot": (lengths, outcome.held_out.errors_mm)})
    return _section("base", found, "The ball on the flange, seen in many robot poses.", [_facts(rows)],
                    [Figure(png, "Distance between the ball as the scanner and as the robot see it, in {B}.")])


def _rough(found: Commissioning) -> Section:
    outcome = found.rough
    assert outcome is not None
    confirmed = outcome.confirmed
    rows = [*_pose_rows("blade in measure", outcome.measure_from_work),
            ("confirmed by the fine step, RMS", _um(confirmed.rms_mm) if confirmed else "no", "")]
    how = "from picked pairs of points" if outcome.pairs is not None else "without any starting pose"
    return _section("rough", found, f"The blade was found in the scan {how}.", [_facts(rows)], [])


def _fine(found: Commissioning, model: CadModel) -> Section:
    outcome = found.fine
    assert outcome is not None
    fit = outcome.fit
    rows = [
        *_pose_rows("blade in measure", fit.measure_from_work),
        *_pose_rows("blade in flange", outcome.flange_from_work),
        ("uncertainty at the blade's ends, k = 2", _um(2.0 * float(np.max(fit.point_sigma_mm))), "in {M}, from noise"),
        ("two halves of the data apart", _um(float(np.max(fit.half_split_mm))), "largest of root, mid, tip"),
        *_moved_row(outcome.moved_mm),
        ("points used", f"{fit.points_used} of {fit.points}", ""),
        ("RMS", _um(fit.rms_mm), "signed distance to the faces"),
        ("weakest direction", fit.conditioning.description, f"condition {fit.conditioning.condition:.1f}"),
    ]
    faces = Table(
        ("face", "type", "points", "RMS in µm", "mean in µm", "held out in µm", "seen", "note"),
        [(face.name or str(face.id), face.type, str(face.points), _plain_um(face.rms_mm),
          _signed_um(face.mean_mm, 2), _signed_um(face.held_out_mm, 1), f"{100.0 * face.coverage:.0f} %",
          face.note) for face in fit.faces],
        "Held out: mean distance of the face's points under the pose that the other faces give without it; – where "
        "they do not determine it, or where the face has no points.",
    )  # fmt: skip
    points = found.scan_points()
    used = [face.id for face in fit.faces if face.used]
    assigned = assign_points(model, points, fit.measure_from_work, used)
    ids, distances = assigned.face_id, assigned.distance_mm
    in_work = transform_points(inverse(fit.measure_from_work), points)
    by_face = {
        face.name or str(face.id): distances[ids == face.id] for face in fit.faces if np.any(ids == face.id)
    }
    limit = SCALE_SIGMAS * fit.sigma_mm
    pictures = [
        Figure(scenes.scan_on_cad(model, in_work, distances, limit),
               f"The scan on the CAD model. Points on the registration faces are coloured by signed distance, from "
               f"{-1000.0 * limit:.0f} to {1000.0 * limit:+.0f} µm; grey points belong to no registration face."),
        Figure(figures.face_histograms(by_face), "Signed distances of the points on each face."),
    ]  # fmt: skip
    return _section("fine", found, "The scan registered to planes and cylinders of the STEP model.",
                    [_facts(rows), faces], pictures)


def _moved_row(moved_mm: float | None) -> list[tuple[str, str, str]]:
    if moved_mm is None:
        return []
    return [("distance from the pose of the rough step's scans", _um(moved_mm), "largest of root, mid, tip")]


def _tool(found: Commissioning) -> Section:
    outcome = found.tool
    assert outcome is not None
    stylus = outcome.stylus
    rows = [
        ("stylus tip", vector_text(stylus.tip_in_flange_mm), "{F}"),
        ("uncertainty of the tip, k = 2", _um(2.0 * float(np.sqrt(np.trace(stylus.tip_covariance_mm2)))), ""),
        ("pivot RMS", _um(stylus.rms_mm), "residuals of the fit"),
        _held_row(outcome.cone_held_out),
    ]
    bars = {"cone": (np.linalg.norm(stylus.residuals_mm[stylus.used], axis=1), outcome.cone_held_out.errors_mm)}
    for name, wheel in outcome.wheels.items():
        sigma = np.sqrt(np.diag(wheel.covariance.matrix))
        rows += [
            *_pose_rows(f"wheel of grinder {name} in base", wheel.base_from_tool),
            (f"grinder {name}: uncertainty of the centre, k = 2", _um(2.0 * np.linalg.norm(sigma[3:])), ""),
            (f"grinder {name}: Rg", f"{wheel.radius_mm:.3f} mm", "head axis to wheel axis"),
            (f"grinder {name}: RMS", _um(wheel.rms_mm), "residuals of the fit"),
            _held_row(outcome.shafts_held_out[name]),
        ]
        bars[f"shaft of grinder {name}"] = (
            np.linalg.norm(np.atleast_2d(wheel.residuals_mm), axis=1), outcome.shafts_held_out[name].errors_mm
        )  # fmt: skip
    return _section("tool", found, "The stylus in its cone, then on the shaft of each contact wheel.", [_facts(rows)],
                    [Figure(figures.residual_bars(bars), "Distance of each touch from the model.")])


def _error_surface(found: Commissioning, model: CadModel) -> Section:
    outcome = found.error_surface
    assert outcome is not None
    surface, presenting = outcome.surface, outcome.presenting
    known = surface.sample_error_mm[surface.used]
    rows = [
        ("samples used", f"{int(surface.used.sum())} of {len(surface.used)}",
         f"{len(surface.rejected)} rejected, {int(surface.missing.sum())} missing"),
        ("normal error", f"{known.min():+.3f} to {known.max():+.3f} mm", f"RMS {np.sqrt(np.mean(known**2)):.3f} mm"),
        ("leave-one-out RMS", _um(surface.leave_one_out_rms_mm), "sample against all others"),
        ("wheel at the head's stop, moved since the tool step", _um(outcome.head_rest.moved_mm), ""),
        ("noise of a sample", _um(surface.sigma_mm) if surface.sigma_mm is not None else "–", "estimated"),
        _held_row(outcome.held_out),
    ]  # fmt: skip
    pictures = [
        Figure(scenes.error_on_blade(model, presenting.airfoil, surface), "The measured normal error on the airfoil."),
        Figure(figures.error_map(surface), "The error surface as a map, and sections along the span."),
        Figure(figures.leave_one_out_map(surface), "What each sample misses when it is predicted from all others."),
    ]
    return _section("error_surface", found, "The airfoil presented to the wheel, point by point.", [_facts(rows)],
                    pictures)


def _programs(found: Commissioning, model: CadModel, proof: Proof | None) -> Section:
    rows = [
        (name, str(len(program.plan.strokes)), str(program.plan.points), str(program.plan.trimmed_points),
         f"{1000.0 * program.proof.max_contact_mm:.4f} µm")
        for name, program in found.programs.items()
    ]  # fmt: skip
    table = Table(("program", "strokes", "contact points", "left out", "largest deviation read back"), rows,
                  "Each program file was read back and its contact points computed again.")  # fmt: skip
    strokes = [
        (stroke.nominal_work_from_contact[:, :3, 3], stroke.work_from_contact[:, :3, 3])
        for program in found.programs.values() for stroke in program.plan.strokes
    ]  # fmt: skip
    pictures = [Figure(scenes.path_before_and_after(model, strokes),
                       "Contact paths on the blade: nominal (orange) and compensated (blue).")]
    text = ""
    if proof is not None:
        text = (
            f"In the simulated cell the wheel's true normal error along the paths, between the probed points too, is "
            f"{proof.nominal_rms_mm:.3f} mm RMS on the nominal path and {proof.compensated_rms_mm:.4f} mm RMS "
            f"(worst {proof.compensated_worst_mm:.3f} mm) on the compensated one."
        )
        lines = {
            name: [(stroke.u if name == "transverse" else stroke.v, stroke.nominal_mm, stroke.compensated_mm)
                   for stroke in part]
            for name, part in proof.strokes.items()
        }  # fmt: skip
        across = {"transverse": "u, around the profile", "longitudinal": "v, along the span"}
        pictures.append(Figure(figures.before_and_after(lines, across),
                               "True normal error along every stroke, before and after compensation."))
    return Section("Paths and robot programs", text, tables=[table], figures=pictures)


def _facts(rows: Sequence[tuple[str, str, str]]) -> Table:
    return Table(("quantity", "value", "remark"), rows)


def _held_row(held: HeldOut) -> tuple[str, str, str]:
    return (f"held out: {held.what}, RMS", _um(held.rms_mm),
            f"{len(held.errors_mm)} observations, limit {_um(held.limit_mm)}")


def _pose_rows(what: str, pose: Array) -> list[tuple[str, str, str]]:
    angles = np.degrees(euler_zyx_from_rotation(pose[:3, :3]))
    text = "(" + ", ".join(f"{angle:.4f}" for angle in angles) + ") °"
    return [(f"{what}, translation", vector_text(pose[:3, 3]), "x, y, z"),
            (f"{what}, Euler angles", text, "alpha, beta, gamma of Rz Ry Rx")]


def _um(value_mm: float) -> str:
    return f"{_plain_um(value_mm)} µm" if np.isfinite(value_mm) else "–"


def _plain_um(value_mm: float) -> str:
    return f"{1000.0 * float(value_mm):.1f}" if np.isfinite(value_mm) else "–"


def _signed_um(value_mm: float, digits: int) -> str:
    return f"{1000.0 * value_mm:+.{digits}f}" if np.isfinite(value_mm) else "–"
