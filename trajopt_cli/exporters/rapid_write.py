"""A plan's wishes written into a program: edits in place, new targets, and a module of statements written out."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.rapid_check import rail_moves
from trajopt_cli.exporters.rapid_flat import FlatModule, FlatMotion
from trajopt_cli.exporters.rapid_points import Point, point_lines, put_above
from trajopt_cli.exporters.rapid_points import point as made_point
from trajopt_cli.exporters.rapid_targets import TargetEdit, Targets, same_rail
from trajopt_cli.exporters.rapid_text import Edits, Names, plain, refusal
from trajopt_cli.motion import (
    Motion,
    Move,
    MoveAbsJ,
    MoveExtJ,
    MoveJ,
    PoseMove,
    Source,
    Span,
    TextFile,
    Wait,
)
from trajopt_cli.problem.data_flow import ROBOT, Key
from trajopt_cli.problem.detours import JointMove, quoted
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.editable_text import EditableText, confdata_counts
from trajopt_cli.problem.move_call import MoveCall, last_argument, read_move
from trajopt_cli.problem.plan import PlannedMotion
from trajopt_cli.problem.single_runs import SingleRun, outermost
from trajopt_cli.robot.inverse import confdata_admits
from trajopt_cli.warnings import ProgramWarning, WarningKind

# A target that has the external axes and the configuration of the one that it names.
_MOVED_POINT = re.compile(
    r"(\w+:=\s*)?((Offs|RelTool)\s*\(\s*)*\w+(\s*\{\s*\d+\s*\})?\s*([,)].*)?", re.IGNORECASE | re.DOTALL
)


@dataclass(frozen=True)
class RapidExport:
    """texts: every file of the program by path, to be encoded as its TextFile says. notes: what users should know.

    new: modules to be added, by the path beside the program's own that each is meant for.
    """

    texts: Mapping[str, str]
    notes: tuple[ProgramWarning, ...] = ()
    new: Mapping[str, TextFile] = field(default_factory=dict)


@dataclass(frozen=True)
class Intent:
    """What shall become of one motion.

    wish: of a move's target; planned: how the move is planned. dwell: of a wait in which the rail moves, how it is
    planned. points: additional joint moves before a joint move.
    """

    wish: TargetEdit | None = None
    planned: PlannedMotion | None = None
    drop: bool = False
    fast: bool = False
    dwell: PlannedMotion | None = None
    points: tuple[JointMove, ...] = ()


@dataclass(frozen=True)
class _Action:
    """What happens to one statement. point, dwell: names of targets it must refer to, or that stand in for a wait.
    points: additional ones before it."""

    drop: bool = False
    point: str | None = None
    fast: bool = False
    dwell: str | None = None
    monitored: bool = False
    points: tuple[Point, ...] = ()


def write(text: EditableText, intents: Mapping[int, Intent]) -> RapidExport:
    """The edited program. Raises InputError, with the place, for a statement that cannot do what is wished."""
    flat: list[SingleRun] = []
    while True:
        attempt = _Attempt(text, intents, flat)
        conflicts = attempt.conflicts()
        if not conflicts:
            return attempt.result()
        for index in conflicts:
            run = next((one for one in text.flat if one.first <= index < one.last), None)
            if run is None:
                raise attempt.refused(index)
            flat.append(run)
        flat = outermost(flat)


class _Attempt:
    """The program with some statements written out, and all others edited in place."""

    def __init__(self, text: EditableText, intents: Mapping[int, Intent], flat: Sequence[SingleRun]):
        self._text, self._program, self._plant, self._scopes = text, text.program, text.plant, text.scopes
        self._intents, self._flat = intents, flat
        self._edits, self._names = Edits(self._program.files), Names(self._program.files)
        self._targets = Targets(self._program, self._plant, self._edits, self._names, self._scopes, text.pinned)
        self._notes: list[ProgramWarning] = []
        self._monitored: list[Source] = []
        self._actions: dict[Span, list[tuple[int, _Action]]] = {}
        covered = {index for run in flat for index in range(run.first, run.last)}
        # Statements that cannot refer to a second target first, so the literal is theirs.
        order = sorted((i for i in sorted(intents) if i not in covered), key=lambda i: not self._is_bound(i))
        self._own, self._unsaid = self._computed(order)
        for index in order:
            span = self._program.motions[index].written.statement
            self._actions.setdefault(span, []).append((index, self._action(index)))

    def _computed(self, order: Sequence[int]) -> tuple[set[int], list[int]]:
        """The computed targets that must say something else: those that get a declaration, and those that can have
        none."""
        trial = Targets(
            self._program, self._plant, Edits(self._program.files), Names({}), self._scopes, self._text.pinned
        )
        edited: dict[tuple[Key, int | None], TargetEdit] = {}
        moves = [(i, move) for i in order if isinstance(move := self._program.motions[i], Move)]
        for i, move in moves:
            wish = self._intents[i].wish
            if wish is None or move.written.aggregate is None:
                continue
            named = trial.point(move, wish, self._is_bound(i))
            if named is None and wish != trial.as_written(move) and (data := self._text.literal_data(move)) is not None:
                edited[data] = wish
        own, unsaid = set[int](), list[int]()
        for i, move in moves:
            intent = self._intents[i]
            if intent.wish is None or move.written.aggregate is not None or intent.planned is None:
                continue
            says = self._says(i, move, edited, trial)
            if says is None or not self._agree(move, intent.planned, intent.wish, says):
                if i in self._text.own:
                    own.add(i)
                else:
                    unsaid.append(i)
        spans = {self._program.motions[i].written.statement for i in own}
        return {i for i in self._text.own if self._program.motions[i].written.statement in spans}, unsaid

    def _says(
        self, index: int, move: Move, edited: Mapping[tuple[Key, int | None], TargetEdit], targets: Targets
    ) -> TargetEdit | None:
        """What a computed target will say with some literals edited; None where only a run of the program tells."""
        reads = self._text.trace(move, target=True)
        found = [edit for data, edit in edited.items() if reads.reads(*data)]
        said = targets.as_written(move)
        if ROBOT in reads.keys and index in self._text.own:
            return None
        if not found:
            return said
        if len(found) > 1 or not _MOVED_POINT.fullmatch(move.target):
            return None
        return TargetEdit(found[0].rail or said.rail, found[0].conf or said.conf)

    def _agree(self, move: Move, planned: PlannedMotion, wish: TargetEdit, says: TargetEdit) -> bool:
        """Whether a target that says this brings the robot where it is planned."""
        if self._plant.rail_eax is not None and (wish.rail, says.rail) != (None, None):
            if says.rail is None:
                if rail_moves(planned, self._plant):
                    return False
            elif wish.rail is None or not same_rail(float(wish.rail), float(says.rail)):
                return False
        if not isinstance(move, PoseMove) or not (confdata_counts(move) or wish.monitored):
            return True
        assert says.conf is not None
        return bool(confdata_admits(self._plant.robot, says.conf, np.asarray(planned.q_1[self._plant.layout.arm])))

    def refused(self, index: int) -> InputError:
        """Why a motion cannot become what is wished."""
        motion, text = self._program.motions[index], self._text
        if index in self._unsaid and isinstance(motion, Move):
            hangs = text.depends_on_scenario(index)
            variable = None if hangs else self._scopes.depends_on(motion)
            why = f"depends on {variable}" if variable is not None else "hangs on what only the scenario says"
            if variable is not None or hangs:
                message = f"the plan wants other values for {motion.target}, which {why}; it cannot be written out"
                return refusal(motion.source, message)
        return refusal(
            motion.source,
            "this statement runs more than once, and the plan wants something else of it each time; "
            "write it out once for each time it runs",
        )

    def _is_bound(self, index: int) -> bool:
        """Whether a statement runs several times, or moves to whatever a variable names."""
        if index not in self._text.single:
            return True
        return self._text.loops is not Loops.UNROLL and index in self._text.bound

    def _action(self, index: int) -> _Action:
        motion, intent = self._program.motions[index], self._intents[index]
        if intent.drop:
            return _Action(drop=True)
        if isinstance(motion, Move) and intent.wish is not None:
            wish, bound = intent.wish, self._is_bound(index)
            own = index in self._own
            point = self._targets.own(motion, wish) if own else self._targets.point(motion, wish, bound)
            points = self._points_of(motion, intent)
            return _Action(point=point, fast=intent.fast, monitored=intent.wish.monitored, points=points)
        if isinstance(motion, Wait) and intent.dwell is not None:
            name = self._dwell_target(index, intent.dwell, motion.written.statement)
            return _Action(dwell=name)
        return _Action()

    def _points_of(self, motion: Move, intent: Intent) -> tuple[Point, ...]:
        """The points before a move as its text has them; blanks in names of bodies, and what its file cannot hold, as a
        comment can have them."""
        out = []
        encoding = self._program.files[motion.written.statement.file].encoding
        for one in intent.points:
            assert isinstance(motion, MoveJ | MoveAbsJ)
            around = tuple(name.encode(encoding, "replace").decode(encoding) for name in one.detour)
            out.append(made_point(replace(one, detour=around), motion, self._targets.literal(one, motion)))
        return tuple(out)

    def conflicts(self) -> list[int]:
        """Motions whose statement would have to do one thing at one time and another at another, or say what it
        cannot."""
        several = (group for group in self._actions.values() if any(action != group[0][1] for _, action in group))
        return [*self._unsaid, *(index for group in several for index, _ in group)]

    def result(self) -> RapidExport:
        """The texts with all edits made."""
        for span, group in sorted(self._actions.items(), key=lambda item: item[1][0][0]):
            index, action = group[0]
            if action != _Action():
                self._refuse_compact(span, index, action)
                self._notes += self._apply(index, action)
        flat = FlatModule(self._program, self._edits, self._names, self._scopes, self._targets)
        for run in self._flat:
            indices = [i for i in range(run.first, run.last) if not self._drops(i)]
            self._notes.append(flat.add(run, indices, lambda i: self._flat_motion(i, flat)))
        new = {}
        if (module := flat.module(self._program.entry)) is not None:
            path, file = module
            new[path] = file
            self._notes.append(ProgramWarning(WarningKind.NEW_MODULE, "a new module; load it with the program", path))
        if self._monitored:
            more = f" and {len(self._monitored) - 1} more" if len(self._monitored) > 1 else ""
            what = "ConfJ \\On added: the plan needs a configuration other than the nearest"
            self._notes.append(ProgramWarning(WarningKind.CHANGED, what, f"{self._monitored[0]}{more}"))
        notes = dict.fromkeys((*self._notes, *self._targets.notes))  # passes of one statement say the same
        return RapidExport(self._edits.result(), (*notes,), new)

    # ------------------------------------------------------------------------------------------------ in their place

    def _refuse_compact(self, span: Span, index: int, action: _Action) -> None:
        motion = self._program.motions[index]
        doubled = action.dwell is not None and isinstance(motion, Wait) and motion.condition is not None
        if span in self._scopes.compact and (action.drop or action.monitored or action.points or doubled):
            raise refusal(motion.source, "this statement is part of an IF without THEN; write IF ... THEN ... ENDIF")

    def _apply(self, index: int, action: _Action) -> list[ProgramWarning]:
        motion, edits = self._program.motions[index], self._edits
        span = motion.written.statement
        if action.drop:
            edits.comment_out(span)
            return [ProgramWarning(WarningKind.CHANGED, "dropped, as the program allows", motion.source)]
        if action.dwell is not None:
            assert isinstance(motion, Wait)
            text = self._dwell(index, motion, action.dwell, self._seconds(motion))
            if motion.condition is None:
                edits.replace(span, text)
            else:
                edits.put_before(span, text)
            return [self._dwell_note(motion, action.dwell)]
        notes = []
        if action.points and isinstance(motion, MoveJ | MoveAbsJ):
            lines = [
                line
                for one in action.points
                for line in point_lines(one, motion, edits.text(span), edits.text(span), action.fast)
            ]
            put_above(edits, span, lines)
            for one in action.points:
                self._targets.declare_point(one.name, one.type, one.literal, motion)
            notes.append(_way_note(motion, action.points))
        if action.monitored:
            self._monitored.append(motion.source)
            on, off = _switches(motion)
            edits.put_before(span, on)
            edits.put_behind(span, off)
        if action.point is not None and motion.written.target is not None:
            edits.replace(motion.written.target, action.point)
        if action.fast and isinstance(motion, Move):
            call = read_move(motion, edits.text(span))
            edits.replace(call.speed, "vmax")
            if call.override is not None:  # it would hold vmax down
                edits.replace(call.override, "")
            notes.append(ProgramWarning(WarningKind.CHANGED, "at vmax, as the cell allows (free_speed)", motion.source))
        return notes

    def _seconds(self, wait: Wait) -> str:
        return plain(wait.duration) if wait.condition else last_argument(wait, self._edits.text(wait.written.statement))

    @staticmethod
    def _dwell_note(wait: Wait, name: str) -> ProgramWarning:
        return ProgramWarning(WarningKind.CHANGED, f"the rail moves while the tool waits, to {name}", wait.source)

    # ---------------------------------------------------------------------------------------------------------- flat

    def _drops(self, index: int) -> bool:
        return index in self._intents and self._intents[index].drop

    def _flat_motion(self, index: int, flat: FlatModule) -> FlatMotion:
        motion, intent = self._program.motions[index], self._intents.get(index, Intent())
        if isinstance(motion, Wait) and intent.dwell is not None:
            name = self._dwell_target(index, intent.dwell, motion.written.statement, flat)
            text = self._dwell(index, motion, name, plain(motion.duration))
            self._notes.append(self._dwell_note(motion, name))
            return FlatMotion(text=text) if motion.condition is None else FlatMotion(before=(text,))
        if not isinstance(motion, Move):
            return FlatMotion()
        wish = intent.wish or self._targets.as_written(motion)
        points = self._points_of(motion, intent)
        if points:
            self._notes.append(_way_note(motion, points))
        if not wish.monitored:
            return FlatMotion(wish, fast=intent.fast, points=points)
        self._monitored.append(motion.source)
        on, off = _switches(motion)
        return FlatMotion(wish, fast=intent.fast, before=(on,), behind=(off,), points=points)

    # ------------------------------------------------------------------------------------------------------- dwelling

    def _move_before(self, index: int) -> int:
        """The last move before a motion that is not dropped; -1 where there is none."""
        while (index := index - 1) >= 0:
            if isinstance(self._program.motions[index], Move) and not self._drops(index):
                break
        return index

    def _dwell_target(self, index: int, planned: PlannedMotion, at: Span, flat: FlatModule | None = None) -> str:
        before = self._move_before(index)
        if before < 0:
            source = self._program.motions[index].source
            raise refusal(source, "the plan moves the rail in a wait before the first move; begin with MoveAbsJ home")
        move = self._program.motions[before]
        targets = self._targets
        if isinstance(move, PoseMove):
            # The wait begins where the move ended, and only the rail (and the joints behind it) differ at its end.
            wish = targets.wish(move, planned, dwell=True)
            if flat is not None:
                return flat.declare(f"{targets.base(move)}_b", "robtarget", targets.in_numbers(move, wish))
            return targets.dwell(move, wish, at)
        assert isinstance(move, MoveAbsJ | MoveExtJ)
        tool = next((m.tool for m in reversed(self._program.motions[:index]) if isinstance(m, MoveAbsJ)), None)
        X_WF = self._plant.robot.forward(planned.q_0)
        X_WT = X_WF @ tool.X_FT if tool else X_WF
        if flat is not None:
            return flat.declare(f"{targets.base(move)}_b", "robtarget", targets.at_joints(move, planned, X_WT))
        return targets.dwell_at(move, planned, X_WT, at)

    def _dwell(self, index: int, wait: Wait, name: str, seconds: str) -> str:
        speed, tool, wobj = self._words(index)
        move = self._program.motions[self._move_before(index)]
        frame = "" if isinstance(move, MoveAbsJ | MoveExtJ) else wobj  # the place of joints is written in the world
        return rf"MoveL {name}, {speed} \T:={seconds}, fine, {tool}{frame};"

    def _words(self, index: int) -> tuple[str, str, str]:
        r"""Speed, tool and ` \WObj:=w` (or nothing) as the last move before a motion writes them.

        MoveExtJ writes no tool; then the last move that does counts.
        """
        speed: str | None = None
        wobj: str | None = None
        while (index := self._move_before(index)) >= 0:
            call = self._call(index)
            speed = speed or self._edits.text(call.speed)
            wobj = wobj or (f" {self._edits.text(call.wobj)}" if call.wobj is not None else "")
            if call.tool is not None:
                return speed, self._edits.text(call.tool), wobj
        return speed or "v100", "tool0", wobj or ""

    def _call(self, index: int) -> MoveCall:
        move: Motion = self._program.motions[index]
        assert isinstance(move, Move)
        return read_move(move, self._edits.text(move.written.statement))


def _way_note(move: Move, points: Sequence[Point]) -> ProgramWarning:
    names = ", ".join(point.name for point in points)
    told = f"{names} {'are' if len(points) > 1 else 'is'} added before {move.target}, around {quoted(points[0].around)}"
    return ProgramWarning(WarningKind.CHANGED, told, move.source)


def _switches(move: Motion) -> tuple[str, str]:
    kind = "ConfJ" if isinstance(move, MoveJ) else "ConfL"
    return rf"{kind} \On;", rf"{kind} \Off;"
