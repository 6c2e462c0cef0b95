"""Loops over arrays of numbers as machine code: numba compiles them once per computer, and then it is not asked again.

A module whose name ends in _loops holds functions for numba. Those without a leading underscore have a signature and
can be called from elsewhere: they take numbers and arrays of float64 and int64, and write into arrays that they are
given. They allocate nothing, raise nothing and return nothing. The module, and numba with it, is imported only where
its machine code is not in the user's cache.
"""

from __future__ import annotations

import ctypes
import hashlib
from collections.abc import Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from functools import cache
from importlib import import_module
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.native.machine import machine
from trajopt_cli.native.store import Store, users_store
from trajopt_cli.workers import Worker

_SCALARS = {"int64": ctypes.c_int64, "float64": ctypes.c_double}


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
        flat: list[Any] = []
        for one, (of, dimensions, dense) in zip(given, self._kinds, strict=True):
            if not isinstance(one, np.ndarray):
                flat.append(one)
                continue
            if one.dtype != of or one.ndim != dimensions or not dimensions or dense > one.flags.c_contiguous:
                raise TypeError(f"{one.dtype}, {one.ndim}d for {of}, {dimensions}d")
            flat += (0, 0, one.size, one.itemsize, one.ctypes.data, *one.shape, *one.strides)
        self._call(*self._ends, *flat)


@cache
def loops(name: str) -> Mapping[str, Loop]:
    """The functions of a module, compiled; from the user's cache where they are there."""
    return loops_kept(name, users_store())


def prepared(names: Sequence[str], store: Store | None = None) -> AbstractContextManager[object]:
    """As long as it lasts, a process beside this one compiles modules that are not in the user's cache. Who asks for
    one of them meanwhile waits until it is there."""
    store = store or users_store()
    if all(store.read(_key(name)) for name in names):
        return nullcontext()

    def work(_: object) -> None:
        for name in names:
            _kept(name, store, alone=False)

    return Worker(work, lambda _: None)


def loops_kept(name: str, store: Store) -> Mapping[str, Loop]:
    """As loops, kept in a store."""
    kept = _kept(name, store)
    symbols = kept["symbols"].tolist()
    library = machine().linked(kept["code"].tobytes(), symbols)
    made = zip(kept["names"].tolist(), symbols, kept["kinds"].tolist(), strict=True)
    return {one: Loop(library[symbol], kinds.split("; "), library) for one, symbol, kinds in made}


def _key(name: str) -> str:
    spec = find_spec(name)
    assert spec is not None
    assert spec.origin is not None
    digest = hashlib.sha256(Path(spec.origin).read_bytes() + Path(__file__).read_bytes()).hexdigest()
    return f"{name} {digest} {machine().identity} numba {version('numba')}"


def _kept(name: str, store: Store, alone: bool = True) -> dict[str, NDArray[np.generic]]:
    """What is kept of a module, compiled once by all processes. alone: also where it cannot be kept for others."""
    key = _key(name)
    if (kept := store.read(key)) is None:
        with store.making(key) as told:
            kept = store.read(key)
            if kept is None and (told or alone):
                kept = _compiled(name)
                store.write(key, kept)
    return kept or {}


def _compiled(name: str) -> dict[str, NDArray[np.generic]]:
    """Object code of a module's functions, with their names, symbols and the kinds of their arguments."""
    from numba import config

    texts, symbols, kinds = list[str](), list[str](), list[str]()
    asked = config.DISABLE_JIT, config.BOUNDSCHECK  # by the user's environment, for programs of his own
    config.DISABLE_JIT, config.BOUNDSCHECK = 0, None
    try:
        found = vars(import_module(name))
    finally:
        config.DISABLE_JIT, config.BOUNDSCHECK = asked
    public = {key: one for key, one in found.items() if hasattr(one, "signatures") and key[0] != "_"}
    for function in public.values():
        (signature,) = function.signatures
        texts.append(function.inspect_llvm(signature))
        symbols.append(function.overloads[signature].fndesc.llvm_func_name)
        kinds.append("; ".join(str(kind) for kind in signature))
    code = np.frombuffer(machine().optimised(texts, symbols), dtype=np.uint8)
    return {"names": np.array([*public]), "symbols": np.array(symbols), "kinds": np.array(kinds), "code": code}
