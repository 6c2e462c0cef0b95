"""`trajopt view`: which file it opens, what it serves, and what it says where there is nothing to open."""

from __future__ import annotations

import signal
import socket
import struct
import subprocess
import sys
import time
from functools import partial
from http.client import HTTPConnection
from pathlib import Path

import pytest

from trajopt_cli.cli import page_server, run
from trajopt_cli.runs.folder import SENSITIVITY, write_run
from trajopt_cli.runs.record import Inputs
from trajopt_cli.study.answers import study_record

PAGE = "<!doctype html><title>Ω</title>".encode()


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A results folder with a page, and no browser."""
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(page_server, "_SNAPS", tmp_path / "none")
    place = tmp_path / "a result"
    write_run(place, study_record(SENSITIVITY), {"report.html": PAGE}, "sensitivity", options={}, inputs=Inputs())
    return place


@pytest.fixture
def browser(folder: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A stand-in that the system takes for the user's browser; it writes down what it is asked to open."""
    stand_in, asked = folder.parent / "browser", folder.parent / "asked"
    stand_in.write_text(f'#!/bin/sh\necho "$@" >> {asked}\n')
    stand_in.chmod(0o755)
    monkeypatch.setenv("BROWSER", str(stand_in))
    return asked


def command(*arguments: str) -> list[str]:
    return [sys.executable, "-m", "trajopt_cli.cli", "view", *arguments]


def test_the_page_is_opened_where_it_lies(folder: Path, browser: Path) -> None:
    done = subprocess.run(command(str(folder)), capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert browser.read_text().split() == [f"file://{folder}/report.html".replace(" ", "%20")]


def test_print_opens_nothing(folder: Path, browser: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["view", str(folder), "--print"]) == 0
    assert capsys.readouterr().out == f"{folder}/report.html\n"
    assert not browser.exists()


def test_where_no_browser_can_be_opened_the_place_is_printed(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["view", str(folder)]) == 0
    told = capsys.readouterr()
    assert told.out == f"{folder}/report.html\n"
    assert "no browser" in told.err


def test_the_server_gives_the_page_alone_to_this_machine_alone_until_ctrl_c(folder: Path, browser: Path) -> None:
    (folder.parent / "secret").write_text("secret")
    heard = partial(signal.signal, signal.SIGINT, signal.SIG_DFL)  # tests in the background of a shell hear no Ctrl-C
    with subprocess.Popen(
        command(str(folder), "--serve"), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, preexec_fn=heard
    ) as process:
        assert process.stdout is not None
        address = process.stdout.readline().split()[0]
        port = int(address.rstrip("/").rpartition(":")[2])
        assert address == f"http://127.0.0.1:{port}/"

        def ask(path: str, host: str) -> tuple[int, bytes]:
            connection = HTTPConnection("127.0.0.1", port, timeout=10)
            connection.request("GET", path, headers={"Host": host})
            answer = connection.getresponse()
            return answer.status, answer.read()

        assert ask("/", f"127.0.0.1:{port}") == (200, PAGE)
        for path, host in (("/../secret", f"127.0.0.1:{port}"), ("/run.json", f"127.0.0.1:{port}"), ("/", "evil.test")):
            assert ask(path, host) == (404, b"")
        with socket.create_connection(("127.0.0.1", port)) as leaving:  # half a request, and a reset
            leaving.sendall(b"GET / HTTP/1.1\r\nHost:")
            leaving.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        assert ask("/", f"localhost:{port}") == (200, PAGE)
        until = time.monotonic() + 10
        while not browser.exists() and time.monotonic() < until:
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        try:
            assert process.wait(timeout=10) == 0
            assert process.stderr is not None
            assert process.stderr.read() == ""
        finally:
            process.kill()
    assert browser.read_text().split() == [address]


def test_a_snap_is_served(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert page_server.apart() is None
    (folder.parent / "none").mkdir()
    (folder.parent / "none" / "firefox").touch()
    assert page_server.apart() == "firefox is a snap, which may not read all files"
    monkeypatch.setenv("BROWSER", "mine")
    assert page_server.apart() is None


def test_a_page_that_was_changed_and_a_folder_without_one(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "report.html").write_bytes(PAGE + b" ")
    assert run(["view", str(folder)]) == 2
    assert capsys.readouterr().err.startswith(f"{folder}/report.html: was changed since the run; ")
    other = folder.parent / "other"
    write_run(other, study_record(SENSITIVITY), {"a.json": b"{}"}, "sensitivity", options={}, inputs=Inputs())
    assert run(["view", str(other)]) == 2
    assert capsys.readouterr().err == f"{other}: has no report.html; run trajopt sensitivity again\n"
    record = (other / "run.json").read_text()
    (other / "run.json").write_text(record.replace('"kind": "sensitivity"', '"kind": "iiwa"'))
    assert run(["view", str(other)]) == 2
    assert capsys.readouterr().err == f"{other}: has no report.html; run trajopt iiwa simulate again\n"
    assert run(["view", str(folder.parent / "none")]) == 2
    assert "none" in capsys.readouterr().err
