"""What the rough and the fine step show alike: the CAD model, the scans on it, what each face says."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from beltgui.session import Sample
from beltgui.steps.fine.step import ScanShare
from beltgui.steps.room import Bench
from beltgui.steps.scans import KIND, missing_slots, scan_of
from beltgui.steps.views import common, drawing
from beltgui.viewmodel.plot import Bars, Curve, Plot
from beltgui.viewmodel.scene import Item, Mesh, Points, Role
from beltgui.viewmodel.step import Check, Column, Number, SampleRow, Use
from core.ball import StageFit
from core.fine import FaceResult, FineFit, FineLimits, half_split_limit_mm
from core.frames import Array, PoseCovariance, inverse, transform_points

FACE_ROLES = tuple(Role(f"face {number}") for number in range(8))
SCAN_COLUMNS = (
    Column("points", "Points", "", 0),
    Column("on_faces", "On the faces", "", 0),
    Column("mean", "Mean", "µm", 1),
    Column("rms", "RMS", "µm", 1),
)
# A scene of at most 60 000 points: that many of the scans, the rest for the model.
SHOWN_POINTS, MESH_VERTICES = 40_000, 15_000
_DEFLECTIONS_MM = (0.05, 0.1, 0.3, 1.0)
MOST_FACE_CHECKS = 8
ENDS = ("lower end", "middle", "upper end")


# ---- the CAD model


@dataclass(frozen=True, eq=False)
class _Net:
    vertices: Array
    triangles: NDArray[np.int32]
    face_id: NDArray[np.int32]


def cad_mesh(
    bench: Bench, name: str, *, scene_from_work: Array | None = None, opacity: float = 1.0,
    chosen: Sequence[int] = (), pickable: bool = False, wireframe: bool = False,
) -> Mesh:  # fmt: skip
    """The CAD model's triangles with the face that each is of, in {W} or carried elsewhere."""
    net = _net(bench)
    vertices = net.vertices if scene_from_work is None else transform_points(scene_from_work, net.vertices)
    return Mesh(
        name, drawing.display(vertices), net.triangles, Role.BLADE, opacity, face_id=net.face_id,
        chosen_faces=tuple(chosen), pickable=pickable, wireframe=wireframe,
    )  # fmt: skip


def _net(bench: Bench) -> _Net:
    key = ("blade", "mesh")
    if key not in bench.cache:
        for deflection in _DEFLECTIONS_MM:
            mesh = bench.model.tessellate(deflection)
            if len(mesh.vertices) <= MESH_VERTICES:
                break
        bench.cache[key] = _Net(mesh.vertices, mesh.triangles.astype(np.int32), mesh.face_ids.astype(np.int32))
    found: _Net = bench.cache[key]
    return found


def face_label(bench: Bench, face_id: int) -> str:
    """The face's name in the file, else its number."""
    return bench.model.face(face_id).label


# ---- the scans


@dataclass(frozen=True, eq=False)
class ShownScan:
    """A scan thinned for display.

    Attributes:
        sample: Its sample.
        count: Points of the whole scan.
        in_measure: (n, 3) some of them in {M}; none without a result of the ball step.
    """

    sample: Sample
    count: int
    in_measure: Array


def shown_scans(bench: Bench, step: str) -> tuple[ShownScan, ...]:
    """The scans of a step that are not deleted; read once and then kept thinned."""
    samples = bench.session.samples(step, KIND)
    ball = bench.found.get("ball")
    stage: StageFit | None = None if ball is None else ball.stage
    most = SHOWN_POINTS // max(len(bench.plan.fine_step), 1)
    return tuple(_shown(bench, sample, stage, most) for sample in samples)


def _shown(bench: Bench, sample: Sample, stage: StageFit | None, most: int) -> ShownScan:
    key = ("blade", "shown", sample.id)
    if key not in bench.cache:
        scan = scan_of(bench.session, sample)
        some = scan.points_in_scanner[drawing.thin_index(len(scan.points_in_scanner), most)]
        bench.cache[key] = (len(scan.points_in_scanner), some, scan.stage_mm, scan.stage.theta_rad)
    count, some, stage_mm, stage_rad = bench.cache[key]
    if stage is None:
        return ShownScan(sample, count, np.zeros((0, 3)))
    return ShownScan(sample, count, transform_points(stage.measure_from_scanner_at(stage_mm, stage_rad), some))


def scan_rows(scans: Sequence[ShownScan], shares: Sequence[ScanShare]) -> tuple[SampleRow, ...]:
    """One row for each scan, with what it says of the faces."""
    by_name = {share.name: share for share in shares}
    rows = []
    for scan in scans:
        included = scan.sample.included
        share = by_name.get(scan.sample.data["name"]) if included else None
        cells: tuple[float | str | None, ...] = (float(scan.count), None, None, None)
        if share is not None:
            cells = (cells[0], float(share.on_faces), common.in_um(share.mean_mm), common.in_um(share.rms_mm))
        rows.append(SampleRow(scan.sample.id, scan.sample.data["name"], cells, Use.FIT if included else Use.EXCLUDED,
                              included))
    return tuple(rows)


def scans_progress(bench: Bench, step: str) -> tuple[str, bool]:
    """`1 of 2 scans`, and whether all are there."""
    planned = len(bench.plan.fine_step)
    missing = len(missing_slots(bench.session, step, planned))
    return common.progress_text(planned - missing, planned, "scans"), missing == 0


def scan_items(scans: Sequence[ShownScan], scene_from_measure: Array, *, pickable: bool = False) -> list[Item]:
    """The scans as they are, those left out in another role."""
    items: list[Item] = []
    for used, name, role in ((True, "scan", Role.SCAN), (False, "scan left out", Role.EXCLUDED)):
        parts = [scan.in_measure for scan in scans if scan.sample.included is used and len(scan.in_measure)]
        if parts:
            points = transform_points(scene_from_measure, np.concatenate(parts))
            items.append(Points(name, drawing.display(points), role, pickable=pickable and used))
    return items


def planned_items(bench: Bench) -> list[Item]:
    """What is going to be scanned, in {M} as the drawings say: the blade, and the scanner's volume at each place."""
    items: list[Item] = [cad_mesh(bench, "blade as planned", scene_from_work=planned_pose(bench), opacity=0.6)]
    items += [
        drawing.scanner_volume(f"scanner, {name}", scanner, bench.plan.scanner)
        for name, scanner in _scanners(bench).items()
    ]
    return items


def planned_pose(bench: Bench) -> Array:
    """measure_from_work (4, 4) as the drawings say."""
    in_base = bench.plan.fine_step[0].base_from_flange @ bench.blade.flange_from_work
    return np.asarray(inverse(bench.plan.base_from_measure) @ in_base)


def _scanners(bench: Bench) -> dict[str, Array]:
    """measure_from_scanner (4, 4) of each planned scan by name; none without a result of the ball step."""
    ball = bench.found.get("ball")
    if ball is None:
        return {}
    return {
        pose.name: ball.stage.measure_from_scanner_at(
            np.array([pose.stage.x_mm, pose.stage.y_mm, pose.stage.z_mm]), pose.stage.theta_rad
        )
        for pose in bench.plan.fine_step
    }


def seen_from(bench: Bench, measure_from_work: Array) -> Array:
    """(3,) unit, {W}: where the scanner stands, as seen from the blade; by the drawings before the ball step."""
    scanners = list(_scanners(bench).values()) or [np.eye(4)]
    toward = -np.mean([pose[:3, 2] for pose in scanners], axis=0)
    in_work = measure_from_work[:3, :3].T @ toward
    return np.asarray(in_work / np.linalg.norm(in_work))


def lying(look_from: Array) -> Array:
    """(3,) {W}: what must be up so that the blade lies across the picture, its z axis to the right."""
    return np.cross(look_from, [0.0, 0.0, 1.0])


# ---- numbers and checks


def pose_numbers(label: str, pose: Array, covariance: PoseCovariance, *, main: bool = False) -> tuple[Number, ...]:
    """Translation in mm and ZYX angles in degrees of `a_from_b`, each with ± from its covariance in {a}."""
    at_origin = covariance.moved_to(pose[:3, 3]).matrix
    return (
        *common.position_numbers(label, pose[:3, 3], at_origin[3:, 3:], main=main),
        *common.euler_numbers(label, pose[:3, :3], at_origin[:3, :3]),
    )


def quality_numbers(fit: FineFit, limits: FineLimits) -> tuple[Number, ...]:
    """How well the faces hold the blade, and how close the scan is to them; µm, k = 2."""
    ends = tuple(
        common.number_of(
            f"Uncertainty of the {end} (z = {point[2]:.0f} mm in {{W}}), k = 2",
            common.K * common.UM_PER_MM * float(sigma), "µm", decimals=1,
            limit=common.K * common.UM_PER_MM * limits.point_sigma_mm, main=end != ENDS[1],
        )
        for end, point, sigma in zip(ENDS, fit.ends_in_work_mm, fit.point_sigma_mm, strict=True)
    )  # fmt: skip
    return (
        common.number_of("RMS distance of the scan from the faces", common.in_um(fit.rms_mm), "µm", decimals=1,
                         limit=common.in_um(limits.rms_mm), main=True),
        *ends,
        common.number_of("Scatter of a point (1 sigma)", common.in_um(fit.sigma_mm), "µm", decimals=1),
        common.number_of("Points used", float(fit.points_used), "", decimals=0),
        common.number_of("Condition of the faces", fit.conditioning.condition, "", decimals=1, limit=limits.condition),
    )


def fit_checks(fit: FineFit, limits: FineLimits) -> tuple[Check, ...]:
    """Two halves of the data against each other, and each face by the pose of the others; µm."""
    halves = common.limit_check(
        "Largest distance between the poses of two halves of the scan, at both ends and in the middle",
        common.in_um(float(fit.half_split_mm.max())), common.UM_PER_MM * half_split_limit_mm(fit, limits), "µm",
        len(fit.half_split_mm),
    )  # fmt: skip
    known = [face for face in fit.faces if face.used and np.isfinite(face.held_out_mm)]
    if len(known) > MOST_FACE_CHECKS:
        known = [max(known, key=lambda face: abs(face.held_out_mm))]
    faces = tuple(
        common.limit_check(
            f"Mean distance of {_label(face)} from where the other faces put it",
            common.in_um(abs(face.held_out_mm)), common.UM_PER_MM * limits.held_out_mm, "µm", face.points,
        )
        for face in known
    )  # fmt: skip
    return (halves, *faces)


def _label(face: FaceResult) -> str:
    return face.name or f"face {face.id}"


# ---- plots


def face_roles(face_ids: Sequence[int]) -> dict[int, Role]:
    """Roles that tell chosen faces apart, in the order of their ids."""
    return {face: FACE_ROLES[k % len(FACE_ROLES)] for k, face in enumerate(sorted(face_ids))}


def face_plots(fit: FineFit) -> tuple[Plot, ...]:
    """Histogram of the distances, means of the faces, and the two halves; all in µm."""
    used = [face for face in fit.faces if face.used]
    roles = face_roles([face.id for face in fit.faces])
    edges = common.UM_PER_MM * fit.bins_mm
    middles = 0.5 * (edges[:-1] + edges[1:])
    counts = [np.array(face.counts, dtype=float) for face in used]
    together = np.sum(counts, axis=0) if counts else np.zeros(len(middles))
    histogram = Plot(
        "residuals", "Distances", "signed distance from the face, µm", "points",
        (Bars(middles, together, Role.MUTED, "all faces", width=1.0),
         *(Curve(middles, count, roles[face.id], _label(face)) for face, count in zip(used, counts, strict=True))),
    )  # fmt: skip
    places, labels = np.arange(len(used), dtype=float), tuple(_label(face) for face in used)
    by_others = np.array([face.held_out_mm for face in used], dtype=float)
    known = np.isfinite(by_others)
    means = Plot(
        "faces", "Faces", "face", "mean signed distance, µm",
        (Bars(places - 0.2, common.UM_PER_MM * np.array([face.mean_mm for face in used]), Role.FIT, "in the fit",
              labels, 0.4),
         Bars(places[known] + 0.2, common.UM_PER_MM * by_others[known], Role.HELD_OUT, "by the other faces",
              tuple(label for label, there in zip(labels, known, strict=True) if there), 0.4)),
    )  # fmt: skip
    ends = np.arange(len(ENDS), dtype=float)
    halves = Plot(
        "halves", "Two halves", "place on the blade", "µm",
        (Bars(ends - 0.2, common.UM_PER_MM * fit.half_split_mm, Role.HELD_OUT, "two halves apart", ENDS, 0.4),
         Bars(ends + 0.2, common.K * common.UM_PER_MM * fit.point_sigma_mm, Role.FIT, "uncertainty, k = 2", ENDS, 0.4)),
    )  # fmt: skip
    return histogram, means, halves
