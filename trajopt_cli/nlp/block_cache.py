"""Where blocks come from: compiled for this computer and kept in the user's cache, or evaluated by CasADi.

A block that is kept is neither differentiated nor compiled again. Its key holds all that its expressions are made from.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

import numpy as np

from trajopt_cli.native.store import Store, users_store
from trajopt_cli.nlp.block import Block, Expressed, Shape

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from trajopt_cli.native.machine import Machine

_NAMES = ("g", "jacobian", "hessian")
# what expressions and machine code are written by, beside all of path, robot and native
_OURS = ("nlp/formulation", "nlp/constraint", "nlp/block", "nlp/block_cache", "settings")


class Library(Protocol):
    """Makes blocks."""

    def block(self, name: str, key: str, express: Callable[[], Expressed]) -> Block:
        """The block of that key; express is called where it is not known yet."""

    @property
    def notice(self) -> str | None:
        """What a user should know of it, one line."""


class Maps:
    """Blocks that CasADi evaluates, kept in memory."""

    notice = None

    def __init__(self) -> None:
        self._blocks: dict[str, Block] = {}

    def block(self, name: str, key: str, express: Callable[[], Expressed]) -> Block:
        """See Library."""
        if key not in self._blocks:
            self._blocks[key] = express().block(name)
        return self._blocks[key]


class Native:
    """Blocks compiled for a machine, kept in a store and in memory."""

    def __init__(self, machine: Machine, store: Store):
        self.machine, self.store = machine, store
        self._blocks: dict[str, Block] = {}
        self._made_by = f"{self.machine.identity} casadi {version('casadi')} {_sources()}"

    @property
    def notice(self) -> str | None:
        """See Library."""
        if self.store.trouble is None:
            return None
        return f"compiled code cannot be kept and is made anew in every run: {self.store.trouble}"

    def block(self, name: str, key: str, express: Callable[[], Expressed]) -> Block:
        """See Library."""
        key = f"{key} {self._made_by}"
        if key not in self._blocks:
            kept = self.store.read(key)
            if kept is None:
                kept = self._compiled(express())
                self.store.write(key, kept)
            kernels = self.machine.loaded(kept["code"].tobytes(), _NAMES)
            self._blocks[key] = Block(name, _shape(kept), *(kernels[one] for one in _NAMES))
        return self._blocks[key]

    def _compiled(self, expressed: Expressed) -> dict[str, NDArray[np.generic]]:
        shape = expressed.shape
        code = self.machine.compiled(expressed.functions())
        return {
            "code": np.frombuffer(code, dtype=np.uint8),
            "sizes": np.array([shape.n_variables, shape.n_parameters]),
            "bounds": np.array([shape.lower, shape.upper]),
            "jacobian": np.array(shape.jacobian_at),
            "hessian": np.array(shape.hessian_at),
        }


def _shape(kept: dict[str, NDArray[np.generic]]) -> Shape:
    n_z, n_p = (int(n) for n in kept["sizes"])
    lower, upper = np.asarray(kept["bounds"], dtype=np.float64)
    (jr, jc), (hr, hc) = (np.asarray(kept[name], dtype=np.intp) for name in ("jacobian", "hessian"))
    return Shape(n_z, n_p, lower, upper, (jr, jc), (hr, hc))


@cache
def library() -> Library:
    """The one of this process."""
    from trajopt_cli.native.machine import machine

    return Native(machine(), users_store())


def evaluation_notices() -> Iterator[str]:
    """What a user should know of how nonlinear programs are evaluated here, at most one line."""
    if (said := library().notice) is not None:
        yield said


def _sources() -> str:
    """A digest of the files that expressions and machine code come from."""
    return hashlib.sha256(b"".join(file.read_bytes() for file in _files())).hexdigest()


def _files() -> Iterator[Path]:
    package = Path(__file__).parents[1]
    yield package / "geometry.py"
    yield from (package / f"{name}.py" for name in _OURS)
    for room in ("native", "path", "robot", "trajectories/limits"):
        yield from sorted((package / room).glob("*.py"))
