"""The page of `trajopt compare runs`: cycle times as bars, motions over time, what differs in times, limits, inputs."""

from __future__ import annotations

from collections.abc import Sequence

from trajopt_cli.page.document import Section, document
from trajopt_cli.page.encode import text
from trajopt_cli.page.tables import drawn, points
from trajopt_cli.problem.plan import Target
from trajopt_cli.runs.compared import ComparedRuns
from trajopt_cli.runs.compared_tables import bindings_table, cycles_table, inputs_table, motions_table

_WIDE, _LEFT, _BAR, _GAP = 1000, 60, 22, 12  # of drawings, in units of their own; left of them the letters
_ALIKE = "None: what is in all runs is held back by the same limits."
_CLASSES = {"MoveL": "line", "MoveC": "arc", "MoveExtJ": "rail", "MoveJ": "joint", "MoveAbsJ": "joint"}
_KINDS = {"line": "lines", "arc": "arcs", "joint": "joint moves", "rail": "external axes alone", "wait": "waits"}


def runs_page(answer: ComparedRuns) -> bytes:
    """The page's bytes, the same for the same comparison."""
    ordered = sorted(answer.rows, key=lambda row: -row.spread)
    bound = drawn(bindings_table(answer)) if answer.bound_otherwise else ""
    sections = [
        Section(
            "times",
            "Cycle times",
            _cycles(answer),
            "Differences count against A. The line across a bar is its lower bound.",
        ),
        Section("gantt", f"Motions of the {answer.target} plans over time", _gantt(answer), _key(answer)),
        Section("motions", "Times by motion", drawn(motions_table(answer, ordered)), "The largest difference first."),
        Section("limits", "Motions held back by different limits", bound or f"<p>{_ALIKE}</p>"),
        Section("inputs", "What was different", _inputs(answer)),
    ]
    runs = "".join(
        f"<dt>{run.letter}</dt><dd>{text(str(run.folder))}, {text(', '.join(run.inputs.modules))}</dd>"
        for run in answer.runs
    )
    notes = points(answer.notes)
    head = f'<h1>{len(answer.runs)} runs side by side</h1><dl class="facts">{runs}</dl>{notes}'
    return document("Runs side by side · trajopt", head, sections, {}, ("runs.css",))


def _cycles(answer: ComparedRuns) -> str:
    """Bars of both targets' cycle times with their bounds, and the same as a table."""
    bars = [(target, run) for target in Target for run in answer.runs]
    scale = (_WIDE - _LEFT - 190) / max(max(run.plans[target].cycle_time_s for target, run in bars), 1e-9)
    drawn_, left = [], _LEFT + 60
    for i, (target, run) in enumerate(bars):
        plan, y = run.plans[target], i * (_BAR + _GAP) + (i >= len(answer.runs)) * _GAP
        kind = "joint" if target is answer.target else "wait"
        drawn_.append(f'<text x="0" y="{y + 16}">{target} {run.letter}</text>')
        drawn_.append(
            f'<rect class="{kind}" x="{left}" y="{y}" width="{plan.cycle_time_s * scale:.2f}" height="{_BAR}"/>'
        )
        if plan.lower_bound_s is not None:
            drawn_.append(f'<path class="least" d="M{left + plan.lower_bound_s * scale:.2f} {y - 3}v{_BAR + 6}"/>')
        drawn_.append(
            f'<text x="{left + plan.cycle_time_s * scale + 8:.2f}" y="{y + 16}">{plan.cycle_time_s:.3f} s</text>'
        )
    high = len(bars) * (_BAR + _GAP) + _GAP
    return _svg(drawn_, high, "Cycle times of all runs") + drawn(cycles_table(answer))


def _gantt(answer: ComparedRuns) -> str:
    """The motions of each run over one time, a row per run."""
    longest = max(run.plans[answer.target].cycle_time_s for run in answer.runs)
    scale = (_WIDE - _LEFT) / max(longest, 1e-9)
    high = len(answer.runs) * (_BAR + _GAP)
    drawn = []
    step = next(s for s in (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 1e3, 1e4, 1e5) if longest / s <= 12 or s == 1e5)
    for k in range(int(longest / step) + 1):
        x = _LEFT + k * step * scale
        drawn.append(
            f'<path class="tick" d="M{x:.2f} 0V{high}"/><text x="{x:.2f}" y="{high + 16}">{k * step:g} s</text>'
        )
    for i, run in enumerate(answer.runs):
        y = i * (_BAR + _GAP) + _GAP / 2
        drawn.append(f'<text x="0" y="{y + 16}">{run.letter}</text>')
        for one in run.plans[answer.target].motions:
            if one.time_s > 0:
                told = text(f"{one.name}, {one.place}: {one.time_s:.3f} s, {one.binding}")
                drawn.append(
                    f'<rect class="{_CLASSES.get(one.instruction, "wait")}" x="{_LEFT + one.start_s * scale:.2f}" '
                    f'y="{y}" width="{one.time_s * scale:.2f}" height="{_BAR}"><title>{told}</title></rect>'
                )
    return _svg(drawn, high + 24, f"Motions of the {answer.target} plans over time")


def _key(answer: ComparedRuns) -> str:
    """Which colours the drawing has, in words: a pointer over a bar tells its motion."""
    used = {_CLASSES.get(m.instruction, "wait") for run in answer.runs for m in run.plans[answer.target].motions}
    colours = {"line": "vermillion", "arc": "purple", "joint": "blue", "rail": "green", "wait": "grey"}
    told = ", ".join(f"{colours[kind]}: {_KINDS[kind]}" for kind in _KINDS if kind in used)
    return f"{told}. A pointer on a bar tells its motion."


def _inputs(answer: ComparedRuns) -> str:
    table = inputs_table(answer)
    out = drawn(table) if table.rows else ""
    for letter, changes in answer.modules.items():
        for one in changes:
            diff = text("\n".join(one.diff))
            out += f"<p>{text(one.name)}: {letter} has +{one.added} −{one.removed} lines against A.</p>"
            out += f'<pre class="diff">{diff}</pre>'
    return out or "<p>Nothing: program, cell file, options and versions are the same.</p>"


def _svg(drawn: Sequence[str], high: float, label: str) -> str:
    box = f"0 0 {_WIDE} {high:g}"
    svg = f'<svg class="gantt" viewBox="{box}" role="img" aria-label="{text(label)}">{"".join(drawn)}</svg>'
    return f'<div class="scroll" role="region" aria-label="{text(label)}" tabindex="0">{svg}</div>'
