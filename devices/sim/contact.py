"""Where the floating head comes to rest: the angle at which the wheel just touches the true airfoil.

The wheel is a torus about its shaft (the crowned contact wheel), so the signed distance of a point to it is known in
closed form, and the touch is a root of (distance, its two derivatives along the airfoil) in (u, v, head angle).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from devices.sim.airfoil import TrueAirfoil
from devices.sim.geometry import Array, turn

_COARSE_U, _COARSE_V = 4, 8  # every how many grid lines of the airfoil the coarse search looks
_PENETRATION_MM = 0.02  # a coarse point this far inside the wheel means that Newton found another than the first touch


@dataclass(frozen=True, eq=False)
class Head:
    """A floating head in some frame.

    Attributes:
        axis_point: (3,) a point of the head axis, mm.
        axis: (3,) its direction, about which angles are positive; also the direction of the wheel's shaft.
        wheel_centre: (3,) at head angle 0.
        wheel_radius_mm: Largest radius.
        crown_radius_mm: Radius of the torus' tube.
        side: +1: a positive turn lifts the wheel off the blade, -1: a negative one.
    """

    axis_point: Array
    axis: Array
    wheel_centre: Array
    wheel_radius_mm: float
    crown_radius_mm: float
    side: int

    def centre_at(self, angle_rad: float) -> Array:
        """(3,) wheel centre at a head angle."""
        return np.asarray(self.axis_point + turn(self.axis * angle_rad) @ (self.wheel_centre - self.axis_point))

    def distances(self, points: Array, angle_rad: float) -> Array:
        """Signed distances (...,) of points (..., 3) to the wheel at a head angle; negative inside."""
        offset = points - self.centre_at(angle_rad)
        along = offset @ self.axis
        squared = np.einsum("...i,...i", offset, offset)
        radial = np.sqrt(np.maximum(squared - along**2, 0.0)) - (self.wheel_radius_mm - self.crown_radius_mm)
        return np.asarray(np.hypot(radial, along) - self.crown_radius_mm)


@dataclass(frozen=True)
class Contact:
    """The wheel touching the airfoil.

    Attributes:
        angle_rad: Head angle.
        u: Airfoil parameter of the touching point.
        v: Airfoil parameter of the touching point.
    """

    angle_rad: float
    u: float
    v: float


class ContactSolver:
    """Finds the first touch of a wheel that its spring presses towards the airfoil."""

    def __init__(self, airfoil: TrueAirfoil) -> None:
        self._airfoil = airfoil
        self._coarse = airfoil.points[::_COARSE_U, ::_COARSE_V].reshape(-1, 3)
        u, v = np.meshgrid(airfoil.u[::_COARSE_U], airfoil.v[::_COARSE_V], indexing="ij")
        self._coarse_uv = np.stack([u.ravel(), v.ravel()], axis=1)

    def solve(self, head: Head, low_rad: float, high_rad: float) -> Contact | None:
        """The touch within the head's travel; the head is given in {W}.

        Returns:
            The contact, or None where the airfoil is out of the wheel's reach.
        """
        angle = 0.0
        for _ in range(4):
            nearest = int(np.argmin(head.distances(self._coarse, angle)))
            u, v = self._coarse_uv[nearest]
            contact = self._newton(head, Contact(angle, float(u), float(v)))
            if contact is None:
                break
            if head.distances(self._coarse, contact.angle_rad).min() > -_PENETRATION_MM:
                return contact if low_rad <= contact.angle_rad <= high_rad else None
            angle = contact.angle_rad
        contact = self._sweep(head, low_rad, high_rad)
        return contact if contact is None or low_rad <= contact.angle_rad <= high_rad else None

    def _sweep(self, head: Head, low_rad: float, high_rad: float) -> Contact | None:
        """First touch by coming in from the lifted end, for where Newton's start was no good."""
        outside = high_rad if head.side > 0 else low_rad
        inside = low_rad if head.side > 0 else high_rad
        previous = outside
        for angle in np.linspace(outside, inside, 121):
            if head.distances(self._coarse, float(angle)).min() < 0.0:
                break
            previous = float(angle)
        else:
            return None
        nearest = int(np.argmin(head.distances(self._coarse, previous)))
        u, v = self._coarse_uv[nearest]
        return self._newton(head, Contact(previous, float(u), float(v)))

    def _newton(self, head: Head, start: Contact) -> Contact | None:
        u_low, u_high, v_low, v_high = self._airfoil.design.domain
        span_u, span_v = u_high - u_low, v_high - v_low
        angle, u, v = start.angle_rad, start.u, start.v
        tube = head.wheel_radius_mm - head.crown_radius_mm
        for _ in range(30):
            point, du, dv, duu, duv, dvv = self._airfoil.jet(u, v)
            centre = head.centre_at(angle)
            way = np.array(_cross(head.axis, centre - head.axis_point))
            offset = point - centre
            along = float(offset @ head.axis)
            out = offset - along * head.axis
            radius = float(np.sqrt(out @ out))
            out = out / radius
            across = radius - tube
            reach = float(np.hypot(across, along))
            normal = (across * out + along * head.axis) / reach
            tangent = (across * head.axis - along * out) / reach
            hoop = np.array(_cross(head.axis, out))
            directions = np.stack([du, dv, -way])
            slopes, bends, hoops = directions @ normal, directions @ tangent, directions @ hoop
            hessian = np.outer(bends, bends) / reach + np.outer(hoops, hoops) * float(normal @ out) / radius
            hessian[0, 0] += duu @ normal
            hessian[0, 1] += duv @ normal
            hessian[1, 0] += duv @ normal
            hessian[1, 1] += dvv @ normal
            residual = np.array([reach - head.crown_radius_mm, slopes[0], slopes[1]])
            jacobian = np.vstack([slopes, hessian[0], hessian[1]])
            step = np.linalg.solve(jacobian, -residual)
            shrink = min(1.0, 0.05 * span_u / (abs(step[0]) + 1e-300), 0.1 * span_v / (abs(step[1]) + 1e-300))
            shrink = min(shrink, 0.05 / (abs(step[2]) + 1e-300))
            u, v, angle = u + shrink * step[0], v + shrink * step[1], angle + shrink * step[2]
            if not (u_low <= u <= u_high and v_low <= v <= v_high):
                return None
            if shrink == 1.0 and abs(step[2]) < 1e-11 and abs(step[0]) < 1e-9 * span_u and abs(step[1]) < 1e-9 * span_v:
                return Contact(float(angle), float(u), float(v))
        return None


def _cross(a: Array, b: Array) -> tuple[float, float, float]:
    # numpy's cross costs ten times as much for one pair of vectors
    return (
        float(a[1] * b[2] - a[2] * b[1]),
        float(a[2] * b[0] - a[0] * b[2]),
        float(a[0] * b[1] - a[1] * b[0]),
    )
