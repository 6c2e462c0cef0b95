"""Forces a task asks for: along what, the equilibrium that presses with them, and what a run made of them.

The law holds K (x_e - x) = F where the tool rests, K in world axes. On its path p it presses with F u where the
equilibrium is at x_e = p + K^-1 F u, however K and u are turned; on a surface that gives by F / k, by that much deeper.
With a lead it also runs ahead by (D p' + M p'' + friction) / K, so that the tool does not lag: on a curve it would
press elsewhere, and harder. Between two poses the force goes over from the one's to the other's with the way; where the
tool comes down at a pose with a dwell, smoothly while it stands.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.controller.lag import nearest_rows
from trajopt_cli.iiwa.job.folder import Opened
from trajopt_cli.iiwa.task.equilibrium import Equilibrium, Piece
from trajopt_cli.iiwa.task.legs import SAME
from trajopt_cli.iiwa.task.model import Force, PathPoints, Profile, Task
from trajopt_cli.iiwa.world.contact import FRICTION_RISE, BallOnBoxes
from trajopt_cli.units import MM

_JUMP = 1e-3  # m from row to row: no way to press harder, but a blow
_UPRIGHT = 0.1  # of the tool's axis that has to stand across the path for it to have a normal there


@dataclass(frozen=True, eq=False)
class Pressing:
    """Forces along a path of n rows: wish (n,) [N], along u (n, 3) in the world. pieces: which of the path's are
    pressed from end to end."""

    wish: Array
    u: Array
    pieces: tuple[Piece, ...]

    @property
    def wrench(self) -> Array:
        """The force as the tool's on what it touches (n, 6) [N, Nm]."""
        return np.column_stack([self.wish[:, None] * self.u, np.zeros((len(self.wish), 3))])


@of_kind(ErrorKind.PROGRAM)
def pressing(task: Task, path: Equilibrium, R_start: Array) -> Pressing | None:
    """What a task presses with along its path, None where it asks for nothing.

    R_start (3, 3): as of Equilibrium.rotations. Raises InputError for a normal where the tool's axis lies along the
    path, and for changes of stiffness or frames in the course of the run.
    """
    ends = list(_ends(task))
    if not (places := [force.place for pair in ends for force in pair if force]):
        return None
    place = places[0]
    if len(ends) != len(path.pieces):
        raise InputError("force: the sequence has other segments than the task; make it anew", file=place)
    if any((one.compliance, one.X_FT, one.X_WB) != (None, None, None) for one in task.changes):
        raise InputError("force: needs one stiffness and one tool; take K, tool and base out of 'changes'", file=place)
    p, z = path.pose[:, :3], path.rotations(R_start)[:, :, 2]
    wish, u = np.zeros(len(p)), z.copy()
    both = list(zip(path.pieces, ends, strict=True))
    open_ended: list[Piece] = []  # whose normal is that of the piece behind
    for piece, (before, after) in both:
        rows = slice(piece.first, piece.last + 1)
        way = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(p[rows], axis=0), axis=1))]
        s = np.linspace(0.0, 1.0, len(way))
        share = way / way[-1] if way[-1] > SAME else s * s * (3 - 2 * s)
        values = [0.0 if one is None else one.value for one in (before, after)]
        wish[rows] = values[0] + share * (values[1] - values[0])
        force = after or before
        if force is None or force.along == "tool":
            continue
        if force.along != "normal":
            u[rows] = np.eye(3)["xyz".index(force.along[-1])] * (-1.0 if force.along[0] == "-" else 1.0)
        elif before and after and way[-1] > SAME:
            u[rows] = _normals(p[rows], z[rows], force.place)
        elif before and not (open_ended and open_ended[-1].last == piece.first):
            u[rows] = u[piece.first]
        else:
            open_ended.append(piece)
    for piece in reversed(open_ended):
        u[piece.first : piece.last + 1] = u[min(piece.last + 1, len(u) - 1)]
    return Pressing(wish, u, tuple(piece for piece, (before, after) in both if before and after))


def _ends(task: Task) -> Iterator[tuple[Force | None, Force | None]]:
    """The forces at both ends of every piece of the sequence."""
    waypoints, numbers, before = task.route.waypoints, task.route.stops, None
    stops = [waypoints[i] for i in numbers]
    for first, goal in pairwise(numbers) if not isinstance(waypoints, PathPoints) else ():
        wanted = waypoints[goal].force
        for one in waypoints[first + 1 : goal]:
            if one.force is not None and (wanted is None or one.force.value != wanted.value):
                message = (
                    f"force: pose {one.name} is passed, and presses as pose {waypoints[goal].name} does; stop there"
                )
                raise InputError(f"{message}, or give both the same", file=one.place)
    if stops[0].dwell > 0:
        yield None, None
    for here, there in pairwise(stops):
        if task.route.passing is not None or np.abs(there.pose - here.pose).max() > SAME:
            force = None if before is None and there.dwell > 0 else there.force
            yield before, force
            before = force
        if there.dwell > 0:
            yield before, there.force
            before = there.force


def _normals(p: Array, z: Array, place: str) -> Array:
    """Across the path p (n, 3), nearest to the tool's axes z (n, 3): unit vectors (n, 3)."""
    t = np.gradient(p, axis=0)
    t /= np.maximum(np.linalg.norm(t, axis=1), 1e-300)[:, None]
    across = z - np.sum(z * t, axis=1)[:, None] * t
    size = np.linalg.norm(across, axis=1)
    if size.min() < _UPRIGHT:
        raise InputError("force: the tool's axis lies along the path, so there is no normal; name an axis", file=place)
    return np.asarray(across / size[:, None])


@of_kind(ErrorKind.PROGRAM)
def pressed(opened: Opened, path: Equilibrium) -> Opened:
    """The same where its equilibrium presses as the task asks: path becomes the plan, and the equilibrium is moved.

    Raises InputError as pressing, for no stiffness along a force, and for a force that comes at once.
    """
    task, R_start = opened.task, opened.X_start[:3, :3]
    found = pressing(task, path, R_start)
    if found is None:
        return opened
    F, K = found.wrench[:, :3], task.compliance.K[:3]
    offset, push = np.zeros_like(F), np.zeros_like(F)
    if task.lead:
        if task.route.profile is not Profile.S_CURVE or task.impedance is not None or task.follows:
            message = "force.lead: is for the admittance controller fed positions, with 'profile: s-curve'"
            raise InputError(f"{message}; take it out", file=task.file)
        v = np.diff(path.pose[:, :3], axis=0, append=path.pose[-1:, :3]) / path.h
        a = np.diff(v, axis=0, append=v[-1:]) / path.h
        push = task.compliance.D[:3] * v + task.compliance.M[:3] * a
    if task.contact is not None:
        balls = BallOnBoxes(task.contact)
        for piece in path.pieces:
            x, y, z = path.pose[piece.last, :3].tolist()
            one, rows = balls.nearest((x, y, z)), slice(piece.first + 1, piece.last + 1)
            offset[rows] += F[rows] / one.stiffness
            if task.lead:
                speed = np.linalg.norm(v[rows], axis=1)
                rub = one.friction * found.wish[rows] / np.maximum(speed, SAME)
                push[rows] += np.minimum(rub, FRICTION_RISE)[:, None] * v[rows]
    if not task.wrench:
        push += F
    if np.any(np.abs(push[:, K == 0]) > SAME):
        raise InputError("force: K is 0 along it; give a stiffness, or 'force: {by: wrench}'", file=task.file)
    offset += push / np.where(K == 0, 1.0, K)
    jump = np.linalg.norm(np.diff(F, axis=0) / np.where(K == 0, np.inf, K), axis=1)
    if jump.max() > _JUMP:
        at, size = path.h * int(np.argmax(jump)), 1e3 * float(jump.max())
        message = f"force: the equilibrium would jump by {size:.3g} mm at {at:.3f} s, where its direction or its value"
        raise InputError(f"{message} changes without a way; name an axis, or give the pose a dwell", file=task.file)
    moved = opened.equilibrium.pose.copy()
    moved[1:, :3] += offset[1:]  # it begins where the tool is
    return replace(opened, equilibrium=replace(opened.equilibrium, pose=moved), plan=path)


def force_notes(opened: Opened) -> tuple[str, ...]:
    """What a user should know of the forces in a sequence, one line each."""
    path = opened.plan
    found = None if path is None else pressing(opened.task, path, opened.X_start[:3, :3])
    if path is None or found is None:
        return ()
    off = float(np.linalg.norm((opened.equilibrium.pose - path.pose)[:, :3], axis=1).max())
    on = np.flatnonzero(found.wish > 0)
    K = float(np.max(np.abs(found.u[on] * opened.task.compliance.K[:3])))
    lines = [
        f"force: up to {found.wish.max():g} N from {on[0] * path.h:.3f} to {on[-1] * path.h:.3f} s; equilibrium.csv is"
        f" up to {off / MM:.3g} mm off plan.csv; a surface 1 mm off its place changes the force by {K * MM:.3g} N"
    ]
    before = 0.0
    for piece in path.pieces:
        after = float(found.wish[piece.last])
        if after > 0 and before == 0 and not piece.dwell:
            lines.append(
                f"the force comes while the tool moves to pose {piece.goal}, which it hits; to touch first and then"
                " press give that pose a 'dwell' (a path in a file: 'force: {settle: 0.5 s}')"
            )
        before = after
    if before > 0:
        lines.append(
            f"the sequence ends pressing, at pose {path.pieces[-1].goal}; a pose above, without a force, lifts off"
        )
    return tuple(lines)


def force_along(found: Pressing, path: Equilibrium, tool: Array, contact: Array) -> Array:
    """How hard the tool presses (n,) [N] at every row of a run.

    tool, contact (n, 3): where the tool was, and the world's force on it. Counted along the direction of the place of
    the path that the tool is nearest to, within the piece of that time.
    """
    u = found.u[np.minimum(np.arange(len(tool)), len(found.u) - 1)].copy()
    for piece in found.pieces:
        rows, span = slice(piece.first, piece.last + 1), path.pose[piece.first : piece.last + 1, :3]
        if piece.first < len(tool):
            u[rows] = found.u[piece.first + nearest_rows(span, tool[rows])]
    return np.asarray(-np.sum(contact * u, axis=1))


def force_records(found: Pressing, h: float, force: Array) -> list[dict[str, Any]]:
    """Per pressed piece: the wish, the tool's force along it as of force_along (least, mean, most) [N], and the largest
    error as a share of the wish."""
    out = []
    for piece in found.pieces:
        there = force[piece.first : piece.last + 1]
        if len(there):
            wish = found.wish[piece.first : piece.first + len(there)]
            out.append(
                {
                    "from": piece.origin,
                    "to": piece.goal,
                    "start_s": piece.first * h,
                    "end_s": piece.last * h,
                    "wish_N": float(wish.mean()),
                    "least_N": float(there.min()),
                    "mean_N": float(there.mean()),
                    "most_N": float(there.max()),
                    "largest_error": float(np.max(np.abs(there - wish) / np.maximum(wish, SAME))),
                }
            )
    return out
