"""What every test has: a cache folder that is not the user's."""

from __future__ import annotations

import os
import tempfile

_FOLDER = tempfile.TemporaryDirectory()
os.environ["XDG_CACHE_HOME"] = _FOLDER.name
