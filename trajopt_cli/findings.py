"""What the judge says of a trajectory: findings with value and limit, legality apart from advice."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

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
class Report:
    """Legality decides (legal); advice never does."""

    findings: tuple[Finding, ...]
    advice: tuple[Finding, ...] = ()

    @property
    def legal(self) -> bool:
        """True when every legality finding passed."""
        return all(finding.passed for finding in self.findings)


def finding_record(finding: Finding) -> dict[str, Any]:
    """A finding as plain data for JSON; null for a number that could not be computed."""
    return {
        "check": finding.check,
        "subject": finding.subject,
        "value": _finite(finding.value),
        "limit": _finite(finding.limit),
        "margin": _finite(finding.margin),
        "unit": finding.unit,
        "passed": finding.passed,
        "time_s": finding.time,
        "source": str(finding.source) if finding.source else None,
        "message": finding.message,
    }


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None
