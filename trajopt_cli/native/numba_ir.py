"""LLVM IR of modules of loops, for developers: python -m trajopt_cli.native.numba_ir [MODULE ...]

Needs numba. Writes the .ll file beside each module, by default all of the package: what numba makes of its functions,
optimised for any processor, and nothing in it depends on the computer that it was made on. Its first line is a digest,
its second says what it was made by, and those below it what kinds of arguments the functions take.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from importlib import import_module
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from platform import python_version

import llvmlite.binding as llvm

from trajopt_cli.native.loops import digest_line

_COUNTING = re.compile(r"^(define [^\n]*@NRT_(?:in|de)cref\([^\n]*\)[^\n{]*)\{\n.*?^\}\n", re.MULTILINE | re.DOTALL)
_NAMES = re.compile(r"_ZN[\w.]+")
_OURS = re.compile(r"^(?:; ModuleID|source_filename|target ).*\n", re.MULTILINE)


def made_by() -> str:
    """The second line of a file."""
    return f"; made by numba {version('numba')}, llvmlite {version('llvmlite')}, Python {python_version()}"


def written(name: str) -> str:
    """The file of a module, in a process that has not compiled by numba for this computer."""
    from numba import config

    config.CPU_NAME, config.CPU_FEATURES = "generic", ""
    config.DISABLE_JIT, config.BOUNDSCHECK = 0, None  # whatever the environment says
    source = import_module(name)
    llvm.initialize_native_target()
    public = {key: one for key, one in vars(source).items() if hasattr(one, "signatures") and key[0] != "_"}
    module, target = llvm.parse_assembly(""), llvm.Target.from_default_triple().create_target_machine(opt=2)
    passes = llvm.create_pass_builder(target, llvm.create_pipeline_tuning_options(speed_level=2))
    kinds = []
    for key, function in public.items():
        (signature,) = function.signatures
        kinds.append(f"; loops.{key}: {'; '.join(map(str, signature))}")
        # arrays count no references here
        one = llvm.parse_assembly(_COUNTING.sub(r"\1 {\nret void\n}\n", function.inspect_llvm(signature)))
        symbol = function.overloads[signature].fndesc.llvm_func_name
        for value in (*one.functions, *one.global_variables):
            if not value.is_declaration and value.name != symbol:
                value.linkage = llvm.Linkage.internal
        passes.getModulePassManager().run(one, passes)
        one.get_function(symbol).name = f"loops.{key}"
        module.link_in(one)
    names: dict[str, str] = {}  # numba's count what the process has compiled
    made = _NAMES.sub(lambda found: names.setdefault(found[0], f"part.{len(names)}"), _OURS.sub("", str(module)))
    text = "\n".join([made_by(), *kinds, made])
    return f"{digest_line(Path(str(source.__file__)), text)}\n{text}"


def package_loops() -> Iterator[str]:
    """The names of the package's modules of loops."""
    package = Path(__file__).parents[1]
    for source in sorted(package.rglob("*_loops.py")):
        yield ".".join((package.name, *source.relative_to(package).with_suffix("").parts))


if __name__ == "__main__":
    for each in sys.argv[1:] or package_loops():
        spec = find_spec(each)
        assert spec is not None
        assert spec.origin is not None
        Path(spec.origin).with_suffix(".ll").write_text(written(each))
