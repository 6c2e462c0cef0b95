"""The printer of RAPID for this folder's tests, too; it lies beside those of the language."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "rapid"))
