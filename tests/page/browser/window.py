"""A page in the browser, as the tests look at it."""

from __future__ import annotations

import json
import time
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib.image
import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from selenium.webdriver import Chrome

Picture = NDArray[np.uint8]
FLAGS = (
    "--headless=new",
    "--no-sandbox",
    "--no-first-run",
    "--disable-quic",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    # what a graphics card does for nothing takes a third of the time without one
    "--webgl-antialiasing-mode=none",
    "--disable-gpu-rasterization",
    "--disable-accelerated-2d-canvas",
    "--force-device-scale-factor=1",
)
# Drawing with WebGL takes most of the time without a graphics card.
NO_WEBGL = (
    "const get = HTMLCanvasElement.prototype.getContext;"
    "HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {"
    " return kind === 'webgl' ? null : get.call(this, kind, ...rest); };"
)


@dataclass(frozen=True)
class Window:
    """One page in the browser."""

    chrome: Chrome

    def open(self, file: Path, width: int = 800, height: int = 600, theme: str = "light", flat: bool = False) -> None:
        """A file, loaded anew, in a window of so many pixels; drawn when this returns.

        flat: the view in space has no WebGL and draws lines, for tests that do not look at it.
        """
        self.command(
            "Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=width < 500
        )
        self.prefer(theme)
        script = self.command("Page.addScriptToEvaluateOnNewDocument", source=NO_WEBGL if flat else "")["identifier"]
        try:
            self.chrome.get(file.as_uri())
        finally:
            self.command("Page.removeScriptToEvaluateOnNewDocument", identifier=script)
        until = time.monotonic() + 20
        while self.run("return document.documentElement.dataset.ready") != "yes":
            assert time.monotonic() < until, f"not ready: {self.complaints()}"
        self.settle()

    def prefer(self, theme: str) -> None:
        self.command("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": theme}])

    def theme(self, name: str) -> None:
        self.prefer(name)
        self.settle()

    def command(self, name: str, **values: Any) -> dict[str, Any]:
        return self.chrome.execute_cdp_cmd(name, values)

    def run(self, script: str, *values: Any) -> Any:
        return self.chrome.execute_script(script, *values)

    def settle(self) -> None:
        """Wait until what is asked for has been drawn."""
        self.chrome.execute_async_script(
            "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 0)))"
        )

    def keys(self, *keys: str) -> None:
        from selenium.webdriver import ActionChains

        ActionChains(self.chrome, duration=0).send_keys(*keys).perform()
        self.settle()

    def complaints(self) -> list[str]:
        """What the console has said since it was asked last."""
        return [f"{one['level']}: {one['message']}" for one in self.chrome.get_log("browser")]

    def fetched(self) -> list[str]:
        """Every address that was asked for since, that of the page included."""
        events = (json.loads(one["message"])["message"] for one in self.chrome.get_log("performance"))
        return [one["params"]["request"]["url"] for one in events if one["method"] == "Network.requestWillBeSent"]

    def picture(self, selector: str) -> Picture:
        """What an element shows (h, w, 3), as bytes."""
        from selenium.webdriver.common.by import By

        content = self.chrome.find_element(By.CSS_SELECTOR, selector).screenshot_as_png
        return np.round(255 * matplotlib.image.imread(BytesIO(content))[..., :3]).astype(np.uint8)

    def tree(self) -> list[dict[str, Any]]:
        """What a screen reader is given: nodes with role, name and properties, ignored ones left out."""
        nodes = self.command("Accessibility.getFullAXTree")["nodes"]
        return [node for node in nodes if not node["ignored"]]
