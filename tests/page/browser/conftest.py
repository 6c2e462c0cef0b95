"""A real browser without a window, and pages in it.

Without one the tests are skipped and say so; with TRAJOPT_BROWSER_TESTS=1 in the environment they fail instead.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from no_browser import MISSING
from window import FLAGS, Window


@pytest.fixture(scope="session")
def window(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Window]:
    from selenium.webdriver import Chrome, ChromeOptions
    from selenium.webdriver.chrome.service import Service

    browser = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    driver = shutil.which("chromedriver")
    if browser is None or driver is None:
        (pytest.fail if os.environ.get("TRAJOPT_BROWSER_TESTS") == "1" else pytest.skip)(MISSING)
    options = ChromeOptions()
    options.binary_location = browser
    for flag in (*FLAGS, f"--user-data-dir={tmp_path_factory.mktemp('browser')}"):
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    chrome = Chrome(options=options, service=Service(executable_path=driver))
    window = Window(chrome)
    try:
        chrome.get("data:,")
        window.complaints(), window.fetched()  # what the browser does for itself when it starts
        yield window
    finally:
        chrome.quit()


@pytest.fixture(autouse=True)
def quiet(request: pytest.FixtureRequest) -> Iterator[None]:
    """No test leaves a word in the console, nor a request for anything but files."""
    yield
    if "window" in request.fixturenames:
        window: Window = request.getfixturevalue("window")
        assert window.complaints() == []
        assert [url for url in window.fetched() if not url.startswith(("file:", "data:"))] == []


@pytest.fixture(scope="session")
def written(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str, bytes], Path]:
    """Puts a page where the browser finds it."""
    folder = tmp_path_factory.mktemp("pages")

    def write(name: str, content: bytes) -> Path:
        path = folder / name
        path.write_bytes(content)
        return path

    return write
