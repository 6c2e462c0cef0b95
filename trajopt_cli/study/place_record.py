"""What `place` says and writes: its answer as a table, as plain data, as a map, what to paste, a folder of its own."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

from trajopt_cli.page.answer import answer_page
from trajopt_cli.problem.plan import Target
from trajopt_cli.runs import REPORT
from trajopt_cli.runs.folder import PLACE
from trajopt_cli.runs.record import as_json
from trajopt_cli.study.answers import study_record, write_answer
from trajopt_cli.study.place import Placed, Tried, score
from trajopt_cli.study.places import Site, What
from trajopt_cli.table import TextTable, percent, seconds, tabulate
from trajopt_cli.units import DEG, MM

_KINDS = 5  # motions that are named with how many places fail at them


def place_record(answer: Placed) -> dict[str, Any]:
    """The whole answer as plain data, SI."""
    site, best = answer.site, answer.best
    steps = answer.steps
    return {
        "program": str(site.job.program_path),
        "what": site.in_words,
        "target": answer.target.value,
        "ranges": [
            {
                "key": one.key,
                "unit": "rad" if one.turns else "m",
                "from": one.low,
                "to": one.high,
                "resolution": None if steps is None else steps[i],
            }
            for i, one in enumerate(site.ranges)
        ],
        "compared_by": "full plans" if answer.planned else "first legal motions",
        "present": _record(site, answer.present),
        "best": None if best is None else _record(site, best),
        "gained_s": answer.gained,
        "frame": None if best is None else site.frame(best.offset).tolist(),
        "paste": None if best is None or best is answer.present else site.to_paste(best.offset),
        "tried": len(answer.places),
        "planned": sum(one.planned is not None for one in answer.places.values()),
        "infeasible": len(answer.impossible),
        "stopped": answer.stopped,
        "places": [_record(site, one) for one in answer.places.values()],
    }


def _record(site: Site, one: Tried) -> dict[str, Any]:
    return {
        "offset": {range_.key: value for range_, value in zip(site.ranges, one.offset, strict=True)},
        "cycle_time_s": one.planned,
        "cut_short": one.cut,
        "first_motion_s": one.first,
        "search_estimate_s": one.estimate,
        "why_not": one.why or None,
    }


def write_place(folder: Path, answer: Placed, table: TextTable, lines: Sequence[str] = ()) -> int:
    """Write place.json, its map, a page with the table and the lines, what changes and the inputs; how many files that
    are. Raises InputError where folder may not be replaced."""
    site, job, best = answer.site, answer.site.job, answer.best
    files = {"place.json": as_json(place_record(answer))}
    if best is not None and best is not answer.present:
        name = "changed.mod" if site.what is What.STATION else "changed.yaml"
        files[name] = site.to_paste(best.offset).encode()
    pictures = place_pictures(answer)
    files |= {f"plots/{name}": content for name, content in pictures.items()}
    files[REPORT] = answer_page(f"{job.title}: {site.in_words}", answer.in_words, [table], lines, pictures)
    options = {"what": site.in_words, "target": answer.target.value, "entry": job.program.entry}
    return write_answer(folder, study_record(PLACE), job, files, options)


def place_pictures(answer: Placed) -> dict[str, bytes]:
    """The map of cycle time over place, by file name."""
    from trajopt_cli.report.place import Spot, place_map

    site = answer.site
    spots = [
        Spot(tuple(one.offset), None if one.why else score(one, answer.target), one.planned is not None)
        for one in answer.places.values()
        if one.why or math.isfinite(score(one, answer.target))
    ]
    axes = [(one.key, "deg" if one.turns else "mm", 1 / DEG if one.turns else 1e3) for one in site.ranges]
    best = answer.best
    of = "planned cycle" if answer.target is Target.RAPID else "cycle as the search foretells it"
    title = f"{site.job.title} · {site.in_words} · {answer.target.in_words}"
    return place_map(spots, axes, None if best is None else best.offset, of, title, answer.target.value)


def place_table(program: str, answer: Placed) -> TextTable:
    """The present place, the best one and the others that were planned, the fastest first."""
    site, present, best = answer.site, answer.present, answer.best
    now = answer.seconds(present)
    others = [
        one for one in answer.places.values() if one is not present and one is not best and one.planned is not None
    ]
    rows = [("present", present)] + ([("best", best)] if best is not None and best is not present else [])
    rows += [("", one) for one in sorted(others, key=lambda one: one.planned or 0.0)[:3]]

    def offset(i: int) -> Callable[[tuple[str, Tried]], str]:
        return lambda row: f"{row[1].offset[i] / (DEG if site.ranges[i].turns else MM):.5g}"

    def saved(one: Tried) -> float | None:
        cycle = answer.seconds(one)
        return None if now is None or cycle is None or one is present else now - cycle

    columns: dict[str, Callable[[tuple[str, Tried]], str]] = {"": lambda row: row[0]}
    columns |= {f">{one.key} [{'deg' if one.turns else 'mm'}]": offset(i) for i, one in enumerate(site.ranges)}
    columns |= {
        ">cycle [s]": lambda row: seconds(answer.seconds(row[1]), "cannot be done"),
        ">saves [s]": lambda row: seconds(saved(row[1])),
        ">of it": lambda row: "" if (gain := saved(row[1])) is None or not now else percent(gain / now),
    }
    return tabulate(f"{program}, {answer.target.value}: where {site.in_words} stands", rows, columns)


def impossible_lines(answer: Placed) -> Iterator[str]:
    """How many places cannot be done, at which motions, and why at the nearest one."""
    bad = answer.impossible
    if not bad:
        return
    named = Counter(one.motion or one.why.split(":")[0] for one in bad)
    kinds = ", ".join(f"{name} ({count})" for name, count in named.most_common(_KINDS))
    yield f"{len(bad)} of {len(answer.places)} places cannot be done: {kinds}"
    yield f"{said(answer.site, bad[0])}: {bad[0].why}"


def said(site: Site, one: Tried) -> str:
    """Which place that is."""
    return "the present place" if not any(one.offset) else f"the nearest, {site.shown(one.offset)}"
