from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import fields
from pathlib import Path
from typing import Any, TypeVar

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from rapid_printer import print_expression, print_file, print_statement

from trajopt_cli.errors import InputError
from trajopt_cli.rapid.language import syntax
from trajopt_cli.rapid.language.expressions import PRIORITY, parse_expression
from trajopt_cli.rapid.language.lexer import KEYWORDS
from trajopt_cli.rapid.language.parser import Parser, parse_module, parse_statement
from trajopt_cli.rapid.language.syntax import (
    Binary,
    Boolean,
    DataDeclaration,
    Expression,
    Node,
    Placeholder,
    Statement,
    Unary,
)

PROGRAMS = Path(__file__).parents[2] / "programs"
T = TypeVar("T")

# ------------------------------------------------------------------------------------------------------ generated


def at(kind: Callable[..., T], *parts: st.SearchStrategy[Any]) -> st.SearchStrategy[T]:
    """Nodes of a kind from strategies for its parts; trees are compared without their places."""
    return st.builds(lambda *made: kind(0, 0, *made), *parts)


def some(values: st.SearchStrategy[T], least: int = 0, most: int = 3) -> st.SearchStrategy[tuple[T, ...]]:
    return st.lists(values, min_size=least, max_size=most).map(tuple)


characters = st.characters(exclude_categories=["Cs"])  # a codec's would be worked out, for a second
names = st.from_regex(r"[^\W\d]\w{0,6}", fullmatch=True, alphabet=characters).filter(
    lambda n: n.upper() not in KEYWORDS
)
marks = st.sampled_from(["<SMT>", "<EXP>", "<VAR>", "<ID>", "<ARG>", "<PAR>", "<ALT>", "<DIM>", "<DDN>", "<RDN>"])
placeholders = at(Placeholder, marks)
numbers = at(syntax.Number, st.floats(allow_nan=False, allow_infinity=False).map(lambda v: v + 0.0))
strings = at(syntax.String, st.text(characters, max_size=8))
variables = at(syntax.Name, names)
atoms = st.one_of(numbers, strings, at(Boolean, st.booleans()), variables, at(Placeholder, marks | st.just("*")))


def arguments(values: st.SearchStrategy[Expression]) -> st.SearchStrategy[tuple[syntax.Argument, ...]]:
    required = at(syntax.Argument, st.none(), values) | at(syntax.Argument, st.none(), values, st.just(False), names)
    optional = at(syntax.Argument, names, st.none() | values)
    forward = at(syntax.Argument, names, variables, st.just(True))
    return some(st.one_of(required, optional, forward))


def parts(bases: st.SearchStrategy[Expression], inner: st.SearchStrategy[Expression]) -> st.SearchStrategy[Expression]:
    return at(syntax.Component, bases, names) | at(syntax.Element, bases, some(inner, 1))


def grown(inner: st.SearchStrategy[Expression]) -> st.SearchStrategy[Expression]:
    operators = st.sampled_from(["*", "/", "DIV", "MOD", "+", "-", "<", ">", "<=", ">=", "=", "<>", "AND", "XOR", "OR"])
    return st.one_of(
        at(Binary, operators, inner, inner),
        at(Unary, st.sampled_from(["-", "+", "NOT"]), inner),
        parts(inner, inner),
        at(syntax.Call, names, arguments(inner)),
        some(inner, 1).map(lambda items: syntax.Aggregate(0, 0, given=items)),
    )


expressions = st.recursive(atoms, grown, max_leaves=8)
targets = variables | placeholders | st.recursive(variables, lambda inner: parts(inner, expressions), max_leaves=3)
data = at(
    DataDeclaration,
    st.none(),
    st.sampled_from(["VAR", "PERS", "CONST"]),
    names,
    names | marks,
    some(expressions),
    st.none() | expressions,
)
simple = st.one_of(
    at(syntax.Assign, targets, expressions),
    at(syntax.ProcedureCall, names, arguments(expressions)),
    at(syntax.LateCall, expressions, arguments(expressions)),
    at(syntax.Goto, names),
    at(syntax.Return, st.none() | expressions),
    at(syntax.Raise, st.none() | expressions),
    at(syntax.Connect, expressions, names),
    at(syntax.Simple, st.sampled_from(["EXIT", "RETRY", "TRYNEXT"])),
    placeholders,
)


def nested(inner: st.SearchStrategy[Statement]) -> st.SearchStrategy[Statement]:
    block = some(st.one_of(inner, at(syntax.Label, names), data))
    branches = some(st.tuples(expressions, block), 1, 2)
    cases = some(st.tuples(some(expressions, 1, 2), block), 0, 2)
    return st.one_of(
        at(syntax.If, branches, block),
        at(syntax.If, st.tuples(st.tuples(expressions, inner.map(lambda one: (one,)))), st.just(()), st.just(True)),
        at(syntax.For, names, expressions, expressions, st.none() | expressions, block),
        at(syntax.While, expressions, block),
        at(syntax.Test, expressions, cases, st.none() | block),
    )


statements = st.recursive(simple, nested, max_leaves=4)
blocks = some(st.one_of(statements, at(syntax.Label, names), data))
scopes = st.sampled_from([None, "LOCAL"])
parameter = at(
    syntax.Parameter,
    st.sampled_from([None, "INOUT", "VAR", "PERS"]),
    names,
    names,
    st.integers(0, 3),
    st.booleans(),
)
alternatives = st.tuples(
    at(syntax.Parameter, st.none(), names, names, st.just(0), st.just(True)),
    at(syntax.Parameter, st.none(), names, names, st.just(0), st.just(True), st.just(True)),
)
unfinished = at(syntax.Parameter, st.none(), st.just(""), st.just("<PAR>"))
parameters = some(st.one_of(parameter.map(lambda p: (p,)), alternatives, unfinished.map(lambda p: (p,))), 0, 3).map(
    lambda groups: sum(groups, ())
)
handlers = at(syntax.Handler, st.just("ERROR"), some(expressions), blocks) | at(
    syntax.Handler, st.sampled_from(["UNDO", "BACKWARD"]), st.just(()), blocks
)
items = st.one_of(
    at(DataDeclaration, scopes | st.just("TASK"), st.just("PERS"), names, names, some(expressions), st.none() | atoms),
    at(syntax.RecordDeclaration, scopes, names, some(st.tuples(names, names))),
    at(syntax.AliasDeclaration, scopes, names, names),
    at(syntax.Routine, scopes, st.just("PROC"), st.none(), names, parameters, blocks, some(handlers, 0, 2)),
    at(syntax.Routine, scopes, st.just("FUNC"), names, names, parameters, blocks, st.just(())),
    at(syntax.Routine, scopes, st.just("TRAP"), st.none(), names, st.just(()), blocks, st.just(())),
    placeholders,
)
attributes = some(st.sampled_from(["SYSMODULE", "NOVIEW", "NOSTEPIN", "VIEWONLY", "READONLY"]), 0, 2)
modules = at(syntax.Module, names, attributes, some(items))


def labels_differ(tree: object) -> bool:
    """A routine may hold a label once; here no two of a whole tree are the same."""
    labels = [name.lower() for name in re.findall(r"Label\(name='([^']*)'", repr(tree))]
    return len(set(labels)) == len(labels)


files = st.one_of(
    st.builds(lambda ms: syntax.ModuleFile(0, 0, ms, (), ()), some(modules, 1, 2)),
    st.builds(lambda i: syntax.ModuleFile(0, 0, (syntax.Module(0, 0, "", (), i),), (), ()), some(items, 1)),
).filter(labels_differ)


@settings(max_examples=60, deadline=None)
@given(expressions)
def test_an_expression_printed_and_read_is_the_same_tree(tree: Expression) -> None:
    assert parse_expression(print_expression(tree), "t") == tree


@settings(max_examples=30, deadline=None)
@given(statements.filter(labels_differ))
def test_a_statement_printed_and_read_is_the_same_tree(tree: Statement) -> None:
    assert parse_statement(print_statement(tree), "t") == tree


@settings(max_examples=30, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(files)
def test_a_file_printed_and_read_is_the_same_tree(tree: syntax.ModuleFile) -> None:
    assert parse_module(print_file(tree), "t") == tree


def test_every_pair_of_operators_keeps_its_grouping() -> None:
    a, b, c = (syntax.Name(0, 0, name) for name in "abc")
    for one in PRIORITY:
        signed: list[Expression] = [Unary(0, 0, sign, a) for sign in ("-", "+", "NOT")]
        for two in PRIORITY:
            signed += [Binary(0, 0, one, Binary(0, 0, two, a, b), c), Binary(0, 0, one, a, Binary(0, 0, two, b, c))]
        signed += [Binary(0, 0, one, signed[0], signed[2]), Binary(0, 0, one, signed[2], signed[1])]
        signed += [Unary(0, 0, sign, Binary(0, 0, one, a, b)) for sign in ("-", "+", "NOT")]
        for tree in signed:
            assert parse_expression(print_expression(tree), "t") == tree


# ------------------------------------------------------------------------------------------------------ the stretches


def nodes(tree: object) -> list[Node]:
    """All nodes of a tree, in the order of their fields."""
    if isinstance(tree, tuple):
        return [node for part in tree for node in nodes(part)]
    if isinstance(tree, syntax.Aggregate):
        return [tree, *nodes(tree.items)]
    if isinstance(tree, Node):
        return [tree, *(node for part in fields(tree) for node in nodes(getattr(tree, part.name)))]
    return []


def places(tree: object) -> list[tuple[type, int, int]]:
    return [(type(node), node.start, node.end) for node in nodes(tree)]


@pytest.mark.long
@settings(max_examples=20, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(files)
def test_the_text_of_a_nodes_stretch_is_the_node(tree: syntax.ModuleFile) -> None:
    text = print_file(tree)
    for node in nodes(parse_module(text, "t").modules):
        stretch = text[node.start : node.end]
        if isinstance(node, Statement):
            if not isinstance(node, Placeholder) and not (isinstance(node, DataDeclaration) and node.scope):
                assert parse_statement(stretch, "t") == node
        elif isinstance(node, Expression):
            assert parse_expression(stretch, "t") == node
        else:
            assert stretch == stretch.strip()


PIECES = r"""
    CONST VAR LOCAL TASK Pers MoveL robtarget p10 v100 if THEN 1 -1 .5 1. 1E3 1E999 [1,2] [[1,2],[3,.5]] [[1],2] [ ] , ;
    \ \WObj \WObj:=w := : = ( ) . { } - + ! <SMT> * "a" ENDPROC RECORD ENDRECORD å x² 0x1F 1st NaN
"""
pieces = st.sampled_from(PIECES.split())
common = st.sampled_from(
    [
        "CONST robtarget p10:=[[1,-2.5,3],[1,0,0,0],[0,0,0,0],[9E9,9E+09,9E9,9E9,9E9,9E9]];",
        "local pers\tnum  n := [ 1 , 2 ] ;",
        "MoveL p10,v100,z10,tool0\\WObj:=wobj0;",
        "MoveAbsJ\\Conc , [[0,0],[9E9]] \\NoEOffs,v100 \\V := 1.5,\nfine, tool0 ,\\WObj:=w\\T:=1;",
        "num count;",
        "WaitTime 0.5;",
    ]
)
gaps = st.sampled_from(["", " ", "\n", "\t", "\r\n", "!c\n", "\u00a0", "\x00"])


@settings(max_examples=250, deadline=None)
@given(
    st.lists(st.tuples(common | pieces, gaps, gaps), max_size=14), st.sampled_from(["PROC m()\n;", "RECORD r ;", ";"])
)
def test_the_short_cut_for_whole_statements_changes_nothing(text: list[tuple[str, ...]], head: str) -> None:
    whole = head + "".join("".join(part) for part in text) + "\nENDPROC"
    short, long = outcome(Parser(whole, "t")), outcome(Parser(whole, "t", None))
    # An instruction in a RECORD is wrong either way; the short cut knows that it is one.
    assert short == long or ("RECORD" in whole and isinstance(short, str) and isinstance(long, str))


def outcome(parser: Parser) -> object:
    """The tree with its places, or what is wrong."""
    try:
        tree = parser.file()
    except InputError as error:
        return error.shown()
    return tree, places(tree), tree.comments, tree.leftovers, tree.warnings


# ------------------------------------------------------------------------------------------------------- real text

WHOLE_LANGUAGE = r"""
%%%
  VERSION:1
  LANGUAGE:ENGLISH
%%%
! a comment before the module
MODULE Whole(SYSMODULE, NOSTEPIN)
    RECORD station
        pos where;
        num count;
    ENDRECORD
    LOCAL ALIAS num weight;
    <DDN>
    TASK PERS tooldata t1 := [TRUE, [[0,0,1.], [1,0,0,0]], [1,[0,0,.5],[1,0,0,0],0,0,0]];
    VAR num grid {2,3}:=[[1,2,3],[4,5,6]];
    CONST robtarget p{2}:=[[[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E+9,9E+09,9E9,9E9,9E9]], ! inside
        [[-1,+2,3],[1,0,0,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]];
    PERS string empty;
    FUNC bool near(robtarget a, VAR num b{*,*}, INOUT pos c, \switch Fast | switch Slow, \num limit)
        VAR num d := 0x1F;
        RETURN NOT a.trans.x < 1 AND d >= -2 * grid{1,2} OR FALSE XOR d = 1;
    ENDFUNC
    LOCAL TRAP stopped
        RETURN;
    ENDTRAP
    PROC main()
        <SMT>
        again:
        MoveAbsJ\Conc,[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]]\NoEOffs,v100,fine,t1,\WObj:=wobj0;
        WaitTime \InPos, 0.1;; PulseDO\PLength:=0.2,do1;
        IF near(p{1}, grid, c \Fast) AND NOT found GOTO again;
        IF a = "say ""hi"" \\ \41" THEN b{1,2}.where.x := -a.b * (c - d) / -2; ELSEIF x THEN ELSE RETURN; ENDIF
        FOR i FROM 10 TO 1 STEP -2 DO
            TEST i CASE 1, 2: work i \Speed?speed; CASE 3: DEFAULT: EXIT; ENDTEST
        ENDFOR
        WHILE TRUE DO %"proc" + NumToStr(i,0)% i, \Sw; ENDWHILE
        CONNECT alarm WITH stopped;
        RAISE ERR_X;
    ERROR (ERR_A, ERR_B)
        TRYNEXT;
    ERROR
        RETRY;
    UNDO
        x := CRobT();
    ENDPROC
ENDMODULE
MODULE Second
ENDMODULE
"""


def test_the_whole_language_printed_and_read_is_the_same_tree() -> None:
    tree = parse_module(WHOLE_LANGUAGE, "whole.mod")
    assert [module.name for module in tree.modules] == ["Whole", "Second"]
    assert [type(item).__name__ for item in tree.modules[0].items] == [
        *("RecordDeclaration", "AliasDeclaration", "Placeholder"),
        *["DataDeclaration"] * 4,
        *["Routine"] * 3,
    ]
    assert parse_module(print_file(tree), "printed.mod") == tree


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("x:=1.+.5+0x1F+0o17+0b101+1E-05+9e+09;", "x:=1+0.5+31+15+5+0.00001+9000000000;"),
        ("WaitTime\\InPos,0.1;", "WaitTime \\InPos , 0.1 ;"),
        ("MoveL p,v,z,t,\\WObj:=w;", "MoveL p,v,z,t \\WObj:=w;"),
        ("MoveL p,v,z,t\\WObj:=w\\TLoad:=l;", "MoveL p , v , z , t , \\WObj := w , \\TLoad := l ;"),
        ("IF a IF b IF c GOTO x;", "IF a\nIF b\nIF c\nGOTO x;"),
        ("If a Then ; elseif b tHEN Else ; endIF", "IF a THEN ELSEIF b THEN ELSE ENDIF"),
        ("FOR i FROM 1 to 3 DO ;; EndFor", "FOR i FROM 1 TO 3 DO ENDFOR"),
        (
            'TEST x ; CASE 1,2,-3: y:=1; CASE "a": DEFAULT: ENDTEST',
            'TEST x CASE 1,2,-3: y:=1; CASE "a": DEFAULT: ENDTEST',
        ),
        ("VAR\u00a0num\u3000übergröße {2 , 3};", "VAR num übergröße{2,3};"),
        ("x:=(a*b).trans.x;", "x:=((a*b).trans).x;"),
        ("MoveL *,v,z,t;", "MoveL\n*\n,v,z,t;"),
        ('%"p"+n% 1,2\\a?b;', '% ("p" + n) % 1 , 2 , \\a ? b ;'),
    ],
)
def test_forms_found_in_the_field_mean_the_same(text: str, meaning: str) -> None:
    assert parse_statement(text, "t") == parse_statement(meaning, "t")


@pytest.mark.parametrize(
    ("literal", "value"),
    [('"a""b"', 'a"b'), (r'"a\\b"', "a\\b"), (r'"\41\0a"', "A\n"), (r'"\x"', "\\x"), ('""', ""), ('""""', '"')],
)
def test_escapes_of_strings(literal: str, value: str) -> None:
    assert parse_expression(literal, "t") == syntax.String(0, 0, value)


def test_declarations_found_in_the_field_are_read() -> None:
    text = """
        PERS num a; TASK PERS num b; LOCAL PERS num c:=2; LOCAL TASK PERS num d:=1; LOCAL RECORD r num x; ENDRECORD
        PROC p(\\switch s|switch t|num u, VAR num v{*,*,*}, INOUT pos w, PERS tooldata g, \\PERS wobjdata WObj)
            x := 1; VAR num late := 3; CONNECT i{1} WITH trap1;
        ERROR (A, B) RETRY; ERROR TRYNEXT; UNDO x := 1; BACKWARD x := 2;
        ENDPROC
    """
    (module,) = parse_module(text.replace("\\\\", "\\"), "t").modules
    *data, record, routine = module.items
    assert [item.scope for item in data if isinstance(item, DataDeclaration)] == [None, "TASK", "LOCAL", "LOCAL"]
    assert isinstance(record, syntax.RecordDeclaration)
    assert record.components == (("num", "x"),)
    assert isinstance(routine, syntax.Routine)
    assert [(p.mode, p.dimensions, p.optional, p.alternative) for p in routine.parameters] == [
        (None, 0, True, False),
        (None, 0, True, True),
        (None, 0, True, True),
        ("VAR", 3, False, False),
        ("INOUT", 0, False, False),
        ("PERS", 0, False, False),
        ("PERS", 0, True, False),
    ]
    assert [(h.kind, len(h.numbers)) for h in routine.handlers] == [
        ("ERROR", 2), ("ERROR", 0), ("UNDO", 0), ("BACKWARD", 0),
    ]  # fmt: skip


@pytest.mark.parametrize("name", ["hinge_cell", "bench_irb140"])
def test_a_shipped_program_printed_and_read_is_the_same_tree(name: str) -> None:
    tree = parse_module((PROGRAMS / f"{name}.mod").read_text(), name)
    assert parse_module(print_file(tree), name) == tree


def test_comparing_trees_sees_a_changed_number() -> None:
    assert parse_expression("[[1,2],[3,4]]", "t") == parse_expression("[[1,2.0], ! three\n[3,4]]", "t")
    assert parse_expression("[[1,2],[3,4]]", "t") != parse_expression("[[1,2],[3,5]]", "t")


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("1+2*3", "1 + (2 * 3)"),
        ("8-4-2", "(8 - 4) - 2"),
        ("8/4/2", "(8 / 4) / 2"),
        ("NOT a AND b", "NOT (a AND b)"),
        ("NOT a OR b", "(NOT a) OR b"),
        ("a AND NOT b", "a AND (NOT b)"),
        ("a OR b AND c", "a OR (b AND c)"),
        ("a XOR b OR c", "(a XOR b) OR c"),
        ("NOT di1=1", "NOT (di1 = 1)"),
        ("-a*b", "-(a * b)"),
        ("a<b = (c<d)", "(a < b) = (c < d)"),
        ("7 MOD 4 DIV 2", "(7 MOD 4) DIV 2"),
    ],
)
def test_priorities_are_those_of_rapid(text: str, meaning: str) -> None:
    assert parse_expression(text, "t") == parse_expression(meaning, "t")
