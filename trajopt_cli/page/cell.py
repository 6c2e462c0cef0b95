"""The parts that pages of a cell's motions have in common: cycles side by side, their charts, motions and source."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import PurePath
from typing import Any

from trajopt_cli.motion import Program
from trajopt_cli.page.cycles import MOST_REACHES, Shown, axes_data, cycle_data, motions_data, programs_of, reach_data
from trajopt_cli.page.document import Section
from trajopt_cli.page.encode import text
from trajopt_cli.page.scene import HOLDER, SCRIPTS, plant_scene
from trajopt_cli.page.tables import numbers, table
from trajopt_cli.problem.constant_speed import DIP, Dip
from trajopt_cli.problem.detours import way_told
from trajopt_cli.problem.plan import Plan
from trajopt_cli.problem.plant import Plant
from trajopt_cli.runs.summary import SETTLING, motion_label
from trajopt_cli.scene import plan_cycle, program_points
from trajopt_cli.table import place, seconds, short_target
from trajopt_cli.units import MM

SCRIPTS_OF_CELL = ("cycle.css", "gantt.js", "cycle.js", *SCRIPTS)
MOST_MOTIONS = 2_000
"""Motions in the table; summary.json has all of any program."""
_FEW, _MANY = 4, 3
"""More cycles than the first have rows as many times as far apart as the second says."""
_DIPS = 200  # in a table; summary.json has all of them
WHOLE = 2_000  # lines of a module that is shown from end to end
AROUND = 6  # lines before and after a motion, where the module is longer
_LINES = 4_000  # of source in all
_HEADS = ("place", "instruction", "target")


def cell_data(
    plant: Plant, user: Program, shown: Sequence[Shown], at_first: Sequence[int], reach_of: Plan | None
) -> dict[str, Any]:
    """All that the scripts read. user: the program as given. shown: the cycles, at_first: which one or two stand beside
    each other. reach_of: a plan of the user's program, for the reach of its points."""
    programs, which = programs_of(user, shown)
    files = [*dict.fromkeys(path for one in programs for path in one.files)]
    points = [] if reach_of is None else program_points(user, reach_of, plant)
    reach = None if reach_of is None else reach_data(plant, user, reach_of)
    scene = plant_scene(plant, points, [plan_cycle(one.name, one.program, one.plan, plant) for one in shown])
    for i, cycle in enumerate(scene["cycles"]):
        cycle |= {name: {"same": [i, name]} for name in ("t", "q")}  # the same motion: once is enough
    coarse = _MANY if len(shown) > _FEW else 1
    return {
        "clock": {
            "duration": max(one.plan.duration for one in shown),
            "cycles": [{"name": one.name, "duration": one.plan.duration} for one in shown],
            "shown": list(at_first),
        },
        "axes": axes_data(plant),
        "cap": plant.tcp.speed,
        "cycles": [cycle_data(plant, one, i, coarse) for one, i in zip(shown, which, strict=True)],
        "programs": [motions_data(one, files) for one in programs],
        "sources": sources_data(programs, files),
        "reach": reach or {"ranges": {}, "asked": {}, "left_out": 0},
        "scene": scene,
    }


def motion_section() -> Section:
    """Rail, arm, path and obstacles, playing; motions and dwells over time."""
    gantt = '<figure class="chart" id="gantt"></figure>'
    keys = (
        '<p class="lead keys">Space plays, arrow keys step 10 ms, with Shift 100 ms, n and p go to the next and the '
        "previous motion; all charts and the lines of the program follow.</p>"
    )
    html = f'{HOLDER}<div class="controls" id="choice"></div><div id="now"></div>{keys}{gantt}'
    return Section("motion", "Motion", html)


def program_section(user: Program, shown: Sequence[Shown], at_first: Sequence[int]) -> Section:
    """Per motion its times and what limits it, beside the program's text."""
    first = [shown[i] for i in at_first]
    html = (
        f'<div class="pair">{_motions(user, first)}<div id="source" class="own-keys" role="region" tabindex="0" '
        'aria-label="The program"></div></div>'
    )
    lead = "A click on a motion or on its line goes to its beginning. Beside the lines: what they save or cost."
    return Section("program", "Motions and their lines", html, lead)


def chart_sections(plant: Plant, data: Mapping[str, Any], shown: Sequence[Shown]) -> list[Section]:
    """Axes against their limits, the rail, the tool's speed and where it should have been kept."""
    rest = '<li class="swatch rest">wait</li>'
    dips = any(cycle["dips"] for cycle in data["cycles"])
    dip = '<li class="swatch dip">slower than it should keep</li>' if dips else ""
    axes = Section(
        "axes",
        "Axes",
        '<div class="controls" id="axes-choice"></div><div class="charts" id="axes-charts"></div>'
        f'<ul class="legend">{rest}</ul>',
        keys="Drag over a chart to enlarge a stretch of time, in all charts at once; double click or key 0 shows the "
        "whole cycle again. Keys + and −, pinching, Ctrl and the wheel zoom, too.",
    )
    speed = Section(
        "speed",
        "Tool speed",
        '<figure class="chart" id="tcp-chart"></figure><ul class="legend"><li class="swatch speed">programmed, at most '
        f"the cap</li>{dip}{rest}</ul>{''.join(map(kept_speed, shown))}",
    )
    if plant.layout.r != 1:
        return [axes, speed]
    more = data["reach"]["left_out"]
    left_out = f" Of the first {MOST_REACHES} poses; {more} more moves have none." if more else ""
    rail = Section(
        "rail",
        "Rail",
        '<figure class="chart" id="rail-chart"></figure><ul class="legend"><li class="swatch reach">from there the '
        'point is in reach</li><li class="swatch asked">as programmed</li>'
        f"{rest}</ul>",
        f"At the time each point is reached: from where on the rail the arm reaches it, joint limits kept.{left_out}",
    )
    return [axes, rail, speed]


def _motions(user: Program, shown: Sequence[Shown]) -> str:
    """The table; the scripts put other cycles' numbers into the same cells. A cycle of another program has none."""
    two = len(shown) > 1
    names = [
        *(f"{one.name} [s]" for one in shown),
        *(["saved [s]"] if two else []),
        f"what limits the {shown[-1].name}",
    ]
    found = [{m.index: m for m in one.plan.motions} if one.program is user else {} for one in shown]
    detours = shown[-1].plan.detours if shown[-1].program is user else ()
    told = {detour.motion: way_told(len(detour.points), detour.around) for detour in detours}
    rows = []
    for index in range(min(len(user.motions), MOST_MOTIONS)):
        planned = [one.get(index) for one in found]
        spent = [None if m is None or m.dropped else m.t_1 - m.t_0 for m in planned]
        cells = ["dropped" if m is not None and m.dropped else "–" if t is None else seconds(t)
                 for m, t in zip(planned, spent, strict=True)]  # fmt: skip
        if two:
            before, after = planned
            known = before is not None and after is not None and spent[0] is not None
            cells.append(seconds((spent[0] or 0.0) - (spent[1] or 0.0)).replace("-", "−") if known else "")
        instruction, target = motion_label(user, index)
        source = user.motions[index].source
        way = f' <span class="quiet">{text(told[index])}</span>' if index in told else ""
        rows.append(
            f'<tr data-motion="{index}"><td><button type="button">{text(place(source))}</button></td>'
            f'<td>{text(instruction)}</td><td title="{text(target)}">{text(short_target(target))}{way}</td>'
            f"{''.join(numbers(*cells))}"
            f"<td>{text(planned[-1].binding if planned[-1] is not None and instruction != SETTLING else '')}</td></tr>"
        )
    ends = [seconds(one.plan.duration) for one in shown]
    if two:
        ends.append(seconds(shown[0].plan.duration - shown[1].plan.duration).replace("-", "−"))
    head = "".join(f'<th scope="col">{name}</th>' for name in _HEADS)
    head += "".join(f'<th scope="col" class="n">{text(name)}</th>' for name in names[:-1])
    foot = "".join(numbers(*ends))
    cut = f"; the first {MOST_MOTIONS} of them" if len(user.motions) > MOST_MOTIONS else ""
    return (
        '<div class="scroll own-keys" id="motions" role="region" aria-label="Motions" tabindex="0"><table>'
        f'<caption class="quiet">Every motion{cut}</caption><thead><tr>{head}'
        f'<th scope="col">{text(names[-1])}</th></tr></thead>'
        f"<tbody>{''.join(rows)}</tbody><tfoot><tr><td>cycle</td><td></td><td></td>{foot}<td></td></tr></tfoot>"
        "</table></div>"
    )


def kept_speed(one: Shown) -> str:
    """A table of the dips of one cycle, or that there are none; nothing where no stretch should keep its speed."""
    if not one.stretches:
        return ""
    dips = [dip for stretch in one.stretches for dip in stretch.dips]
    way = sum(stretch.length for stretch in one.stretches) / MM
    said = f"{one.name}: {way:.1f} mm should keep the programmed speed"
    if not dips:
        return f"<p>{said}, and do within {100 * DIP:g} %.</p>"
    caption = f"{said} within {100 * DIP:g} %; where they do not" + (
        f", the {_DIPS} longest" if len(dips) > _DIPS else ""
    )
    heads = ("place", "motion", ">at [mm]", ">programmed [mm/s]", ">slowest [mm/s]", ">for [s]", ">over [mm]", "cause")
    worst = sorted(dips, key=lambda dip: -dip.length)[:_DIPS]
    return table(caption, heads, map(_row, sorted(worst, key=lambda dip: dip.start)))


def _row(dip: Dip) -> tuple[str, ...]:
    return (
        place(dip.source),
        dip.name,
        f"{dip.along / MM:.1f}",
        f"{dip.programmed / MM:.4g}",
        f"{dip.lowest / MM:.4g}",
        f"{dip.duration:.3f}",
        f"{dip.length / MM:.1f}",
        dip.cause,
    )


def sources_data(programs: Sequence[Program], files: Iterable[str]) -> list[dict[str, Any]]:
    """Each file by its name, with stretches of lines: [first line, [text, ...]]. cut: whether motions are left out.

    A module that holds no motion is left out; its index stays.
    """
    out, room = [], _LINES
    for path in files:
        content = next(one.files[path].text for one in programs if path in one.files)
        lines = content.split("\n")
        moving = {m.source.line for one in programs for m in one.motions if m.source.file == path}
        wanted = _wanted(len(lines), moving) if moving else []
        shown = wanted[:room]
        room -= len(shown)
        out.append(
            {
                "name": PurePath(path).name,
                "parts": [[a, [line.rstrip("\r") for line in lines[a - 1 : b]]] for a, b in _stretches(shown)],
                "cut": len(shown) < len(wanted),
            }
        )
    return out


def _wanted(count: int, moving: set[int]) -> list[int]:
    if count <= WHOLE:
        return list(range(1, count + 1))
    near = {line for at in moving for line in range(at - AROUND, at + AROUND + 1)}
    return sorted(line for line in near if 1 <= line <= count)


def _stretches(lines: Sequence[int]) -> list[tuple[int, int]]:
    """First and last of each run of neighbours."""
    out: list[tuple[int, int]] = []
    for line in lines:
        out = [*out[:-1], (out[-1][0], line)] if out and line == out[-1][1] + 1 else [*out, (line, line)]
    return out
