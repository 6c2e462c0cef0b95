"""A page brought to a browser: by the system's own way, or by a server for this machine alone."""

from __future__ import annotations

import os
import platform
import sys
from collections.abc import Callable
from contextlib import suppress
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread
from typing import Any

_LOOPBACK = "127.0.0.1"
_SNAPS = Path("/snap/bin")
_BROWSERS = ("firefox", "chromium")  # that come as snaps


def apart() -> str | None:
    """Why the browser may not read files of this system, None where it may."""
    if "BROWSER" in os.environ:  # the user's own choice
        return None
    if "microsoft" in platform.release().lower():
        return "the browser runs on Windows, outside of WSL"
    found = next((name for name in _BROWSERS if (_SNAPS / name).exists()), None)
    return None if found is None else f"{found} is a snap, which may not read all files"


def open_browser(address: str) -> bool:
    """Whether a browser took it. Without a screen none is asked: a text browser would take the terminal."""
    import webbrowser

    screens = ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER")
    if sys.platform.startswith("linux") and not any(os.environ.get(name) for name in screens):
        return False
    return webbrowser.open(address)


def serve_page(content: bytes, tell: Callable[[str], None]) -> None:
    """Give content to whoever asks on this machine, on a port of the system's choice, until Ctrl-C.

    tell: is called with the address once it answers; then the browser is opened.
    """

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            # another site must not reach it by a name of its own that leads here
            known = self.headers.get("Host") in (f"{_LOOPBACK}:{port}", f"localhost:{port}")
            self.send_response(200 if known and self.path == "/" else 404)
            self.send_header("Content-Type", "text/html; charset=utf-8")
            body = content if known and self.path == "/" else b""
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)

        def log_message(self, format: str, *args: object) -> None:
            """Say nothing."""

    class Server(ThreadingHTTPServer):
        def handle_error(self, request: Any, client_address: Any) -> None:
            """A browser that goes away in the middle is no matter for anybody."""
            if not isinstance(sys.exception(), ConnectionError):
                super().handle_error(request, client_address)

    with Server((_LOOPBACK, 0), Handler) as server:
        port = server.server_address[1]
        address = f"http://{_LOOPBACK}:{port}/"
        tell(address)
        Thread(target=open_browser, args=(address,), daemon=True).start()  # one that blocks is waiting for the page
        with suppress(KeyboardInterrupt):
            server.serve_forever()
