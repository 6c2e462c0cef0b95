"""Section 6.1.8: which stiffness and damping settle at 1 ms, against "stable for k, d, m > 0" of the thesis."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.geometry import Array, readonly
from trajopt_cli.iiwa.controller.stability import StabilityVerdict, largest_period, stability_map
from trajopt_cli.iiwa.experiments.setup import INERTIA, Bench, H

# Stiffness, damping and inertia of every section of chapter 6 [N/m, N s/m, kg]; the last three of rotation.
_USED = (
    ("6.1.1", 100.0, 100.0, 25.0), ("6.1.1", 500.0, 100.0, 25.0), ("6.1.2", 500.0, 50.0, 25.0),
    ("6.1.2", 500.0, 200.0, 25.0), ("6.1.4", 200.0, 100.0, 25.0), ("6.1.6", 0.0, 100.0, 25.0),
    ("6.2.1", 1000.0, 500.0, 25.0), ("6.2.2", 2000.0, 500.0, 25.0), ("6.2.2", 500.0, 500.0, 25.0),
    ("6.2.2", 200.0, 500.0, 25.0), ("6.2.2", 100.0, 500.0, 25.0), ("6.2.3", 1000.0, 100.0, 25.0),
    ("6.2.3", 1000.0, 200.0, 25.0), ("6.2.3", 1000.0, 1000.0, 25.0), ("6.2.3", 1000.0, 2000.0, 25.0),
    ("6.2.4", 1000.0, 400.0, 25.0), ("6.1.1", 30.0, 20.0, 3.0), ("6.1.3", 40.0, 30.0, 3.0), ("6.1.6", 0.0, 20.0, 3.0),
)  # fmt: skip
_K = np.r_[0.0, np.geomspace(1.0, 1e8, 97)]  # N/m
_D = np.r_[0.0, np.geomspace(0.1, 1e5, 97)]  # N s/m


@dataclass(frozen=True)
class Setting:
    """Numbers of one section, their verdict at H, and the period [s] from which on it is lost."""

    section: str
    k: float
    d: float
    m: float
    verdict: StabilityVerdict
    h_max: float


@dataclass(frozen=True, eq=False)
class StabilityMap:
    """Verdicts (a, b) over k (a,) [N/m] and d (b,) [N s/m] for m [kg] and a period h [s].

    settings: those of chapter 6. denied: share of the map's points with k, d > 0 that do not settle, all of which the
    thesis calls stable.
    """

    section: str
    title: str
    m: float
    h: float
    k: Array
    d: Array
    verdicts: NDArray[np.int8]
    settings: tuple[Setting, ...]
    denied: float
    sentences: tuple[str, ...]

    def __post_init__(self) -> None:
        object.__setattr__(self, "k", readonly(self.k))
        object.__setattr__(self, "d", readonly(self.d))
        self.verdicts.setflags(write=False)


def stability(bench: Bench) -> StabilityMap:
    """6.1.8: the map for m = 25 kg at 1 ms, and every setting of the chapter."""
    m = INERTIA[0]
    verdicts = stability_map(_K, _D, m, H)
    settings = tuple(
        Setting(
            section,
            k,
            d,
            mass,
            StabilityVerdict(int(stability_map([k], [d], mass, H)[0, 0])),
            largest_period(k, d, mass),
        )
        for section, k, d, mass in _USED
    )
    denied = float(np.mean(verdicts[1:, 1:] != StabilityVerdict.STABLE))
    return StabilityMap(
        section="6.1.8",
        title="stability of the law at 1 ms",
        m=m,
        h=H,
        k=_K,
        d=_D,
        verdicts=verdicts,
        settings=settings,
        denied=denied,
        sentences=(
            'erratum: "stable for k, d, m > 0" is the continuous law\'s; by forward Euler k > 0 settles for h k < d and'
            " h d/m < 2 + h^2 k/2m only",
            f"at h = {1e3 * H:g} ms and m = {m:g} kg that is d > {H:g} s k and d < {2 * m / H:g} N s/m + {H / 2:g} s k;"
            " k = 0 stays where it is put (marginal), d = 0 with k > 0 is unstable, not marginal",
            f"of the map's points with k, d > 0 (k to {_K[-1]:g} N/m, d to {_D[-1]:g} N s/m, in even ratios)"
            f" {100 * denied:.0f} % do not settle",
        ),
    )
