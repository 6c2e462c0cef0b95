"""This computer: functions compiled for it by LLVM, and object code loaded so that it can be called.

Needs llvmlite, a wheel with LLVM in it; no compiler is asked for.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping, Sequence
from ctypes.util import find_library
from dataclasses import dataclass
from functools import cache, partial
from itertools import count
from typing import TYPE_CHECKING, Any

import llvmlite
import llvmlite.binding as llvm

from trajopt_cli.geometry import Array

if TYPE_CHECKING:
    import casadi as ca

_ENTRY = ctypes.CFUNCTYPE(None, ctypes.c_int64, *[ctypes.c_void_p] * 4)
_LEVEL = 0  # of code generation. Measured: see docs/measured.md, Machine code
_HOT = 2  # the same for loops that are run often
_LIBM = "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "log", "pow"  # of the C library, that code calls


@dataclass(frozen=True, eq=False)
class NativeKernel:
    """A compiled function of z, p and lam. lanes: how many copies stand side by side in its arrays."""

    lanes: int
    entry: Any
    library: Any  # keeps the code in memory

    def bound(self, groups: int, z: Array, p: Array, lam: Array, out: Array) -> Callable[[], object]:
        """The call that evaluates groups of copies from these arrays, each (groups, length, lanes), into out."""
        addresses = [ctypes.c_void_p(x.ctypes.data) for x in (z, p, lam, out)]
        call = partial(self.entry, ctypes.c_int64(groups), *addresses)
        call.keeps = (self, z, p, lam, out)  # type: ignore[attr-defined]
        return call


class Machine:
    """The processor that this runs on."""

    def __init__(self) -> None:
        llvm.initialize_native_target()
        llvm.initialize_native_asmprinter()
        features = llvm.get_host_cpu_features()
        self._cpu, self._features = llvm.get_host_cpu_name(), features.flatten()
        self.lanes = 8 if features.get("avx512f") else 4  # measured: see there
        self._target, self._hot = self._target_machine(), self._target_machine(_HOT)
        self._jit = llvm.create_lljit_compiler(self._target_machine())
        libm = ctypes.CDLL(find_library("m") or "ucrtbase")
        self._libm = {name: ctypes.cast(getattr(libm, name), ctypes.c_void_p).value for name in _LIBM}
        self._names = (f"library_{i}" for i in count())

    @property
    def identity(self) -> str:
        """What object code must have been made for and by: processor, its features, LLVM."""
        return f"{llvm.get_default_triple()} {self._cpu} {self._features} {self.lanes} llvmlite {llvmlite.__version__}"

    def compiled(self, functions: Mapping[str, ca.Function]) -> bytes:
        """Object code of functions by name, each as writing.module_text says."""
        from trajopt_cli.native.writing import module_text  # casadi with it: not for who only calls loops

        return bytes(self._target.emit_object(llvm.parse_assembly(module_text(functions, self.lanes))))

    def emitted(self, text: str) -> bytes:
        """Object code of LLVM IR that is optimised already."""
        module = llvm.parse_assembly(text)
        module.triple, module.data_layout = self._hot.triple, str(self._hot.target_data)
        return bytes(self._hot.emit_object(module))

    def loaded(self, code: bytes, names: tuple[str, ...]) -> dict[str, NativeKernel]:
        """The functions with these names in object code, as module_text writes them."""
        library = self.linked(code, names)
        return {name: NativeKernel(self.lanes, _ENTRY(library[name]), library) for name in names}

    def linked(self, code: bytes, names: Sequence[str]) -> Any:
        """The addresses of the functions with these names in object code, by name; they live as long as it."""
        builder = llvm.JITLibraryBuilder().add_object_img(code)
        for name, address in self._libm.items():
            builder = builder.import_symbol(name, address)
        for name in names:
            builder = builder.export_symbol(name)
        return builder.link(self._jit, next(self._names))

    def _target_machine(self, level: int = _LEVEL) -> Any:
        return llvm.Target.from_default_triple().create_target_machine(
            cpu=self._cpu, features=self._features, opt=level, jit=True
        )


@cache
def machine() -> Machine:
    """The one of this process."""
    return Machine()
