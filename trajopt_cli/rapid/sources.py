"""The files of a program: one module, several, a program list, or a folder such as a controller's backup."""

from __future__ import annotations

import os
import re
import resource
import stat
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from trajopt_cli.errors import InputError, InputErrorGroup
from trajopt_cli.motion import TextFile
from trajopt_cli.rapid.language.text import listed, read_text
from trajopt_cli.rapid.program_list import foreign, read_list
from trajopt_cli.warnings import ProgramWarning, WarningKind

SUFFIXES = (".mod", ".prg", ".sys", ".modx", ".sysx")
LIST_SUFFIX = ".pgf"
MAX_FILES = 5_000
MAX_BYTES = 25_000_000
# Bytes of memory that reading takes for one of the text, at most: 80 where every argument is an expression, 120 with
# short assignments alone, 46 with targets written out ("a:=a+1;", "MoveL Offs(p1,1,2,3),...", 4 MB of each).
MEMORY = 120
_PROCESS = 300_000_000  # bytes of address space that the rest of it takes
MAX_ENTRIES = 100_000  # of a folder tree; a whole disk given by mistake ends here
_SYSTEM_SUFFIXES = (".sys", ".sysx")
_NOISE = {"home", "syspar", "backinfo"}  # the parts of a backup that hold no loaded modules
_RECORD = "run.json"  # stands in every folder that trajopt wrote
_OUTSIDE = "{} lead out of it by a link and are not read"
_IN_TASK = ("progmod", "sysmod")
_TASK = re.compile(r"TASK\d+|T_\w+", re.IGNORECASE)


@dataclass(frozen=True)
class Sources:
    """The texts of a program's files in a fixed order, the program's name, and what the user should know of them."""

    files: tuple[TextFile, ...]
    name: str
    warnings: tuple[ProgramWarning, ...] = ()


def _unread(place: Path, text: str) -> ProgramWarning:
    return ProgramWarning(WarningKind.NOT_READ, text, str(place))


def read_sources(paths: Sequence[Path], entry: str = "main") -> Sources:
    """Read the files that paths name: modules, program lists (.pgf), folders.

    A folder is a controller's backup or holds modules in any arrangement; of several tasks in it the one that holds
    the entry is taken. Raises InputError for what is missing, is no RAPID, or is too much, and for several tasks of
    which none stands out.
    """
    if not paths:
        raise InputError("give a RAPID module, several, or the folder that holds them")
    chosen: dict[str, tuple[Path, bool]] = {}  # by real path; whether somebody asked for this very file
    warnings: list[ProgramWarning] = []
    for path in paths:
        for found, asked in _files(path, entry, warnings):
            chosen.setdefault(os.path.realpath(found), (found, asked))
    if len(chosen) > MAX_FILES:
        raise InputError(f"{len(chosen)} modules; at most {MAX_FILES} are supported", file=str(paths[0]))
    _check_sizes([path for path, _ in chosen.values()], paths[0])
    files = []
    for path, asked in chosen.values():
        file = read_text(path)
        what = foreign(file.text)
        if what is None:
            files.append(file)
        elif asked:
            raise InputError(f"is not a RAPID module: it {what}", file=str(path))
        else:
            warnings.append(_unread(path, f"is left out: it is not a RAPID module, it {what}"))
    if not files:
        raise InputError("none of its files is a RAPID module: " + "; ".join(map(str, warnings)), file=str(paths[0]))
    return Sources(tuple(files), name_of(paths), tuple(warnings))


def modules_at(paths: Iterable[Path]) -> Iterator[Path]:
    """The files that a program at these paths may be read from; none where there is nothing, or a results folder."""
    for path in paths:
        listed = path.suffix.lower() == LIST_SUFFIX
        folder = _home(path) if listed else path  # the list's neighbour SYSMOD belongs to it
        if folder.is_dir() and not (folder / _RECORD).is_file():
            yield from _walk(folder, [])
        elif path.is_file():
            yield path


def syspar_of(path: Path) -> Path | None:
    """The folder SYSPAR of the backup that a path is, or lies in below its folder RAPID; None where there is none."""
    inside = [part.parent for part in (path, *path.absolute().parents) if part.name.lower() == "rapid"]
    for backup in (path, *inside):
        with suppress(OSError):
            for folder in sorted(backup.iterdir()) if backup.is_dir() else ():
                if folder.name.lower() == "syspar" and folder.is_dir() and not leads_out(folder, backup):
                    return folder
    return None


def name_of(paths: Sequence[Path]) -> str:
    """The name of a program: of its first file without suffix, or of the folder."""
    first = paths[0]
    return (first.resolve().name or "root") if first.is_dir() else first.stem


def refuse_results(folder: Path) -> None:
    """Raise InputError for a folder that trajopt wrote: its copies of one module are no program."""
    if (folder / _RECORD).is_file():
        raise InputError("is a results folder; the program it was made from lies in its folder input", file=str(folder))


def leads_out(path: Path, folder: Path) -> bool:
    """Whether a file or folder is a link to a place that is not in the folder or below."""
    return path.is_symlink() and not Path(os.path.realpath(path)).is_relative_to(os.path.realpath(folder))


def _home(listed: Path) -> Path:
    """The folder that a program list and its modules lie in: the task's where the list stands in PROGMOD."""
    return listed.parent.parent if listed.parent.name.lower() == "progmod" else listed.parent


def is_module(path: Path) -> bool:
    """Whether a file has the name of a RAPID module."""
    return path.suffix.lower() in SUFFIXES


def is_system(path: Path) -> bool:
    """Whether a module is one that a controller loads with every program: by its folder SYSMOD or its suffix."""
    return path.parent.name.lower() == "sysmod" or path.suffix.lower() in _SYSTEM_SUFFIXES


def _files(path: Path, entry: str, warnings: list[ProgramWarning]) -> list[tuple[Path, bool]]:
    if stat.S_ISDIR(_stat(path).st_mode):
        return [(found, False) for found in _of_folder(path, entry, warnings)]
    if path.suffix.lower() == LIST_SUFFIX:
        _check_regular(path)
        beside = [found for found in _inside(path.parent) if is_system(found)]
        if path.parent.name.lower() == "progmod":
            beside += [found for folder in _folders(path.parent.parent, "sysmod") for found in _inside(folder)]
        if outside := [found for found in beside if leads_out(found, _home(path))]:
            warnings.append(_unread(path.parent, _OUTSIDE.format(_some(outside, _home(path)))))
            beside = [found for found in beside if found not in outside]
        return [(found, True) for found in _of_list(path)] + [(found, False) for found in _sorted(beside)]
    _check_regular(path)
    return [(path, True)]


def _of_list(path: Path) -> list[Path]:
    """The files that a program list names; names are looked up in its own folder, in any case."""
    beside = {found.name.lower(): found for found in reversed(_entries(path.parent))}
    found, missing = [], []
    for name, line in read_list(path):
        place = beside.get(name.lower())
        if place is None or not place.is_file() or leads_out(place, _home(path)):
            what = "which is not in" if place is None or not place.is_file() else "a link that leads out of"
            message = f"lists {name}, {what} {path.parent}; put it there or remove the line"
            missing.append(InputError(message, file=str(path), line=line))
        else:
            found.append(place)
    if missing:
        raise InputErrorGroup(missing) if len(missing) > 1 else missing[0]
    return found


def _of_folder(folder: Path, entry: str, warnings: list[ProgramWarning]) -> list[Path]:
    refuse_results(folder)
    tasks: dict[tuple[str, ...], list[Path]] = {}
    loose: list[Path] = []
    outside: list[Path] = []
    found = _sorted(_walk(folder, outside))
    if outside:
        warnings.append(_unread(folder, _OUTSIDE.format(_some(outside, folder))))
    for path in found:
        task = _task(folder, path)
        (loose if task is None else tasks.setdefault(task, [])).append(path)
    if not any(is_module(path) for files in (loose, *tasks.values()) for path in files):
        raise InputError(
            f"holds no RAPID module: looked for {', '.join(SUFFIXES)} in it and below, but not in HOME, SYSPAR and "
            "BACKINFO",
            file=str(folder),
        )
    tasks = {task: files for task, files in sorted(tasks.items()) if any(is_module(path) for path in files)}
    if not tasks:
        return _program(folder, loose, warnings)
    stray = [path for path in loose if is_module(path)]
    if stray:
        warnings.append(_unread(folder, f"{_some(stray, folder)} stand outside the task's folder and are not read"))
    return _program(folder, tasks[_one_task(folder, tasks, entry, warnings)], warnings)


def _task(folder: Path, path: Path) -> tuple[str, ...] | None:
    """The folder of the task that a file belongs to, as parts of its path; None where there is no such folder."""
    inside = path.relative_to(folder).parts[:-1]
    parts = (folder.resolve().name, *inside)
    names = [part.lower() for part in parts]
    for i, name in enumerate(names):
        if name in _IN_TASK:
            return parts[:i]
        if _TASK.fullmatch(name):
            return parts[: i + 1]
        if name == "rapid" and i + 1 < len(names) and names[i + 1] not in _IN_TASK:
            return parts[: i + 2]
    return None


def _one_task(
    folder: Path, tasks: dict[tuple[str, ...], list[Path]], entry: str, warnings: list[ProgramWarning]
) -> tuple[str, ...]:
    if len(tasks) == 1:
        return next(iter(tasks))
    wanted = re.compile(rf"(?:\A|[\r\n;])\s*(LOCAL\s+)?PROC\s+{re.escape(entry)}\s*\(", re.IGNORECASE)
    modules = {task: [path for path in files if is_module(path)] for task, files in tasks.items()}
    _check_sizes([path for files in modules.values() for path in files], folder)
    holding = [task for task, files in modules.items() if any(wanted.search(read_text(path).text) for path in files)]
    names = {task: "/".join(task[1:]) or task[0] for task in tasks}
    if len(holding) != 1:
        count = f"{len(holding)} of them hold" if holding else "none of them holds"
        raise InputError(
            f"holds {len(tasks)} tasks ({', '.join(names.values())}), and {count} a PROC {entry}; give the folder of "
            "one of them",
            file=str(folder),
        )
    others = ", ".join(name for task, name in names.items() if task != holding[0])
    warnings.append(_unread(folder, f"of its tasks {names[holding[0]]} is read; {others} hold no PROC {entry}"))
    return holding[0]


def _program(folder: Path, files: list[Path], warnings: list[ProgramWarning]) -> list[Path]:
    """The modules of one program: all, or the ones of its program list and the system modules."""
    modules = [path for path in files if is_module(path)]
    lists = [path for path in files if not is_module(path)]
    if not lists:
        return modules
    if len(lists) > 1:
        names = ", ".join(str(path.relative_to(folder)) for path in lists)
        raise InputError(f"holds {len(lists)} program lists ({names}); give one of them", file=str(folder))
    listed = _of_list(lists[0])
    rest = [path for path in modules if path not in listed]
    unlisted = [path for path in rest if not is_system(path)]
    if unlisted:
        warnings.append(_unread(lists[0], f"does not list {_some(unlisted, folder)}, which are not read"))
    return listed + [path for path in rest if is_system(path)]


def _some(paths: Sequence[Path], folder: Path) -> str:
    return listed([str(path.relative_to(folder)) for path in paths], 10)


def _sorted(paths: Iterable[Path]) -> list[Path]:
    """Program modules first, then system modules; each by its path, whatever the file system's order."""
    return sorted(paths, key=lambda path: (is_system(path), path.as_posix().lower(), path.as_posix()))


def _walk(folder: Path, outside: list[Path]) -> Iterator[Path]:
    """Module files and program lists in a folder and below, every real folder once, so that links may go in circles.

    Hidden folders, the noise of a backup and results folders of trajopt are left out; so are links that lead out of the
    folder, which are added to outside.
    """
    count, seen, waiting = 0, {os.path.realpath(folder)}, [folder]
    while waiting:
        inside = _entries(waiting.pop())
        count += len(inside)
        if count > MAX_ENTRIES:
            message = f"holds more than {MAX_ENTRIES} files and folders; give the folder of the program alone"
            raise InputError(message, file=str(folder))
        for path in inside:
            if (is_module(path) or path.suffix.lower() == LIST_SUFFIX) and path.is_file():
                if leads_out(path, folder):
                    outside.append(path)
                else:
                    yield path
                continue
            if path.name.startswith(".") or path.name.lower() in _NOISE or not path.is_dir():
                continue
            real = os.path.realpath(path)
            if real not in seen and not (path / _RECORD).is_file():
                seen.add(real)
                (outside if leads_out(path, folder) else waiting).append(path)


def _inside(folder: Path) -> list[Path]:
    return [path for path in _entries(folder) if is_module(path) and path.is_file()]


def _folders(folder: Path, name: str) -> list[Path]:
    return [path for path in _entries(folder) if path.name.lower() == name and path.is_dir()]


@contextmanager
def _reading(path: Path) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        raise InputError(f"cannot be read: {error.strerror}", file=str(path)) from error


def _entries(folder: Path) -> list[Path]:
    with _reading(folder):
        return sorted(folder.iterdir())


def _check_regular(path: Path) -> None:
    """A file that is there, and no device or pipe, which may have no end."""
    if not stat.S_ISREG(_stat(path).st_mode):
        raise InputError("is not a regular file; save the program in one", file=str(path))


def _stat(path: Path) -> os.stat_result:
    with _reading(path):
        return path.stat()


def _check_sizes(paths: Sequence[Path], given: Path) -> None:
    total = sum(_stat(path).st_size for path in paths)
    size = f"{total / 1e6:.0f} MB of modules"
    if total > MAX_BYTES:
        raise InputError(f"{size}; at most {MAX_BYTES / 1e6:.0f} MB are read, so divide it", file=str(given))
    limit = resource.getrlimit(resource.RLIMIT_AS)[0]
    if limit != resource.RLIM_INFINITY and (most := _PROCESS + MEMORY * total) > limit:
        message = (
            f"{size} may take {most / 1e6:.0f} MB to read, and the process may have {limit / 1e6:.0f} MB (ulimit -v)"
        )
        raise InputError(f"{message}; give it more, or fewer modules", file=str(given))
