"""The page of `trajopt compare runs`: cycle times as bars, motions over time, what differs in times, limits, inputs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from trajopt_cli.page.document import Section, document
from trajopt_cli.page.encode import text
from trajopt_cli.page.tables import points, table
from trajopt_cli.problem.plan import Target
from trajopt_cli.runs.compared import ComparedRuns, Motion, MotionRow, OneRun

_WIDE, _LEFT, _BAR, _GAP = 1000, 60, 22, 12  # of drawings, in units of their own; left of them the letters
_CLASSES = {"MoveL": "line", "MoveC": "arc", "MoveExtJ": "rail", "MoveJ": "joint", "MoveAbsJ": "joint"}
_KINDS = {"line": "lines", "arc": "arcs", "joint": "joint moves", "rail": "external axes alone", "wait": "waits"}


def runs_page(answer: ComparedRuns) -> bytes:
    """The page's bytes, the same for the same comparison."""
    sections = [
        Section(
            "times",
            "Cycle times",
            _cycles(answer),
            "Differences count against A. The line across a bar is its lower bound.",
        ),
        Section("gantt", f"Motions of the {answer.target} plans over time", _gantt(answer), _key(answer)),
        Section("motions", "Times by motion", _motions(answer), "The largest difference first."),
        Section("limits", "Motions held back by different limits", _bindings(answer)),
        Section("inputs", "What was different", _inputs(answer)),
    ]
    runs = "".join(f"<dt>{run.letter}</dt><dd>{text(str(run.folder))}, {_modules(run)}</dd>" for run in answer.runs)
    notes = points(answer.notes)
    head = f'<h1>{len(answer.runs)} runs side by side</h1><dl class="facts">{runs}</dl>{notes}'
    return document("Runs side by side · trajopt", head, sections, {}, ("runs.css",))


def _modules(run: OneRun) -> str:
    return text(", ".join(run.inputs.modules))


def _cycles(answer: ComparedRuns) -> str:
    """Bars of both targets' cycle times with their bounds, and the same as a table."""
    bars = [(target, run) for target in Target for run in answer.runs]
    scale = (_WIDE - _LEFT - 190) / max(max(run.plans[target].cycle for target, run in bars), 1e-9)
    drawn, rows = [], []
    for i, (target, run) in enumerate(bars):
        plan, first = run.plans[target], answer.runs[0].plans[target]
        y = i * (_BAR + _GAP) + (i >= len(answer.runs)) * _GAP
        left = _LEFT + 60
        kind = "joint" if target is answer.target else "wait"
        drawn.append(f'<text x="0" y="{y + 16}">{target} {run.letter}</text>')
        drawn.append(f'<rect class="{kind}" x="{left}" y="{y}" width="{plan.cycle * scale:.2f}" height="{_BAR}"/>')
        if plan.bound is not None:
            drawn.append(f'<path class="least" d="M{left + plan.bound * scale:.2f} {y - 3}v{_BAR + 6}"/>')
        drawn.append(f'<text x="{left + plan.cycle * scale + 8:.2f}" y="{y + 16}">{plan.cycle:.3f} s</text>')
        bound = "" if plan.bound is None else f"{plan.bound:.3f} s"
        gap = "" if plan.gap is None else f"{100 * plan.gap:.1f} %"
        change = "" if run is answer.runs[0] else f"{_signed(plan.cycle - first.cycle)} s"
        legal = "legal" if plan.judge.legal else "not legal"
        rows.append((f"{target} plan", run.letter, f"{plan.cycle:.3f} s", bound, gap, change, legal))
    for run in answer.runs:
        rows.append(("as written", run.letter, "" if run.written is None else f"{run.written:.3f} s", "", "", "", ""))
    heads = ("plan", "run", ">cycle", ">lower bound", ">gap", ">against A", "judge")
    high = len(bars) * (_BAR + _GAP) + _GAP
    return _svg(drawn, high, "Cycle times of all runs") + table("Cycle times of all runs", heads, rows)


def _gantt(answer: ComparedRuns) -> str:
    """The motions of each run over one time, a row per run."""
    longest = max(run.plans[answer.target].cycle for run in answer.runs)
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


def _motions(answer: ComparedRuns) -> str:
    heads = ["place", "motion", *(f">{run.letter} [s]" for run in answer.runs), ">longest − shortest [s]"]
    rows = [
        (row.any.place, row.any.name, *(_time(one) for one in row.motions), f"{row.spread:.3f}")
        for row in sorted(answer.rows, key=lambda row: -row.spread)
    ]
    return table(f"Times of the motions of the {answer.target} plans", heads, rows)


def _time(one: Motion | None) -> str:
    return "not there" if one is None else "dropped" if one.dropped else f"{one.time_s:.3f}"


def _bindings(answer: ComparedRuns) -> str:
    rows = [(row.any.place, row.any.name, *_told(row)) for row in answer.bound_otherwise]
    if not rows:
        return "<p>None: what is in all runs is held back by the same limits.</p>"
    return table("What limits each", ["place", "motion", *(run.letter for run in answer.runs)], rows)


def _told(row: MotionRow) -> Iterator[str]:
    return ("–" if one is None else one for one in row.bindings)


def _inputs(answer: ComparedRuns) -> str:
    heads = ["what", *(run.letter for run in answer.runs)]
    rows: list[Sequence[str]] = [
        (f"{one.kind or 'limit'} {one.name}", *("–" if value is None else value for value in one.values))
        for one in (*answer.limits, *answer.inputs)
    ]
    out = table("Cell file, limits in force, options, versions", heads, rows) if rows else ""
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


def _signed(seconds: float) -> str:
    return f"{seconds:+.3f}".replace("-", "−")
