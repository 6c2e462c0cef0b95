"""What `trajopt doctor` looks at."""

from __future__ import annotations

import platform
import re
import sys
import webbrowser
from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from importlib.metadata import PackageNotFoundError, requires, version
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

from trajopt_cli import __version__
from trajopt_cli.errors import InputError

_OLDEST = (3, 11)  # of Python
_DEVELOPERS = frozenset({"test", "docs"})  # extras that no user needs
_REQUIREMENT = re.compile(r"(?P<name>[\w.-]+)(?P<bounds>[^;]*)(;.*extra == ['\"](?P<extra>[\w-]+)['\"])?")
_LITTLE = 1e9  # bytes of memory, below which long programs may end early
_PROBLEM = """MODULE Small
    CONST jointtarget j_home:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j_side:=[[20,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveAbsJ j_side, v2500, fine, tool0;
        MoveAbsJ j_home, v2500, fine, tool0;
    ENDPROC
ENDMODULE
"""
_CELL = "robot: irb140\nstart: {joints: '[0, 0, 0, 0, 30, 0] deg'}\n"


class State(Enum):
    """ok; missing and not needed for most; or wrong."""

    OK = "ok"
    ABSENT = "absent"
    WRONG = "WRONG"


@dataclass(frozen=True)
class Check:
    """what was looked at, what was found, and what to do, None where there is nothing to do."""

    what: str
    state: State
    found: str
    remedy: str | None = None


def looked_at() -> list[Check]:
    """Everything, in the order of print; the problem is solved only where all packages are there."""
    found = [_trajopt(), _python(), *_packages(), _cache(), _leftovers(), _machine(), _browser()]
    if not any(one.state is State.WRONG for one in found):
        found.append(_solved())
    return found


def _trajopt() -> Check:
    found = f"{__version__} in {Path(__file__).parents[1]}"
    try:
        installed = version("trajopt-cli")
    except PackageNotFoundError:
        installed = __version__
    if installed == __version__:
        return Check("trajopt", State.OK, found)
    remedy = "what follows are the packages of that version; pip install . in the checkout again"
    return Check("trajopt", State.ABSENT, f"{found}, installed as {installed}", remedy)


def _python() -> Check:
    known = f"{platform.python_version()} on {platform.platform()}"
    if sys.version_info >= _OLDEST:
        return Check("Python", State.OK, known)
    return Check("Python", State.WRONG, known, f"install Python {'.'.join(map(str, _OLDEST))} or newer")


def _packages() -> Iterator[Check]:
    """Every package that the distribution asks for, and those of its extras."""
    try:
        asked = requires("trajopt-cli") or []
    except PackageNotFoundError:
        remedy = "packages are not looked at; 'pip install .' in the checkout tells pip what it needs"
        yield Check("packages", State.ABSENT, "trajopt runs from its source and is not installed", remedy)
        return
    for text in asked:
        match = _REQUIREMENT.match(text)
        assert match is not None, text
        name, bounds, extra = match["name"], match["bounds"].strip(" ()"), match["extra"]
        if extra in _DEVELOPERS:
            continue
        what = f"package {name}" if extra is None else f"extra {extra}: {name}"
        remedy = f"pip install 'trajopt-cli[{extra}]'" if extra else f"pip install '{name}{bounds}'"
        state = State.WRONG if extra is None else State.ABSENT
        try:
            there = version(name)
        except PackageNotFoundError:
            yield Check(what, state, "not installed", remedy)
            continue
        if _fits(there, bounds):
            yield Check(what, State.OK, there)
        else:
            yield Check(what, state, f"{there}, needed is {bounds}", remedy)


def _fits(there: str, bounds: str) -> bool:
    """Whether a version keeps bounds such as `>=3.8,<4`, by the numbers it begins with."""

    def numbers(text: str) -> tuple[int, ...]:
        return tuple(int(part) for part in re.findall(r"\d+", re.split(r"[a-z+!-]", text.strip())[0]))

    for bound in filter(None, bounds.split(",")):
        sign, limit = bound[:2].strip("0123456789. "), numbers(bound.lstrip("<>=!~ "))
        if (sign == ">=" and numbers(there) < limit) or (sign == "<" and numbers(there) >= limit):
            return False
    return True


def _cache() -> Check:
    """Where machine code is kept between runs."""
    from trajopt_cli.native.store import users_store

    folder = users_store().folder
    files = [path for path in folder.glob("*") if path.is_file()] if folder.is_dir() else []
    size = f"{sum(path.stat().st_size for path in files) / 1e6:.1f} MB in {len(files)} files"
    nearest = next(path for path in (folder, *folder.parents) if path.exists())
    try:
        with TemporaryDirectory(dir=nearest):
            return Check("cache", State.OK, f"{folder}, {size}")
    except OSError:
        pass
    remedy = "every run translates its expressions anew, some seconds; make it writable or set XDG_CACHE_HOME"
    return Check("cache", State.ABSENT, f"{folder} cannot be written", remedy)


def _leftovers() -> Check:
    """What killed runs left hidden in this folder and its results."""
    from trajopt_cli.runs.files import leftovers

    found = [str(path) for folder in (Path(), Path("results")) for path in leftovers(folder)]
    if not found:
        return Check("leftovers", State.OK, "none in this folder, none in results")
    remedy = "the next run that writes NAME of .NAME.trajopt-... removes it; you may, too, but rename .old to NAME"
    return Check("leftovers", State.ABSENT, f"of runs that were killed: {', '.join(found)}", remedy)


def _machine() -> Check:
    from trajopt_cli.workers import cores

    found, state, remedy = f"{cores()} cores", State.OK, None
    if sys.platform == "linux":
        lines = dict(line.split(":", 1) for line in Path("/proc/meminfo").read_text().splitlines())
        total, free = (1024 * int(lines[name].split()[0]) for name in ("MemTotal", "MemAvailable"))
        found += f", {free / 1e9:.1f} of {total / 1e9:.1f} GB of memory free"
        if free < _LITTLE:
            state, remedy = State.ABSENT, "long programs may need more"
    else:
        remedy = "Linux is tested, other systems are not"
    return Check("machine", state, found, remedy)


def _browser() -> Check:
    """Only shows pages that trajopt writes."""
    try:
        return Check("browser", State.OK, webbrowser.get().__class__.__name__)
    except webbrowser.Error:
        return Check("browser", State.ABSENT, "none found", "open HTML files of results on a machine that has one")


def _solved() -> Check:
    """One joint there and back, whose time is known in closed form, from program text to judged files."""
    from trajopt_cli.job import read_job
    from trajopt_cli.pipeline.optimize import OptimizedJob, optimize_job
    from trajopt_cli.problem.plan import Target

    begin = perf_counter()
    with TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "small.mod").write_text(_PROBLEM, encoding="ascii")
        (folder / "small.yaml").write_text(_CELL, encoding="ascii")
        try:
            job = read_job([folder / "small.mod"])
            answer = optimize_job(job, None, folder / "results", lambda *_: None, jobs=1)
        except (ImportError, InputError, OSError) as error:
            return Check("self-test", State.WRONG, str(error), "reinstall; if that does not help, report this output")
    acceleration = float(job.plant.limits.acceleration[0])
    least = 4 * (20 * 3.141592653589793 / 180 / acceleration) ** 0.5
    if not isinstance(answer, OptimizedJob):
        return Check("self-test", State.WRONG, str(answer), "an error in trajopt; please report this output")
    times = [answer.judged[one].plan.duration for one in Target]
    spent = f"{perf_counter() - begin:.1f} s"
    if all(abs(time - least) < 1e-4 * least for time in times):
        return Check("self-test", State.OK, f"a problem of {least:.4f} s solved, judged and written in {spent}")
    found = f"{times[0]:.4f} and {times[1]:.4f} s found, {least:.4f} s is known"
    return Check("self-test", State.WRONG, found, "an error in trajopt; please report this output")
