"""Fuzzing of everything that trajopt reads.

python tests/fuzz/fuzz_run.py [--minutes M | --cases N] [--reader NAME ...] [--seed S] [--keep FOLDER] [--log FILE]
                         [--feedback way|lines|none] [--again READER FILE] [--shrink READER FILE]

Every reader in turn gets a few seconds: seeds and the corpus with a few things wrong. Each is read by the library;
one in DEEP of those that could be read is also used (judged, fitted, built); one in COMMAND is read by a command in
this process, one in PROCESS by a command in a process of its own. What must not be (fuzz_oracle.py says it) is printed
once for each place, with --keep saved as FOLDER/READER_N, and the exit code is 1. A case whose error took a way through
trajopt that no case took before is a seed from then on; --feedback lines: whose run came to a line that none did.
--again: one case once more, with its traceback; --shrink: cut down to what still is the same finding. Blocks run in
processes of their own, so that a crash is a finding, too.
"""

from __future__ import annotations

import argparse
import faulthandler
import json
import os
import random
import resource
import shutil
import subprocess
import sys
import tempfile
import traceback
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from time import process_time
from types import FrameType
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[2]))  # run from a checkout without installing
sys.path.insert(0, str(Path(__file__).parents[1] / "rapid"))

from fuzz_commands import options_reader
from fuzz_oracle import MEMORY, SECONDS, Ended, command, guarded, judged, set_limits
from fuzz_readers import Reader, readers, workspace

DEEP, COMMAND, PROCESS = 20, 200, 5000  # one case in so many
BLOCK = 500  # cases, where their number is given
SLICE = 3.0  # s of processor that a reader gets in turn, where it is not
POOL = 300  # seeds that a reader may have besides its own
STUCK = 900  # s of the clock after which a block in C code that hears no alarm is ended


@dataclass
class Tally:
    """What became of a reader's cases. pool: those that are seeds from now on; known: the ways taken so far."""

    cases: int = 0
    seconds: float = 0.0
    ended: Counter[str] = field(default_factory=Counter)
    findings: dict[str, list[Any]] = field(default_factory=dict)  # by place: how often, what is told, the case
    pool: list[bytes] = field(default_factory=list)
    known: set[Any] = field(default_factory=set)


def all_readers(folder: Path) -> dict[str, Reader]:
    """Every reader, and the commands' options."""
    here = workspace(folder)
    return {**readers(here), "options": options_reader(here)}


def tried(reader: Reader, data: bytes, folder: Path, how: str = "read") -> Ended:
    """One case in a folder of its own. how: read, deep, command or process."""
    if how == "read" and reader.place is None:
        path = _written(folder / reader.file, data)
    else:
        for one in folder.iterdir():
            if one.is_dir() and not one.is_symlink():
                shutil.rmtree(one)
            else:
                one.unlink()
        path = reader.write(folder, data)
    work = {"read": reader.read, "deep": reader.deep}.get(how)
    if work is not None:
        return heard(guarded(lambda: _done(work(path), how)))
    arguments = reader.command(path)
    there = _names(folder)
    ended = _apart(arguments, folder) if how == "process" else command(arguments)
    if ended.how == "exit 2" and ended.finding is None and (left := _names(folder) - there):
        return judged(f"exit 2, left behind: {', '.join(sorted(left))[:200]}", "", "")
    return ended


def _written(path: Path, data: bytes) -> Path:
    """A new file: to write one that is there anew waits for the disk."""
    path.unlink(missing_ok=True)
    path.write_bytes(data)
    return path


def _done(answer: object, how: str) -> str:
    return answer if isinstance(answer, str) else how


def heard(ended: Ended) -> Ended:
    """A case that has printed something on stderr, which a library in C does past Python, is a finding."""
    if not os.path.isfile("/proc/self/fd/2") or not (size := os.fstat(2).st_size):
        return ended
    os.lseek(2, 0, os.SEEK_SET)
    said = os.pread(2, 3000, 0).decode("utf-8", "replace") if os.access("/proc/self/fd/2", os.R_OK) else ""
    os.ftruncate(2, 0)
    return ended if ended.finding else judged(f"{ended.how}, {size} bytes on stderr", "", said)


def _names(folder: Path) -> set[str]:
    return {str(one.relative_to(folder)) for one in folder.rglob("*") if "__pycache__" not in one.parts}


def _apart(arguments: list[str], folder: Path) -> Ended:
    def bounded() -> None:
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))

    line = [sys.executable, "-m", "trajopt_cli.cli", *arguments]
    root = str(Path(__file__).parents[2])
    path = os.pathsep.join([root, *filter(None, [os.environ.get("PYTHONPATH")])])
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        ended = subprocess.run(
            line, cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=err, preexec_fn=bounded,
            env={**os.environ, "PYTHONPATH": path}, check=False, timeout=40 * SECONDS,
        )  # fmt: skip
        texts = []
        for file in (out, err):
            file.seek(0)
            texts.append(file.read().decode("utf-8", "replace"))
    return judged(f"exit {ended.returncode}", *texts)


class Lines:
    """The lines of trajopt that a case comes to."""

    def __init__(self) -> None:
        self.found: set[tuple[str, int]] = set()
        self._inside: dict[str, bool] = {}

    def __enter__(self) -> Lines:
        self.found = set()
        sys.settrace(self._call)
        return self

    def __exit__(self, *_: object) -> None:
        sys.settrace(None)

    def _call(self, frame: FrameType, event: str, argument: object) -> Any:
        name = frame.f_code.co_filename
        if name not in self._inside:
            self._inside[name] = f"{os.sep}trajopt_cli{os.sep}" in name
        return self._line if self._inside[name] else None

    def _line(self, frame: FrameType, event: str, argument: object) -> Any:
        if event == "line":
            self.found.add((frame.f_code.co_filename, frame.f_lineno))
        return self._line


def block(reader: Reader, rng: random.Random, tally: Tally, most: int, folder: Path, feedback: str = "way") -> None:
    """Run cases of a reader, most or what a SLICE has room for where that is 0, and add them to its tally."""
    start, first, current, lines = process_time(), tally.cases, folder.parent / "current", Lines()
    while tally.cases - first < most if most else process_time() - start < SLICE:
        number = tally.cases
        data = reader.case(rng, [*reader.seeds, *tally.pool] if tally.pool and rng.random() < 0.7 else reader.seeds)
        _written(current, data)
        how = "process" if number % PROCESS == PROCESS - 1 else "command" if number % COMMAND == COMMAND - 1 else "read"
        if feedback == "lines":
            with lines:
                ended = tried(reader, data, folder, how)
            way: set[Any] = lines.found
        else:
            ended = tried(reader, data, folder, how)
            way = set(ended.way) if feedback == "way" else set()
        add(tally, ended, data)
        if way - tally.known and how == "read" and len(data) < 20_000:
            tally.known |= way
            if len(tally.pool) < POOL:
                tally.pool.append(data)
            else:
                tally.pool[rng.randrange(POOL)] = data
        if ended.how == "read" and reader.deep is not None and tally.ended["read"] % DEEP == 1:
            add(tally, tried(reader, data, folder, "deep"), data, more=True)
    tally.seconds += process_time() - start


def add(tally: Tally, ended: Ended, data: bytes, more: bool = False) -> None:
    """Count a case. more: it is counted already, and has been used now."""
    tally.cases += not more
    tally.ended[ended.how] += 1
    if ended.finding is not None:
        known = tally.findings.setdefault(ended.finding.place, [0, ended.finding.told, data])
        known[0] += 1
        if len(data) < len(known[2]):
            known[1:] = ended.finding.told, data


def apart(reader: Reader, rng: random.Random, tally: Tally, count: int, folder: Path, feedback: str) -> Tally:
    """A block in a process of its own; its tally, or the old one with a crash."""
    import pickle

    answer = folder.parent / "answer"
    answer.unlink(missing_ok=True)
    if (child := os.fork()) == 0:
        faulthandler.dump_traceback_later(STUCK, exit=True, file=sys.stdout)
        noise = os.open(folder.parent / "noise", os.O_RDWR | os.O_CREAT | os.O_TRUNC)
        faulthandler.enable(sys.stdout)
        os.dup2(noise, 2)
        try:  # nothing of this process' own may go on here, and clear its folder away
            set_limits(MEMORY)
            os.chdir(folder)
            block(reader, rng, tally, count, folder, feedback)
            answer.write_bytes(pickle.dumps(tally))
        finally:
            if sys.exc_info()[0] is not None:
                traceback.print_exc(file=sys.stdout)
                sys.stdout.flush()
            os._exit(0)
    _, status = os.waitpid(child, 0)
    if answer.exists():
        return pickle.loads(answer.read_bytes())  # type: ignore[no-any-return]
    tally.findings[f"the process has died: {status}"] = [1, str(status), (folder.parent / "current").read_bytes()]
    return tally


def every_way(reader: Reader, data: bytes, folder: Path) -> Iterator[tuple[str, Ended]]:
    """A case read by the library, used, and read by a command in this process."""
    for how in ("read", "deep", "command"):
        if {"read": reader.read, "deep": reader.deep, "command": reader}[how] is not None:
            yield how, tried(reader, data, folder, how)


def shrunk(reader: Reader, data: bytes, folder: Path, how: str, place: str) -> bytes:
    """A case without all that can be left out while it stays the finding of that place."""
    size = max(1, len(data) // 2)
    while size:
        at = 0
        while at < len(data):
            less = data[:at] + data[at + size :]
            ended = tried(reader, less, folder, how)
            if ended.finding is not None and ended.finding.place == place:
                data = less
            else:
                at += size
        size //= 2
    return data


def table(tallies: dict[str, Tally]) -> list[str]:
    """Cases, findings and rate of every reader."""
    out = [f"{'reader':<12} {'cases':>9} {'findings':>9} {'per s of processor':>19}  ended"]
    for name, one in tallies.items():
        rate = one.cases / one.seconds if one.seconds else 0.0
        ends = ", ".join(f"{count} {how}" for how, count in one.ended.most_common(6))
        out.append(f"{name:<12} {one.cases:>9} {len(one.findings):>9} {rate:>19.0f}  {ends}")
    out.append(f"{'all':<12} {sum(one.cases for one in tallies.values()):>9}")
    return out


def keep(folder: Path, name: str, tally: Tally) -> None:
    """Save findings that are not saved yet."""
    folder.mkdir(parents=True, exist_ok=True)
    for number, (place, (_, told, data)) in enumerate(tally.findings.items()):
        base = folder / f"{name.replace(' ', '_')}_{number}"
        base.write_bytes(data)
        base.with_name(f"{base.name}.txt").write_text(f"{place}\n\n{told}", errors="backslashreplace")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--minutes", type=float, default=1.0, help="of processor")
    parser.add_argument("--cases", type=int, help="of each reader, instead")
    parser.add_argument("--reader", action="append", default=[])
    parser.add_argument("--seed", default="1")
    parser.add_argument("--keep", type=Path)
    parser.add_argument("--log", type=Path)
    parser.add_argument("--feedback", choices=("way", "lines", "none"), default="way")
    parser.add_argument("--again", nargs=2, metavar=("READER", "FILE"))
    parser.add_argument("--shrink", nargs=2, metavar=("READER", "FILE"))
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as place:
        base, folder = Path(place) / "workspace", Path(place) / "case"
        base.mkdir()
        folder.mkdir()
        os.environ["XDG_CACHE_HOME"] = place
        known = all_readers(base)
        if options.again or options.shrink:
            name, file = options.again or options.shrink
            data, place = Path(file).read_bytes(), Path(file).absolute()
            os.chdir(folder)
            set_limits()
            for how, ended in every_way(known[name], data, folder):
                print(f"{how}: {ended.how}", f"\n{ended.finding.place}\n{ended.finding.told}" if ended.finding else "")
                if options.shrink and ended.finding is not None:
                    small = shrunk(known[name], data, folder, how, ended.finding.place)
                    place.with_name(f"{place.name}.small").write_bytes(small)
                    print(f"{len(data)} bytes to {len(small)}: {place}.small")
                    return
            return
        chosen = {name: known[name] for name in options.reader or known}
        tallies = {name: Tally() for name in chosen}
        told: set[tuple[str, str]] = set()
        number = 0
        while (
            sum(one.seconds for one in tallies.values()) < 60 * options.minutes
            if options.cases is None
            else any(tally.cases < options.cases for tally in tallies.values())
        ):
            for name, reader in chosen.items():
                left = None if options.cases is None else options.cases - tallies[name].cases
                if left is None or left > 0:
                    count = min(BLOCK, left or 0)
                    rng = random.Random(f"{options.seed}:{name}:{number}")
                    tallies[name] = apart(reader, rng, tallies[name], count, folder, options.feedback)
                for where, (_, text, _) in tallies[name].findings.items():
                    if (name, where) not in told:
                        told.add((name, where))
                        print(
                            f"{name}: {where}: {text.strip().splitlines()[-1][:300] if text.strip() else ''}",
                            flush=True,
                        )
                if options.keep:
                    keep(options.keep, name, tallies[name])
            if options.log:
                record = {name: [one.cases, one.seconds, one.ended] for name, one in tallies.items()}
                options.log.write_text(json.dumps(record))
            number += 1
    print("\n".join(table(tallies)))
    sys.exit(any(one.findings for one in tallies.values()))


if __name__ == "__main__":
    main()
