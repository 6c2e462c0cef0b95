"""Ramps of a log's motions by least squares: per motion the phases of its leading axis, per axis its servo's lag."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.measured.motions import Recorded
from trajopt_cli.measured.profile import GROWS, LEAST, boxes, progress, slopes

_LOCAL = 6  # per motion: begin, jerk phase, constant acceleration, cruise, where it starts, how far it goes
_LAG = np.array([0.03, 0.2])  # mean delay [s] and shape of servos, as far as known before: first guess and spread
_LAG_SPREAD = np.array([0.03, 0.25])
_MOST_LAG, _MOST_BETA = 0.2, 0.7


@dataclass(frozen=True, eq=False)
class Fitted:
    """Motions (m) that one axis leads.

    local (m, 6): begin [s], phases [s], where the axis starts and how far it goes. cov (3 m, 3 m): of the phases. lag:
    mean delay [s] and shape. rough (m,): rms of what is left, as a share of the way. residual, rate: row by row. wider:
    by how much cov was raised as what is left is more than noise, or alike from row to row.
    """

    local: Array
    cov: Array
    lag: tuple[float, float]
    rough: Array
    residual: tuple[Array, ...]
    rate: tuple[Array, ...]
    wider: float
    cost: float

    @property
    def phases(self) -> Array:
        """(m, 3) [s]."""
        return self.local[:, 1:4]


def guesses(motion: Recorded, axis: int) -> list[Array]:
    """Local parameters (6,) of a motion to start from, by when its leading axis has gone which share; none where it
    does not go one way."""
    t, q = motion.t, motion.q[:, axis]
    q_0, d = float(np.median(q[: max(motion.begin, 1)])), float(motion.way[axis])
    p = (q - q_0) / d
    if p.max() > 1.02 or p.min() < -0.02 or np.min(np.diff(p)) < -0.02:
        return []
    rising = np.maximum.accumulate(p) + 1e-9 * np.arange(len(p))
    at = np.interp([0.02, 0.25, 0.5, 0.75, 0.98], rising, t)
    total = float(at[4] - at[0]) * 1.06
    cruise = min(2 * float(at[3] - at[1]), total)  # T1 of a trapezoid that cruises that long
    ramp = max(total - cruise, 0.03)
    out = []
    for share in (0.05, 0.3):
        x = share * ramp
        z = max(cruise - ramp, 0.0)
        begin = float(at[2]) - (2 * ramp + z) / 2 - _LAG[0]
        out.append(np.array([begin, x, ramp - 2 * x, z, q_0, d]))
    return out


def fit(
    motions: Sequence[Recorded], axis: int, noise: float, jitter: float, starts: Sequence[Array],
    lag: tuple[float, float] = (float(_LAG[0]), float(_LAG[1])), jumps: bool = False,
) -> Fitted:  # fmt: skip
    """All motions that one axis leads, at once: the lag is theirs in common.

    noise: of a position. jitter [s]: of the clock, which counts as noise in proportion to the speed. starts: local
    parameters of each, begins by the log's clock; lag: to start from. jumps: accelerations jump, no jerk phases.
    """
    from scipy.optimize import least_squares

    m = len(motions)
    ends = np.cumsum([len(one.t) for one in motions])
    spans = [slice(int(e) - len(one.t), int(e)) for e, one in zip(ends, motions, strict=True)]
    zero = np.array([one.t[0] for one in motions])
    q = [one.q[:, axis] for one in motions]
    t = [one.t - one.t[0] for one in motions]
    start = np.concatenate([np.asarray(starts, float).ravel(), lag])
    start[: m * _LOCAL : _LOCAL] -= zero
    weights = []
    for i, one in enumerate(motions):
        rate = slopes(t[i] - start[i * _LOCAL], start[i * _LOCAL + 1 : i * _LOCAL + 4], *lag)[1]
        weights.append(1 / np.sqrt(noise**2 + (rate * one.way[axis] * jitter) ** 2))

    def residual(p: Array) -> Array:
        out = np.empty(ends[-1] + 2)
        for i, span in enumerate(spans):
            begin, *phases, q_0, d = p[i * _LOCAL : (i + 1) * _LOCAL]
            out[span] = weights[i] * (q_0 + d * progress(t[i] - begin, np.array(phases), p[-2], p[-1]) - q[i])
        out[ends[-1] :] = (p[-2:] - _LAG) / _LAG_SPREAD
        return out

    def jacobian(p: Array) -> Array:
        J = np.zeros((ends[-1] + 2, len(p)))
        for i, span in enumerate(spans):
            begin, *phases, _, d = p[i * _LOCAL : (i + 1) * _LOCAL]
            of = t[i] - begin, np.array(phases)
            s, rate, by_phase = slopes(*of, p[-2], p[-1])
            w, k = weights[i], i * _LOCAL
            J[span, k] = -w * d * rate
            J[span, k + 1 : k + 4] = (w * d)[:, None] * by_phase
            J[span, k + 4] = w
            J[span, k + 5] = w * s
            J[span, -2] = w * d * (progress(*of, p[-2] + 1e-6, p[-1]) - s) / 1e-6
            J[span, -1] = w * d * (progress(*of, p[-2], p[-1] + 1e-5) - s) / 1e-5
        J[[ends[-1], ends[-1] + 1], [-2, -1]] = 1 / _LAG_SPREAD
        return J

    low = np.concatenate([np.tile([-np.inf, LEAST, 0, 0, -np.inf, -np.inf], m), [2e-3, 0.0]])
    high = np.concatenate([np.full(m * _LOCAL, np.inf), [_MOST_LAG, _MOST_BETA]])
    if jumps:
        high[1 : m * _LOCAL : _LOCAL] = LEAST + 2e-6
    start = np.clip(start, low + 1e-6, high)
    most, ftol = (25, 1e-4) if m == 1 else (60, 1e-7)
    how = {"bounds": (low, high), "x_scale": "jac", "max_nfev": most, "ftol": ftol, "xtol": 1e-9, "gtol": 1e-12}
    found = least_squares(residual, start, jacobian, **how)
    p = found.x
    table = p[:-2].reshape(m, _LOCAL)
    J, left = jacobian(p), residual(p)
    parts = [left[span] for span in spans]
    spread = float(left[: ends[-1]] @ left[: ends[-1]]) / max(ends[-1] - len(p), 1)
    alike = sum(float(part[1:] @ part[:-1]) for part in parts) / max(sum(float(part @ part) for part in parts), 1e-300)
    alike = min(max(alike, 0.0), 0.97)
    wider = max(spread, 1.0) * (1 + alike) / (1 - alike)
    kept = np.concatenate([np.arange(1, 4) + i * _LOCAL for i in range(m)])
    rough = [np.sqrt(np.mean((r / w) ** 2)) / abs(one[5]) for r, w, one in zip(parts, weights, table, strict=True)]
    return Fitted(
        local=table + np.r_[1.0, np.zeros(_LOCAL - 1)] * zero[:, None],
        cov=_inverse(J.T @ J)[np.ix_(kept, kept)] * wider,
        lag=(float(p[-2]), float(p[-1])),
        rough=np.array(rough),
        residual=tuple(r / w for r, w in zip(parts, weights, strict=True)),
        rate=tuple(slopes(t[i] - one[0], one[1:4], p[-2], p[-1])[1] * one[5] for i, one in enumerate(table)),
        wider=wider,
        cost=2 * float(found.cost),
    )


def _inverse(normal: Array) -> Array:
    scale = np.sqrt(np.diag(normal))
    scale[scale == 0] = 1.0
    scales = np.outer(scale, scale)
    return np.asarray(np.linalg.pinv(normal / scales, rcond=1e-14, hermitian=True) / scales)


def clock_jitter(fits: Sequence[Fitted], noises: Sequence[float]) -> float:
    """How far a row's time is off [s], standard deviation: what is left beyond the noise where axes are fast."""
    off = []
    for one, noise in zip(fits, noises, strict=True):
        for residual, rate in zip(one.residual, one.rate, strict=True):
            fast = np.abs(rate) > 0.3 * np.max(np.abs(rate))
            off.append((residual[fast] ** 2 - noise**2) / rate[fast] ** 2)
    values = np.concatenate(off)
    return float(np.sqrt(max(float(np.mean(np.clip(values, None, 25 * np.median(np.abs(values)) + 1e-12))), 0.0)))


def logs(phases: Array, cov: Array) -> tuple[Array, Array]:
    """Of m motions the logarithms (3, m) of speed, acceleration and jerk of their progress, and the covariance
    (3, m, m) of each."""
    m = len(phases)
    T = boxes(phases)
    value = -np.cumsum(np.log(T), axis=1).T
    out = np.empty((3, m, m))
    for k in range(3):
        D = np.zeros((m, 3 * m))
        for i in range(m):
            D[i, 3 * i : 3 * i + 3] = -sum(GROWS[n] / T[i, n] for n in range(k + 1))
        out[k] = D @ cov @ D.T
    return value, out


def without_jerk(local: Array) -> Array:
    """Local parameters (m, 6) of motions that take as long to their top speed and last as long, with jumping
    accelerations."""
    out = local.copy()
    x, y, z = local[:, 1], local[:, 2], local[:, 3]
    out[:, 0] += x / 2
    out[:, 1], out[:, 2], out[:, 3] = LEAST, x + y, x + z
    return out
