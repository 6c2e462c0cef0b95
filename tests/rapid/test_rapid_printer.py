from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from trajopt_cli.rapid.language.expressions import parse_expression
from trajopt_cli.rapid.language.lexer import KEYWORDS
from trajopt_cli.rapid.language.parser import parse_module, parse_statement
from trajopt_cli.rapid.language.printer import print_expression, print_file, print_statement
from trajopt_cli.rapid.language.syntax import (
    Aggregate,
    Argument,
    Assign,
    Binary,
    Boolean,
    Call,
    Component,
    DataDeclaration,
    Element,
    Expression,
    For,
    Goto,
    If,
    Label,
    Module,
    ModuleFile,
    Name,
    Number,
    ProcedureCall,
    Return,
    Routine,
    Simple,
    Statement,
    String,
    Unary,
    While,
)
from trajopt_cli.rapid.language.syntax import Test as CaseNode

PROGRAMS = Path(__file__).parents[2] / "programs"

# ------------------------------------------------------------------------------------------------------ generated

names = st.from_regex(r"[a-zA-Zå][a-zA-Z0-9_]{0,6}", fullmatch=True).filter(lambda n: n.upper() not in KEYWORDS)
numbers = st.floats(allow_nan=False, allow_infinity=False).map(lambda v: Number(0, 0, v + 0.0))
strings = st.text(st.characters(codec="cp1252"), max_size=8).map(lambda v: String(0, 0, v))
atoms = st.one_of(numbers, strings, st.booleans().map(lambda v: Boolean(0, 0, v)), names.map(lambda n: Name(0, 0, n)))


def arguments(values: st.SearchStrategy[Expression]) -> st.SearchStrategy[tuple[Argument, ...]]:
    required = values.map(lambda v: Argument(0, 0, None, v))
    optional = st.builds(lambda n, v: Argument(0, 0, n, v), names, st.none() | values)
    forward = st.builds(lambda n, v: Argument(0, 0, n, Name(0, 0, v), True), names, names)
    return st.lists(st.one_of(required, optional, forward), max_size=3).map(tuple)


def grown(inner: st.SearchStrategy[Expression]) -> st.SearchStrategy[Expression]:
    operators = st.sampled_from(["*", "/", "DIV", "MOD", "+", "-", "<", ">", "<=", ">=", "=", "<>", "AND", "XOR", "OR"])
    some = st.lists(inner, min_size=1, max_size=3).map(tuple)
    return st.one_of(
        st.builds(lambda o, a, b: Binary(0, 0, o, a, b), operators, inner, inner),
        st.builds(lambda o, a: Unary(0, 0, o, a), st.sampled_from(["-", "+", "NOT"]), inner),
        st.builds(lambda a, n: Component(0, 0, a, n), inner, names),
        st.builds(lambda a, i: Element(0, 0, a, i), inner, some),
        st.builds(lambda n, a: Call(0, 0, n, a), names, arguments(inner)),
        some.map(lambda items: Aggregate(0, 0, given=items)),
    )


expressions = st.recursive(atoms, grown, max_leaves=12)
variables = names.map(lambda n: Name(0, 0, n))
simple = st.one_of(
    st.builds(lambda t, v: Assign(0, 0, t, v), variables, expressions),
    st.builds(lambda n, a: ProcedureCall(0, 0, n, a), names, arguments(expressions)),
    names.map(lambda n: Goto(0, 0, n)),
    (st.none() | expressions).map(lambda v: Return(0, 0, v)),
    st.sampled_from(["EXIT", "RETRY", "TRYNEXT"]).map(lambda w: Simple(0, 0, w)),
)


def nested(inner: st.SearchStrategy[Statement]) -> st.SearchStrategy[Statement]:
    block = st.lists(inner | names.map(lambda n: Label(0, 0, n)), max_size=3).map(tuple)
    branch = st.tuples(expressions, block)
    cases = st.lists(st.tuples(st.lists(expressions, min_size=1, max_size=2).map(tuple), block), max_size=2).map(tuple)
    return st.one_of(
        st.builds(lambda b, o: If(0, 0, tuple(b), o), st.lists(branch, min_size=1, max_size=2), block),
        st.builds(lambda c, s: If(0, 0, ((c, (s,)),), (), True), expressions, simple),
        st.builds(lambda n, a, b, c, s: For(0, 0, n, a, b, c, s), names, expressions, expressions, st.none(), block),
        st.builds(lambda c, s: While(0, 0, c, s), expressions, block),
        st.builds(lambda e, c, d: CaseNode(0, 0, e, c, d), expressions, cases, st.none() | block),
    )


statements = st.recursive(simple, nested, max_leaves=6)


@settings(max_examples=300, deadline=None)
@given(expressions)
def test_an_expression_printed_and_read_is_the_same_tree(tree: Expression) -> None:
    assert parse_expression(print_expression(tree), "t") == tree


@settings(max_examples=150, deadline=None)
@given(statements)
def test_a_statement_printed_and_read_is_the_same_tree(tree: Statement) -> None:
    assert parse_statement(print_statement(tree), "t") == tree


@settings(max_examples=60, deadline=None)
@given(st.lists(statements, max_size=3), names, st.none() | expressions)
def test_a_module_printed_and_read_is_the_same_tree(body: list[Statement], name: str, value: Expression | None) -> None:
    data = DataDeclaration(0, 0, "LOCAL", "VAR", "num", name, (), value)
    routine = Routine(0, 0, None, "PROC", None, name, (), tuple(body), ())
    file = ModuleFile(0, 0, (Module(0, 0, name, ("NOSTEPIN",), (data, routine)),), (), ())
    assert parse_module(print_file(file), "t") == file


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
