"""Simulated structured-light scanner: perspective rays, shadows of its projector, noise, edge ghosts, drop-outs."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from devices.interfaces.errors import DeadlineExceeded
from devices.interfaces.limits import Limit
from devices.interfaces.scanner import Scan
from devices.sim.geometry import Array, apply, inverse
from devices.sim.rays import Hits, RayScene
from devices.sim.settings import ScannerTruth
from devices.sim.world import World

_NAME = "scanner"
_BALL_FACE = -2
_GRAZING = 0.15  # smallest cosine that noise grows with


class SimulatedScanner:
    """The scanner of a simulated cell (a `Scanner`).

    Attributes:
        stride: Every how many pixels in both directions a ray is cast; 1 is the full 3 million points.
    """

    def __init__(self, world: World, stride: int) -> None:
        if stride < 1:
            raise ValueError(f"The scanner's stride must be 1 or more, found {stride}.")
        self._world = world
        self.stride = stride

    @property
    def limits(self) -> tuple[Limit, ...]:
        """The measuring volume."""
        plan = self._world.plan.scanner
        width, height = plan.field_mm
        return (
            Limit("distance from the scanner", plan.near_mm, plan.far_mm, "mm"),
            Limit(f"x at {plan.working_distance_mm:g} mm", -width / 2, width / 2, "mm"),
            Limit(f"y at {plan.working_distance_mm:g} mm", -height / 2, height / 2, "mm"),
        )

    def capture(self, *, deadline_s: float = 10.0) -> Scan:
        """Take one scan; organised (H, W, 3), see `Scanner.capture`."""
        world, settings = self._world, self._world.settings.scanner
        world.faults.check(_NAME)
        if settings.capture_s > deadline_s:
            world.clock.wait(deadline_s)
            raise DeadlineExceeded(_NAME, f"no complete scan arrived within {deadline_s:g} s. Try again.")
        world.clock.wait(settings.capture_s)
        points, _ = self.observe()
        return Scan(points, world.clock.now_s())

    def observe(self) -> tuple[NDArray[np.float32], NDArray[np.intp]]:
        """What the scanner would see now, with the truth that no real scanner tells.

        Returns:
            Points (H, W, 3) float32 in {S}, NaN = nothing, and for each pixel (H, W) the face of the blade's solid
            (in file order from 0), -2 the ball, -3 the fixture, -1 nothing.
        """
        world, rng = self._world, self._world.rng(_NAME)
        directions = self._directions()
        shape = directions.shape[:2]
        rays = directions.reshape(-1, 3)
        distance, normal, face = self._cast(rays)
        seen = np.isfinite(distance)
        cosine = np.abs(np.einsum("ij,ij->i", rays, normal))
        distance[~seen] = np.nan
        depth = distance * rays[:, 2]
        plan, settings = world.plan.scanner, world.settings.scanner
        seen &= (depth >= plan.near_mm) & (depth <= plan.far_mm)
        spread = settings.noise_mm * (1.0 + settings.noise_growth * (1.0 / np.maximum(cosine, _GRAZING) - 1.0))
        noise = (rng.standard_normal(len(rays)) * spread).reshape(shape)
        image = _with_ghosts(distance.reshape(shape), settings, rng) + noise
        keep = ~_dropped(cosine.reshape(shape), settings, rng, self._pixel_mm())
        points = np.where((seen.reshape(shape) & keep)[..., None], image[..., None] * directions, np.nan)
        face = np.where(np.isfinite(points[..., 0]), face.reshape(shape), -1)
        return points.astype(np.float32), face

    def _pixel_mm(self) -> float:
        return self._world.plan.scanner.spacing_mm * self.stride

    def _directions(self) -> Array:
        """(H, W, 3) unit rays in {S}."""
        plan = self._world.plan.scanner
        width, height = plan.field_mm
        x = np.arange(-width / 2, width / 2 + 1e-9, self._pixel_mm())
        y = np.arange(-height / 2, height / 2 + 1e-9, self._pixel_mm())
        grid = np.empty((len(y), len(x), 3))
        grid[..., 0], grid[..., 1], grid[..., 2] = x[None, :], y[:, None], plan.working_distance_mm
        return np.asarray(grid / np.linalg.norm(grid, axis=2, keepdims=True))

    def _cast(self, rays: Array) -> tuple[Array, Array, NDArray[np.intp]]:
        """Nearest exact hit of each ray and its normal in {S}; what the projector cannot light is not hit."""
        world = self._world
        scanner_from_flange = inverse(world.base_from_scanner()) @ world.true_flange()
        scenes = [(world.mounted.scene, scanner_from_flange, -3)]
        if world.mounted.item == "blade":
            scenes.append((world.blade.scene, scanner_from_flange @ world.flange_from_work, 0))
        distance, normal = np.full(len(rays), np.inf), np.zeros((len(rays), 3))
        face = np.full(len(rays), -1, dtype=np.intp)
        for scene, scanner_from_scene, label in scenes:
            rows, hits = _cast_scene(scene, scanner_from_scene, rays)
            nearer = hits.distance_mm < distance[rows]
            chosen = rows[nearer]
            distance[chosen] = hits.distance_mm[nearer]
            normal[chosen] = hits.normal[nearer]
            face[chosen] = hits.face[nearer] if label == 0 else label
        ball = None
        if world.mounted.item == "ball":
            ball = (apply(scanner_from_flange, world.ball_in_flange), world.plan.ball.diameter_mm / 2.0)
            _cast_ball(*ball, rays, distance, normal, face)
        self._shade(scenes, ball, rays, distance, normal, face)
        return distance, normal, face

    def _shade(
        self,
        scenes: list[tuple[RayScene, Array, int]],
        ball: tuple[Array, float] | None,
        rays: Array,
        distance: Array,
        normal: Array,
        face: NDArray[np.intp],
    ) -> None:
        projector = np.array(self._world.plan.scanner.baseline_mm)
        rows = np.flatnonzero(np.isfinite(distance))
        points = distance[rows, None] * rays[rows]
        dark = np.einsum("ij,ij->i", normal[rows], projector - points) <= 0.0
        for scene, scanner_from_scene, _ in scenes:
            lit = np.flatnonzero(~dark)
            scene_from_scanner = inverse(scanner_from_scene)
            turned = normal[rows[lit]] @ scene_from_scanner[:3, :3].T
            light = apply(scene_from_scanner, projector)
            dark[lit] = scene.blocked(apply(scene_from_scanner, points[lit]), turned, light)
        if ball is not None:
            lit = np.flatnonzero(~dark & (face[rows] != _BALL_FACE))
            way = projector - points[lit]
            offset = ball[0] - points[lit]
            share = np.clip(np.einsum("ij,ij->i", offset, way) / np.einsum("ij,ij->i", way, way), 0.0, 1.0)
            dark[lit] = np.linalg.norm(offset - share[:, None] * way, axis=1) < ball[1]
        distance[rows[dark]] = np.inf
        face[rows[dark]] = -1


def _cast_scene(scene: RayScene, scanner_from_scene: Array, rays: Array) -> tuple[NDArray[np.intp], Hits]:
    """Hits of the rays that can meet the scene at all: (row numbers, hits with normals in {S})."""
    centre, radius = scene.bounding_sphere()
    middle = apply(scanner_from_scene, centre)
    along = rays @ middle
    near = (middle @ middle - along**2 <= radius**2) | (middle @ middle <= radius**2)
    rows = np.flatnonzero(near & (along > -radius))
    scene_from_scanner = inverse(scanner_from_scene)
    turned = rays[rows] @ scene_from_scanner[:3, :3].T
    origins = np.broadcast_to(scene_from_scanner[:3, 3], turned.shape)
    hits = scene.cast(origins, turned)
    return rows, Hits(hits.distance_mm, hits.normal @ scanner_from_scene[:3, :3].T, hits.face)


def _cast_ball(
    centre: Array, radius: float, rays: Array, distance: Array, normal: Array, face: NDArray[np.intp]
) -> None:
    along = rays @ centre
    root = along**2 - centre @ centre + radius**2
    reach = along - np.sqrt(np.maximum(root, 0.0))
    rows = np.flatnonzero((root > 0.0) & (reach > 0.0) & (reach < distance))
    distance[rows] = reach[rows]
    normal[rows] = (reach[rows, None] * rays[rows] - centre) / radius
    face[rows] = _BALL_FACE


def _with_ghosts(image: Array, settings: ScannerTruth, rng: np.random.Generator) -> Array:
    """Mixed pixels: at a jump in depth some pixels show a distance in between, or float off an outer edge."""
    ghosted = image.copy()
    for axis in (0, 1):
        for shift in (-1, 1):
            other = np.roll(image, shift, axis=axis)
            border = [slice(None), slice(None)]
            border[axis] = slice(0, 1) if shift == 1 else slice(-1, None)
            other[tuple(border)] = image[tuple(border)]  # beyond the field nothing is known: no edge
            edge = np.isfinite(image) & ~(np.abs(other - image) <= settings.ghost_jump_mm)
            at = np.flatnonzero(edge)
            at = at[rng.uniform(size=len(at)) < settings.ghost_share]
            here, beside, weight = image.flat[at], other.flat[at], rng.uniform(1e-12, 1.0, size=len(at))
            floating = here - 0.3 * settings.ghost_jump_mm * np.log(weight)
            ghosted.flat[at] = np.where(np.isfinite(beside), weight * here + (1.0 - weight) * beside, floating)
    return ghosted


def _dropped(cosine: Array, settings: ScannerTruth, rng: np.random.Generator, pixel_mm: float) -> NDArray[np.bool_]:
    """Pixels without an answer: grazing light, chance, and a few patches of glare."""
    start, end = settings.dropout_start_deg, settings.dropout_end_deg
    grazing = np.clip((np.rad2deg(np.arccos(np.clip(cosine, 0.0, 1.0))) - start) / (end - start), 0.0, 1.0)
    dropped = rng.uniform(size=cosine.shape) < np.maximum(grazing, settings.random_dropout)
    rows, columns = np.arange(cosine.shape[0])[:, None], np.arange(cosine.shape[1])[None, :]
    for _ in range(rng.poisson(settings.patches)):
        middle = rng.uniform(size=2) * cosine.shape
        half = settings.patch_mm * rng.uniform(0.3, 1.0, size=2) / pixel_mm
        dropped |= ((rows - middle[0]) / half[0]) ** 2 + ((columns - middle[1]) / half[1]) ** 2 < 1.0
    return np.asarray(dropped)
