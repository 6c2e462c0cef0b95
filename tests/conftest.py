"""What every test has: a cache folder that is not the user's, and a terminal of no width."""

from __future__ import annotations

import os
import tempfile

import pytest
from no_browser import MISSING

_FOLDER = tempfile.TemporaryDirectory()
os.environ["XDG_CACHE_HOME"] = _FOLDER.name
for _name in ("COLUMNS", "NO_COLOR", "FORCE_COLOR"):  # what is printed depends on them
    os.environ.pop(_name, None)


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """pytest itself gives no reason for a skip unless it is asked."""
    count = sum(MISSING in str(report.longrepr) for report in terminalreporter.getreports("skipped"))
    if count:
        terminalreporter.write_line(f"{count} tests of the report page did not run: {MISSING}")
