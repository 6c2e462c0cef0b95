"""Stretches of a program: what a statement that ran exactly once did, and whether that hangs on the scenario."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.rapid_check import same_motion
from trajopt_cli.exporters.rapid_reading import Reading
from trajopt_cli.exporters.rapid_scopes import Scopes
from trajopt_cli.exporters.rapid_text import Edits
from trajopt_cli.motion import Motion, Move, Program, SignalEvent, Span
from trajopt_cli.scenario import Scenario

_MARKS = "trajopt_mark_"
_THINGS = 40  # that the scenario says and that are looked at
_WORLDS = 3  # for each of them; each takes as long as reading the program


@dataclass(frozen=True)
class Stretch:
    """A statement that ran exactly once, and the motions it made: those from first up to, not including, last."""

    span: Span
    first: int
    last: int


class Stretches:
    """The stretches of a program, and which of its computed targets are the same in any world.

    Found when first asked, by running the program with marks around the statements in question: once as it was read,
    and once for each other answer of the world, as a value that hangs on it must not be written out.
    """

    def __init__(self, program: Program, scopes: Scopes, reading: Reading):
        self._program, self._scopes, self._reading = program, scopes, reading
        self._found: dict[Span, Stretch] | None = None
        self._changing: dict[int, str] = {}  # single motions that are not the same in any world, and what they hang on
        self._rejected: dict[Span, str] = {}  # stretches, likewise

    def around(self, index: int) -> Stretch | None:
        """The innermost stretch around a motion, None where there is none that could be written flat."""
        once = self._program.motions[index].written.once
        return self._known().get(once) if once is not None else None

    def constant(self, index: int) -> bool:
        """Whether a move whose statement went to one place does so in any world."""
        self._known()
        return index not in self._changing

    def hangs_on(self, index: int) -> str | None:
        """What of the scenario a motion hangs on, as far as that was looked for."""
        self._known()
        once = self._program.motions[index].written.once
        return self._changing.get(index) or (self._rejected.get(once) if once is not None else None)

    def every(self) -> list[Stretch]:
        """The stretches around all motions whose statement ran several times."""
        runs = Counter(motion.written.statement for motion in self._program.motions)
        several = (i for i, motion in enumerate(self._program.motions) if runs[motion.written.statement] > 1)
        return outermost(stretch for i in several if (stretch := self.around(i)) is not None)

    def _known(self) -> dict[Span, Stretch]:
        if self._found is None:
            self._found = self._find()
        return self._found

    def _find(self) -> dict[Span, Stretch]:
        motions = self._program.motions
        runs = Counter(motion.written.statement for motion in motions)
        spans = {m.written.once for m in motions if m.written.once is not None and runs[m.written.statement] > 1}
        marked = sorted(spans - self._scopes.compact, key=lambda span: (span.file, span.start))
        computed = _computed(motions)
        if not marked and not computed:
            return {}
        edits = Edits(self._program.files)
        for number, span in enumerate(marked):
            edits.replace(Span(span.file, span.start, span.start), f"Set {_MARKS}{2 * number}; ")
            edits.replace(Span(span.file, span.end, span.end), f" Set {_MARKS}{2 * number + 1};")
        texts = edits.result()
        read = self._marked(texts)
        if read is None or len(read.motions) != len(motions):
            self._changing = dict.fromkeys(computed, "what cannot be told")  # the marks are in the program's way
            return {}
        found = {}
        for number, span in enumerate(marked):
            place = read.between(2 * number)
            if place is not None:
                found[number] = Stretch(span, *place)
        things = list(islice(self._reading.otherwise(), _THINGS + 1))
        if len(things) > _THINGS:
            self._changing = dict.fromkeys(computed, "the scenario")  # too many to look at
            self._rejected = dict.fromkeys((found[number].span for number in found), "the scenario")
            return {}
        for name, scenarios in things:
            # A world in which the program fails is no evidence: what asks may take no such answer.
            worlds = (other for one in scenarios if (other := self._marked(texts, one)) is not None)
            for other in islice(worlds, _WORLDS):
                for number, stretch in list(found.items()):
                    if not other.agrees(2 * number, read.motions[stretch.first : stretch.last]):
                        self._rejected[stretch.span] = name
                        del found[number]
                places: dict[Span, list[Motion]] = {}
                for motion in other.motions:
                    places.setdefault(motion.written.statement, []).append(motion)
                for i in computed:
                    there = places.get(read.motions[i].written.statement, [])
                    if not all(same_motion(read.motions[i], one) for one in there):
                        self._changing.setdefault(i, name)
        return {stretch.span: stretch for stretch in found.values()}

    def _marked(self, texts: Mapping[str, str], scenario: Scenario | None = None) -> _Marked | None:
        """What a marked program does; None where it does not run."""
        try:
            return _Marked(self._reading.again(texts, scenario=scenario).motions)
        except InputError:
            return None


class _Marked:
    """Motions of a marked program, and where between them the marks were met."""

    def __init__(self, motions: Sequence[Motion]):
        self.motions: list[Motion] = []
        self._places: dict[int, list[int]] = {}
        for motion in motions:
            if isinstance(motion, SignalEvent) and motion.signal.startswith(_MARKS):
                number = int(motion.signal.removeprefix(_MARKS))
                self._places.setdefault(number, []).append(len(self.motions))
            else:
                self.motions.append(motion)

    def between(self, mark: int) -> tuple[int, int] | None:
        """First motion and end of what happened between a mark and the next; None unless both were met once."""
        begin, end = self._places.get(mark, []), self._places.get(mark + 1, [])
        return (begin[0], end[0]) if len(begin) == len(end) == 1 else None  # else RETURN, EXIT or GOTO left it

    def agrees(self, mark: int, motions: Sequence[Motion]) -> bool:
        """Whether the same motions, or none at all, were made between a mark and the next."""
        if mark not in self._places:
            return True
        place = self.between(mark)
        if place is None or place[1] - place[0] != len(motions):
            return False
        mine = self.motions[place[0] : place[1]]
        return all(same_motion(one, other) for one, other in zip(motions, mine, strict=True))


def _computed(motions: Sequence[Motion]) -> set[int]:
    """The moves to computed targets whose statement goes to one place, however often it runs."""
    places: dict[Span, list[int]] = {}
    for i, motion in enumerate(motions):
        if isinstance(motion, Move) and motion.written.aggregate is None:
            places.setdefault(motion.written.statement, []).append(i)
    return {i for same in places.values() if all(same_motion(motions[same[0]], motions[i]) for i in same) for i in same}


def outermost(stretches: Iterable[Stretch]) -> list[Stretch]:
    """Stretches that lie in no other one, in the order they run."""
    out: list[Stretch] = []
    for stretch in sorted(set(stretches), key=lambda one: (one.first, -one.last, one.span.start, -one.span.end)):
        if not out or stretch.first >= out[-1].last:
            out.append(stretch)
    return out
