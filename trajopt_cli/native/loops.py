"""Loops over arrays of numbers as machine code, from LLVM IR that numba wrote.

A module whose name ends in _loops holds functions for numba. Those without a leading underscore have a signature and
can be called from elsewhere: they take numbers and arrays of float64 and int64, and write into arrays that they are
given. They allocate nothing, raise nothing and return nothing. Beside the module stands its LLVM IR, see numba_ir.py:
neither the module nor numba is imported here.
"""

from __future__ import annotations

import ctypes
import hashlib
import re
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.errors import InputError
from trajopt_cli.native.machine import machine
from trajopt_cli.native.store import Store, users_store

_SCALARS = {"int64": ctypes.c_int64, "float64": ctypes.c_double}
KINDS = re.compile(r"^; (loops\.(\w+)): (.*)$", re.MULTILINE)  # of a symbol's arguments


class Loop:
    """A compiled function. kinds: of its arguments as numba writes them: float64, or array(int64, 2d, A), C where it is
    dense."""

    def __init__(self, address: int, kinds: Sequence[str], library: object):
        self._keeps = library
        self._kinds: list[tuple[Any, int, bool]] = []  # of an array: what is in it, its dimensions, whether dense
        types: list[Any] = []
        for kind in kinds:
            of, dimensions, order = (*kind.removeprefix("array(").rstrip(")").split(", "), "0d", "")[:3]
            n = int(dimensions[0])
            self._kinds.append((np.dtype(of), n, order == "C"))
            # an array is who keeps it twice, length, bytes of one, address, lengths and strides
            types += [ctypes.c_ssize_t] * (5 + 2 * n) if n else [_SCALARS[kind]]
        self._call = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p, ctypes.c_void_p, *types)(address)
        self._out = np.zeros(2)  # for what it returns or raises, which is nothing
        self._ends = self._out.ctypes.data, self._out.ctypes.data + 8

    def __call__(self, *given: NDArray[np.generic] | float) -> None:
        """Call it. Raises TypeError for an array of another kind."""
        self._call(*self._ends, *self._flat(given))

    def on(self, *given: NDArray[np.generic]) -> Callable[[], None]:
        """A call of it on these arrays, whatever is in them then. Raises TypeError for an array of another kind."""
        call, flat = self._call, (*self._ends, *self._flat(given))

        def again(_kept: object = given) -> None:
            call(*flat)

        return again

    def _flat(self, given: Sequence[NDArray[np.generic] | float]) -> list[Any]:
        """What stands for these arguments."""
        flat: list[Any] = []
        for one, (of, dimensions, dense) in zip(given, self._kinds, strict=True):
            if not isinstance(one, np.ndarray):
                flat.append(one)
                continue
            if one.dtype != of or one.ndim != dimensions or not dimensions or dense > one.flags.c_contiguous:
                raise TypeError(f"{one.dtype}, {one.ndim}d for {of}, {dimensions}d")
            flat += (0, 0, one.size, one.itemsize, _address(one), *one.shape, *one.strides)
        return flat


def _address(array: NDArray[np.generic]) -> int:
    """Where its numbers begin. What the array itself says of that takes seven times as long: 5 us, of ten arrays as
    long as a loop over a thousand numbers of each."""
    if array.size and array.flags.carray:  # dense, aligned and writable
        return ctypes.addressof(ctypes.c_char.from_buffer(array))  # type: ignore[arg-type]
    return array.ctypes.data


@cache
def loops(name: str) -> Mapping[str, Loop]:
    """The functions of a module. Raises InputError where its LLVM IR is damaged or was made from another source."""
    return loops_kept(name, users_store())


def loops_kept(name: str, store: Store) -> Mapping[str, Loop]:
    """As loops, with object code kept in a store."""
    spec = find_spec(name)
    assert spec is not None
    assert spec.origin is not None
    source = Path(spec.origin)
    digest, _, text = source.with_suffix(".ll").read_text().partition("\n")
    if digest != digest_line(source, text):
        raise InputError(
            f"{source.with_suffix('.ll')} does not belong to {source.name}: install trajopt-cli again or, where the "
            f"source was changed, run python -m trajopt_cli.native.numba_ir {name}"
        )
    found = KINDS.findall(text)
    symbols = [symbol for symbol, _, _ in found]
    key = f"{digest} {machine().identity}"
    if (kept := store.read(key)) is None:
        kept = {"code": np.frombuffer(machine().emitted(text), dtype=np.uint8)}
        store.write(key, kept)
    library = machine().linked(kept["code"].tobytes(), symbols)
    return {one: Loop(library[symbol], kinds.split("; "), library) for symbol, one, kinds in found}


def digest_line(source: Path, text: str) -> str:
    """The first line of a file of LLVM IR: of a module's source and of what follows."""
    return f"; sha256 {hashlib.sha256(source.read_bytes() + text.encode()).hexdigest()} of {source.name} and of this"
