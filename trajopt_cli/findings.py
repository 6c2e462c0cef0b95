"""What the judge says of a trajectory: findings with value and limit, legality apart from advice."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

from trajopt_cli.motion import Source


@dataclass(frozen=True)
class Finding:
    """One check's worst case. subject: the joint or frame ("joint_3", "TCP", "program"). value and limit in unit.

    time [s] is where the worst case stands, None where the check has no time. source is the motion concerned.
    """

    check: str
    subject: str
    value: float
    limit: float
    unit: str
    passed: bool
    time: float | None = None
    source: Source | None = None
    message: str = ""

    @property
    def margin(self) -> float:
        """limit - value, in unit."""
        return self.limit - self.value


@dataclass(frozen=True)
class GridResolution:
    """What rows on a bare grid leave open: rows in a second [Hz], lengths of waits [s], the place of a stop [m] and the
    speed there [m/s]."""

    rate: float
    dwell: float
    stop: float
    rest: float


CLEARANCE, SELF_CLEARANCE, TABLE_CLEARANCE = "clearance", "self clearance", "table clearance"
CLEARANCES = (CLEARANCE, SELF_CLEARANCE, TABLE_CLEARANCE)
COARSE = ("printed resolution", "row spacing")
"""Checks of the file itself: one that fails them cannot be judged."""


@dataclass(frozen=True)
class Report:
    """Legality decides (legal); advice never does. grid: what rows leave open whose boundaries lie between them; None
    where they have rows. missing: a clause on rows that an even file lost, empty for none."""

    findings: tuple[Finding, ...]
    advice: tuple[Finding, ...] = ()
    grid: GridResolution | None = None
    missing: str = ""

    @property
    def legal(self) -> bool:
        """True when every legality finding passed."""
        return all(finding.passed for finding in self.findings)

    @property
    def too_coarse(self) -> bool:
        """True when nothing is wrong but that the file is too coarse to be judged."""
        failed = [finding for finding in self.findings if not finding.passed]
        return bool(failed) and all(finding.check in COARSE for finding in failed)

    @property
    def worst(self) -> Finding:
        """The failed finding that is farthest beyond its limit."""
        return min((finding for finding in self.findings if not finding.passed), key=lambda finding: finding.margin)

    @property
    def collisions(self) -> tuple[Finding, ...]:
        """What is hit or too close, in time order, where that is all that is wrong; else none."""
        hits, failed = collisions(self.findings), sum(not finding.passed for finding in self.findings)
        return hits if len(hits) == failed else ()

    @property
    def excesses(self) -> tuple[tuple[float, float], ...]:
        """When [s] each failed finding is worst and by what share of its limit; none where one is not above a limit at
        some time: driving slower is no cure for that."""
        failed = [one for one in self.findings if not one.passed]
        over = [(one.time, one.value / one.limit - 1) for one in failed if one.time is not None and one.limit > 0]
        return tuple(over) if len(over) == len(failed) and all(share > 0 for _, share in over) else ()

    @property
    def refusal(self) -> str:
        """Why the motion is not legal, as the end of a sentence: what it hits, or an error in trajopt."""
        if hits := self.collisions:
            return f"collides: {hits[0].message}"
        return f"is not legal: {self.worst.message}: an error in trajopt; please report it"


def collisions(findings: Iterable[Finding]) -> tuple[Finding, ...]:
    """The findings that say the robot, or a body on a positioner, hits something or comes too close, in time order."""
    missed = [one for one in findings if one.check in CLEARANCES and not one.passed]
    return tuple(sorted(missed, key=lambda one: one.time or 0.0))


def failures(findings: Iterable[Finding]) -> list[str]:
    """What the judge says of each case that did not pass."""
    return [finding.message or f"{finding.check} of {finding.subject}" for finding in findings if not finding.passed]


def nearest(findings: Iterable[Finding]) -> list[tuple[Finding, int]]:
    """The tightest case of each check, failed ones first, and how many cases the check has; in their order."""
    cases: dict[str, list[Finding]] = {}
    for one in findings:
        cases.setdefault(one.check, []).append(one)
    return [(min(group, key=closeness), len(group)) for group in cases.values()]


def good_side(finding: Finding) -> float:
    """How far the value is on the good side; a limit from below is told by a case that passed under it."""
    lower = finding.passed and finding.margin < -1e-6 * abs(finding.limit)
    return abs(finding.margin) if lower else finding.margin if finding.passed else -abs(finding.margin)


def closeness(finding: Finding) -> tuple[bool, float]:
    """Failed cases first, then by margin relative to the limit."""
    margin = good_side(finding)
    relative = margin / abs(finding.limit) if finding.limit else margin
    return finding.passed, relative if math.isfinite(relative) else -math.inf
