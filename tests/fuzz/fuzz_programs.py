"""Many small programs, resumable.

python tests/fuzz/fuzz_programs.py LOG.jsonl [--seed S] [--first A] [--last B] [--minutes M]

A line of LOG for each program: its number, how it ended, processor seconds; numbers in it are not run again, so the
same command goes on where it was ended. Each runs within 30 s of processor and 1 GB more memory than the interpreter
needs; the table is printed at the end, and by --table alone. --first A --last A runs one; --minutes: of processor, at
most, for this call.
"""

from __future__ import annotations

import argparse
import gc
import json
import math
import os
import resource
import shutil
import signal
import sys
import tempfile
import traceback
from collections import Counter
from functools import cache
from pathlib import Path
from time import process_time

sys.path.insert(0, str(Path(__file__).parents[2]))  # run from a checkout without installing

from small_programs import program, round_trip

SECONDS = 30  # of processor
MEMORY = 1 << 30  # bytes more than at the start
CHUNK = 40  # programs in one process: memory that libraries keep does not add up


class Hang(Exception):
    """A program took too long."""


def alarm(number: int, frame: object) -> None:
    raise Hang


def one(seed: int, number: int) -> dict[str, object]:
    """One program: how it ended."""
    folder = Path(tempfile.mkdtemp())
    start = process_time()
    signal.setitimer(signal.ITIMER_PROF, SECONDS)
    try:
        ended = round_trip(program(seed, number), folder)
    except BaseException as error:
        if isinstance(error, KeyboardInterrupt):
            raise
        where = traceback.extract_tb(error.__traceback__)[-1]
        ended = f"FINDING {type(error).__name__}: {str(error).replace(str(folder), '')[:400]} ({where.name})"
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        shutil.rmtree(folder)
    return {"seed": seed, "number": number, "ended": ended, "seconds": round(process_time() - start, 2)}


def chunk(seed: int, numbers: list[int], log: Path) -> None:
    """Some programs in a process of their own."""
    from trajopt_cli.robot import catalogue

    catalogue.read_robot_file = cache(catalogue.read_robot_file)  # the files that ship do not change
    signal.signal(signal.SIGPROF, alarm)
    size = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (size + MEMORY,) * 2)
    with log.open("a", encoding="utf-8") as file:
        for number in numbers:
            file.write(json.dumps(one(seed, number)) + "\n")
            file.flush()


def done(log: Path) -> list[dict[str, object]]:
    return [json.loads(line) for line in log.read_text().splitlines()] if log.exists() else []


def table(log: Path) -> bool:
    """Print how many ended how; whether any of them is a finding."""
    rows = done(log)
    ends = Counter(str(row["ended"]) if "FINDING" not in str(row["ended"]) else "FINDING" for row in rows)
    seconds = sum(float(str(row["seconds"])) for row in rows)
    print(f"{len(rows)} programs, {seconds:.0f} s of processor: " + ", ".join(f"{n} {end}" for end, n in ends.items()))
    for row in rows:
        if "FINDING" in str(row["ended"]):
            print(f"  {row['number']}: {row['ended']}")
    return "FINDING" in ends


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("log", type=Path)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--last", type=int, default=9999)
    parser.add_argument("--minutes", type=float, default=math.inf)
    parser.add_argument("--table", action="store_true")
    options = parser.parse_args()
    if not options.table:
        known = {(row["seed"], row["number"]) for row in done(options.log)}
        left = [n for n in range(options.first, options.last + 1) if (options.seed, n) not in known]
        while left and sum(resource.getrusage(resource.RUSAGE_CHILDREN)[:2]) < 60 * options.minutes:
            if (child := os.fork()) == 0:
                gc.freeze()  # what is loaded is no garbage
                chunk(options.seed, left[:CHUNK], options.log)
                os._exit(0)
            os.waitpid(child, 0)
            known = {(row["seed"], row["number"]) for row in done(options.log)}
            rest = [n for n in left if (options.seed, n) not in known]
            if len(rest) == len(left) or len(left) - len(rest) < min(CHUNK, len(left)):  # the process has died
                died = {
                    "seed": options.seed,
                    "number": rest[0],
                    "ended": "FINDING the process has died",
                    "seconds": 0.0,
                }
                with options.log.open("a", encoding="utf-8") as file:
                    file.write(json.dumps(died) + "\n")
                rest = rest[1:]
            left = rest
    sys.exit(table(options.log))


if __name__ == "__main__":
    main()
