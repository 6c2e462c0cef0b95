"""A process that dies as by kill -9 at a chosen step of what it does to the disk.

It is forked by a small process beside this one: a fork of one that has every test's libraries and plans in its memory
takes many times as long.
"""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

from trajopt_cli.runs import transaction

DEADLY = ("replace", "link", "rename", "chmod", "utime", "unlink", "ftruncate", "fsync", "open", "write")


def killed_at(step: int, function: Callable[..., object], *arguments: object) -> bool:
    """Call function in another process, which dies before its step-th change of the disk, and in the middle of it where
    it writes; whether it came to its end. Function and arguments are pickled."""
    beside = _beside()
    assert beside.stdin is not None
    assert beside.stdout is not None
    pickle.dump((step, function, arguments), beside.stdin)
    beside.stdin.flush()
    return bool(pickle.load(beside.stdout))


@cache
def _beside() -> subprocess.Popen[bytes]:
    """The process that forks; it ends when this one does."""
    around = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])}
    return subprocess.Popen([sys.executable, __file__], stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=around)


def dying_at(step: int, call: Callable[[], object]) -> bool:
    """The same of any call, forked here."""
    pid = os.fork()
    if pid:
        return os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]) == 0
    left = step

    def deadly(function: Callable[..., Any]) -> Callable[..., Any]:
        def dying(*args: Any, **kwargs: Any) -> Any:
            nonlocal left
            left -= 1
            if left < 0:
                if function is fill:
                    args[0].write(args[1][: len(args[1]) // 2])
                    args[0].flush()
                os._exit(9)
            return function(*args, **kwargs)

        return dying

    code = 1
    try:
        fill = transaction.fill
        transaction.fill = deadly(fill)
        Path.unlink = deadly(Path.unlink)  # type: ignore[method-assign]
        for name in DEADLY:
            setattr(os, name, deadly(getattr(os, name)))
        call()
        code = 0
    finally:
        os._exit(code)


def _serve() -> None:
    while True:
        try:
            step, function, arguments = pickle.load(sys.stdin.buffer)
        except EOFError:
            return
        pickle.dump(dying_at(step, lambda f=function, a=arguments: f(*a)), sys.stdout.buffer)  # type: ignore[misc]
        sys.stdout.buffer.flush()


if __name__ == "__main__":
    _serve()
