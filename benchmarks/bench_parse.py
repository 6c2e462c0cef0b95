"""A large generated program, read and interpreted: seconds of processor by step, and memory; a small one as a
whole process.

python benchmarks/bench_parse.py [--targets N] [--repeat N]

Three shapes of the same targets: declared one by one and moved to, written inside the moves, and as one array in a
loop. Each runs in a process of its own, so that the memory is its own. The yardstick, for machines of other speed: the
json module reading the targets' numbers alone, in the same run.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import resource
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median
from time import perf_counter, process_time

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before NumPy starts its threads
REPOSITORY = Path(__file__).parents[1]
sys.path.insert(0, str(REPOSITORY))  # run from a checkout without installing

SHAPES = ("declared", "inline", "array")
SMALL = REPOSITORY / "programs" / "bench_irb140.mod"


def generate(shape, count):
    """A module with so many targets, the same numbers in every shape."""
    rng = random.Random(1)
    targets = []
    for i in range(count):
        x, y, z = (rng.uniform(-900, 900) for _ in range(3))
        targets.append(f"[[{x:.2f},{y:.2f},{z:.2f}],[0,0,1,0],[0,0,0,0],[{i % 2000},9E9,9E9,9E9,9E9,9E9]]")
    lines = ["MODULE big"]
    if shape == "declared":
        lines += [f"CONST robtarget p{i}:={target};" for i, target in enumerate(targets)]
        body = [f"MoveL p{i},v500,z10,tool0;" for i in range(count)]
    elif shape == "inline":
        body = [f"MoveL {target},v500,z10,tool0;" for target in targets]
    else:
        lines.append(f"CONST robtarget p{{{count}}}:=[{','.join(targets)}];")
        body = [f"FOR i FROM 1 TO {count} DO", "MoveL p{i},v500,z10,tool0;", "ENDFOR"]
    return "\n".join([*lines, "PROC main()", *body, "ENDPROC", "ENDMODULE", ""]), targets


def measure(shape, count):
    """Seconds of processor of each step, peak memory [MiB], in this process."""
    from trajopt_cli.cli.process import reading
    from trajopt_cli.motion import TextFile
    from trajopt_cli.rapid.language.parser import parse_module
    from trajopt_cli.rapid.reader import run_program

    text, targets = generate(shape, count)
    steps = {"bytes": len(text)}
    start = process_time()
    json.loads(f"[{','.join(targets)}]")
    steps["json"] = process_time() - start
    del targets
    with reading():  # as the command does
        start = process_time()
        parse_module(text, "big.mod")
        steps["parse"] = process_time() - start
        start = process_time()
        program = run_program([TextFile("big.mod", text, "utf-8")])
        steps["all"] = process_time() - start
    assert len(program.motions) == count
    steps["peak"] = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    return steps


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--targets", type=int, default=100_000)
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--shape", choices=SHAPES, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.shape:
        print(json.dumps(measure(options.shape, options.targets)))
        return
    for shape in SHAPES:
        command = [sys.executable, __file__, "--shape", shape, "--targets", str(options.targets)]
        runs = [json.loads(subprocess.check_output(command)) for _ in range(options.repeat)]
        mid = {key: median(run[key] for run in runs) for key in runs[0]}
        print(
            f"{shape}: {options.targets} targets, {mid['bytes'] / 1e6:.1f} MB: {mid['all']:.2f} s in all, of which "
            f"scan and parse {mid['parse']:.2f} s, interpret {mid['all'] - mid['parse']:.2f} s; {mid['peak']:.0f} MiB; "
            f"json alone {mid['json']:.2f} s, ratio {mid['all'] / mid['json']:.1f}"
        )
    with tempfile.TemporaryDirectory() as folder:
        alone = Path(folder) / SMALL.name
        alone.write_bytes(SMALL.read_bytes())
        # As installed: with bytecode at hand, whatever this environment says about writing it.
        environment = {key: value for key, value in os.environ.items() if key != "PYTHONDONTWRITEBYTECODE"}
        environment["PYTHONPYCACHEPREFIX"] = folder
        for name, program in (("with its cell file", SMALL), ("without", alone)):
            command = [sys.executable, "-m", "trajopt_cli.cli", "parse", str(program)]
            clock, processor = [], []
            for _ in range(1 + max(options.repeat, 5)):
                start, before = perf_counter(), _children()
                subprocess.run(command, check=True, cwd=REPOSITORY, env=environment, stdout=subprocess.DEVNULL)
                clock.append(perf_counter() - start)
                processor.append(_children() - before)
            print(
                f"trajopt parse {SMALL.name}, whole process, {name}: {median(clock[1:]):.2f} s by the clock, "
                f"{median(processor[1:]):.2f} s of processor"
            )


def _children():
    """Seconds of processor of the processes that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


if __name__ == "__main__":
    main()
