"""What data is: types, storage, sharing between modules, 32-bit numbers, names that are not there."""

from __future__ import annotations

import math
import struct

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from trajopt_cli.errors import InputError
from trajopt_cli.motion import Program, TextFile, Wait
from trajopt_cli.rapid.data.datatypes import (
    BOOL,
    DNUM,
    NUM,
    POS,
    POSE,
    ROBTARGET,
    SPEEDDATA,
    TOOLDATA,
    TYPES,
    Array,
    Layout,
    Record,
    is_number,
    is_opaque,
    same_type,
    single,
)
from trajopt_cli.rapid.data.predefined import ERRORS, VARIABLES, predefined
from trajopt_cli.rapid.reader import run_program


def run(body: str, data: str = "", rest: str = "") -> Program:
    return run_text(f"MODULE m\n{data}\nPROC main()\n{body}\nENDPROC\n{rest}\nENDMODULE\n")


def run_text(text: str) -> Program:
    return run_program([TextFile("m.mod", text, "utf-8")])


def trace(body: str, data: str = "", rest: str = "") -> list[float]:
    return [m.duration for m in run(body, data, rest).motions if isinstance(m, Wait)]


def holds(condition: str, data: str = "", rest: str = "") -> bool:
    return trace(f"IF {condition} THEN WaitTime 1; ELSE WaitTime 0; ENDIF", data, rest) == [1]


def error(body: str, data: str = "", rest: str = "") -> str:
    with pytest.raises(InputError) as caught:
        run(body, data, rest)
    return str(caught.value)


def error_text(text: str) -> str:
    with pytest.raises(InputError) as caught:
        run_text(text)
    return str(caught.value)


# ---------------------------------------------------------------------------------------------------------- numbers


@given(st.floats(width=32, allow_nan=False, allow_infinity=False), st.floats(-3e38, 3e38))
def test_single_is_the_nearest_32_bit_number(short: float, long: float) -> None:
    assert single(short) == short
    assert single(long) == float(np.float32(long))


@pytest.mark.parametrize(
    "condition",
    [
        "a + 1 = a",  # 24 bits
        "a - 1 < a",
        "0.1 + 0.2 = 0.3",  # true of 32 bits, not of 64
        "b + 1 > b",  # a dnum has 53
        "c + 0.2 <> 0.3",
        "c = 0.1",
        "10 * c = 1",
        "-7 DIV 2 = -3 AND -7 MOD 2 = -1",
        "Trunc(1E9 * 3) = 3E9",
        "9E9 = 9E+09",
        "2 * p = [0.2,0,0]",
    ],
)
def test_num_has_32_bits_and_dnum_64(condition: str) -> None:
    assert holds(condition, "VAR num a:=16777216; VAR dnum b:=16777216; VAR dnum c:=0.1; VAR pos p:=[0.1,0,0];")


def test_mixing_num_and_dnum_is_said_once() -> None:
    program = run("d:=n; n:=d; WaitTime n+d;", "VAR num n:=0.1; VAR dnum d;")
    (wait,) = program.motions
    assert isinstance(wait, Wait)
    assert wait.duration == 2 * single(0.1)
    assert tuple(map(str, program.warnings)) == (
        "m.mod:4:4: num and dnum are mixed: a controller refuses this, here the value is converted",
    )
    assert tuple(map(str, run("d:=0.5+1; WaitTime 2*d-1;", "VAR dnum d;").warnings)) == ()


@pytest.mark.parametrize("type_", [ROBTARGET, SPEEDDATA, POSE, Array(POSE, (2, 3), 2), Array(NUM, (4,), 1)])
def test_a_layout_reads_what_struct_packs(type_: Array) -> None:
    layout = type_.layout
    assert isinstance(layout, Layout)
    flat = [0.1 * i - 3 for i in range(type_.size)]

    def nest(kind: object, parts: list[float]) -> object:
        if kind is NUM:
            return parts.pop(0)
        if isinstance(kind, Array):
            assert kind.sizes
            return [nest(kind.inside, parts) for _ in range(kind.sizes[0])]
        return [nest(part, parts) for _, part in kind.components]  # type: ignore[attr-defined]

    text = str(nest(type_, list(flat)))
    data = layout.read(text)

    def flatten(value: object) -> list[float]:
        return [one for part in value for one in flatten(part)] if isinstance(value, tuple) else [value]  # type: ignore[list-item]

    assert flatten(data) == list(struct.unpack(f"{type_.size}f", struct.pack(f"{type_.size}f", *flat)))
    assert layout.rounded(data) == data
    assert layout.read(text.replace("[", "[ ").replace(",", " ,\n")) == data


@pytest.mark.parametrize(
    "text", ["[1,2,3]", "[1,2,3,4,5]", "[1,2,3,a]", "[1,2,3,e5]", "[1,2,3,nan]", "[1,2,3,1_0]", "[[1,2],3,4]",
             "[1,2,3,1E39]", "[1,2,3,0x1F]", "[1,2,3,1-2]", "[1,2,3,]", "[1,2,3,1E999]", "[1,2,3,inf]"],
)  # fmt: skip
def test_a_layout_reads_nothing_but_its_numbers(text: str) -> None:
    assert SPEEDDATA.layout is not None
    assert SPEEDDATA.layout.read("[1,2.,.5,-1E-1]") == (1.0, 2.0, 0.5, single(-0.1))
    assert SPEEDDATA.layout.read(text) is None


# ------------------------------------------------------------------------------------------------- records and arrays


def test_whole_records_and_arrays_are_assigned_and_compared() -> None:
    data = "RECORD part\nnum weight;\npos at;\nbool good;\nENDRECORD\nVAR part a; VAR part b{2}; VAR num c{2,2};"
    body = """b:=[[1,[1,2,3],TRUE],[2,[4,5,6],FALSE]]; a:=b{2}; a.at:=[7,8,9]; c:=[[1,2],[3,4]];
        WaitTime b{2}.at.x; WaitTime a.at.x; WaitTime c{2,1};
        IF b{1}=[1,[1,2,3],TRUE] AND a<>b{2} WaitTime 50;
        IF c=[[1,2],[3,4]] WaitTime 60;
        TEST a.at CASE [1,1,1],[7,8,9]: WaitTime 70; ENDTEST"""
    assert trace(body, data) == [4, 7, 3, 50, 60, 70]


def test_records_hold_records_and_aliases_of_other_modules() -> None:
    text = (
        "MODULE a\nVAR outer x:=[[1,2],3];\nPROC main()\nx.in.b:=x.last+1; WaitTime x.in.b;\nENDPROC\nENDMODULE\n"
        "MODULE b\nRECORD inner\nkilo a;\nkilo b;\nENDRECORD\nALIAS num kilo;\n"
        "RECORD outer\ninner in;\nnum last;\nENDRECORD\nENDMODULE\n"
    )
    assert [m.duration for m in run_text(text).motions if isinstance(m, Wait)] == [4]
    assert error_text(text.replace("num last", "outer last")) == "m.mod:13:1: type 'outer' contains itself"
    assert (
        error_text(text.replace("num last", "nume last"))
        == "m.mod:13:1: type 'nume' in RECORD outer is not declared anywhere"
    )


def test_records_that_grow_beyond_all_bounds_are_refused() -> None:
    types = "".join(
        f"RECORD r{i + 1}\n" + "".join(f"r{i} c{j};\n" for j in range(10)) + "ENDRECORD\n" for i in range(7)
    )
    data = "ALIAS num r0;\n" + types
    assert "RECORD r7 holds 10000000 values; at most 1000000" in error("", data + "VAR r7 x;")
    assert "x holds 20000000 values; at most 10000000 are supported" in error("", data + "VAR r5 x{200};")
    assert "x has 1000001 elements; at most 1000000 are supported" in error("", "VAR num x{1000001};")


@pytest.mark.parametrize(
    ("links", "message"),
    [
        (
            "CONST num a{0}:=a{1};",
            "202:1: the value of 'a200' depends on more than 200 other data declared after it",
        ),
        ("ALIAS a{1} a{0};", "202:1: type 'a200' is at the end of a chain of more than 200 others"),
        ("RECORD a{0} a{1} x; ENDRECORD", "202:1: type 'a200' is at the end of a chain of more than 200 others"),
    ],
)
def test_chains_of_declarations_have_an_end(links: str, message: str) -> None:
    """Without one, a long enough file brings Python's own stack down."""
    data = "".join(links.format(i, i + 1) + "\n" for i in range(20_000))
    use = "" if "CONST" in links else "VAR a0 x;"
    assert error_text(f"MODULE m\n{data}{use}PROC main()\nENDPROC\nENDMODULE") == f"m.mod:{message}"


def test_records_in_records_have_an_end_whatever_their_order() -> None:
    data = "".join(f"RECORD r{i + 1} r{i} x; ENDRECORD VAR r{i + 1} x{i};\n" for i in range(31))
    assert error_text(f"MODULE m\nALIAS num r0;\n{data}PROC main()\nENDPROC\nENDMODULE") == (
        "m.mod:33:1: RECORD r31 is nested deeper than 30 records"
    )
    assert error("", f"VAR num x:={50_000 * '1+'}1;") == "m.mod:2:1: the value of 'x' is nested too deeply"


def test_variables_begin_anew_at_each_call_and_module_data_does_not() -> None:
    rest = "PROC go()\nVAR num n:=5;\nCONST num c:=m+1;\nIncr n; Incr m; WaitTime n; WaitTime c;\nENDPROC"
    assert trace("go; go;", "VAR num m;", rest) == [6, 1, 6, 2]
    assert error("go;", rest="PROC go()\nPERS num n:=5;\nENDPROC").startswith("m.mod:7:1: PERS n stands in a routine")


# ----------------------------------------------------------------------------------------------------- process types

PROCESS = (
    "welddata seamdata weavedata spotdata gundata shapedata clock triggdata iodev socketdev rawbytes "
    "signaldi signaldo signalgi signalgo signalai signalao mecunit syncident"
)


def test_process_data_is_carried_along_unread() -> None:
    data = "".join(f"VAR {name} x_{name}; " for name in PROCESS.split())
    data += 'PERS welddata w:=[10,0,[5,0,"a",1],[0,0]]; PERS welddata ws{2}:=[[1],[2]]; TASK PERS seamdata s:=[1,2,3];'
    body = "w:=ws{2}; w.weld_speed:=5; ws{1}.main.volt:=3; use w; WaitTime 1;"
    program = run(body, data, "PROC use(PERS welddata x)\nVAR welddata y;\ny:=x;\nENDPROC")
    assert len(program.motions) == 1
    assert tuple(map(str, program.warnings)) == (
        "m.mod:4:28: ws{1}.main.volt is process data, which does not affect the motion",
    )
    assert error("WaitTime w.weld_speed;", data) == (
        "m.mod:4:10: the components of a welddata are not known here, so '.weld_speed' cannot be read"
    )


def test_numbers_by_another_name() -> None:
    names = "intnum errnum tpnum identno dionum byte icondata btnres"
    assert trace("WaitTime n_byte+n_intnum;", "".join(f"VAR {name} n_{name}:=2; " for name in names.split())) == [4]


def test_a_type_nobody_declares_is_noted_and_an_error_only_where_it_is_used() -> None:
    data = "PERS gizmo g:=[1,[2,x]]; PERS gizmo h:=[1]; VAR num n;"
    program = run("WaitTime 1;", data)
    assert tuple(map(str, program.warnings)) == (
        "m.mod:2:1: type 'gizmo' of 'g' is not declared; this does no harm unless something uses 'g'",
    )
    assert error("n:=g;", data) == "m.mod:4:4: 'g' is of type gizmo, which is not declared anywhere"


# ----------------------------------------------------------------------------------------------------------- modules


def test_a_pers_of_several_modules_is_one() -> None:
    text = (
        "MODULE a\nPERS num shared;\nPROC main()\nWaitTime shared; shared:=7; show;\nENDPROC\nENDMODULE\n"
        "MODULE b\nPERS num shared:=3;\nPROC show()\nWaitTime shared;\nENDPROC\nENDMODULE\n"
        "MODULE c\nPERS num shared:=4;\nPERS num alone;\nENDMODULE\n"
    )
    program = run_text(text)
    assert [m.duration for m in program.motions if isinstance(m, Wait)] == [3, 7]
    assert tuple(map(str, program.warnings)) == (
        "m.mod:14:1: PERS shared has a different value in another module, and that one is used",
    )
    assert error_text(text.replace("PERS num shared:=4", "PERS dnum shared:=4")) == (
        "m.mod:14:1: PERS shared is a dnum here and a num in m.mod:2:1; rename one of them"
    )
    assert error_text(text.replace("PERS num shared:=4", "VAR num shared:=4")) == (
        "m.mod:14:1: 'shared' is declared twice, first in m.mod:2:1; rename one of them"
    )
    assert error_text(text.replace("PERS num alone", "PROC show()\nENDPROC")).startswith(
        "m.mod:15:1: 'show' is declared twice, first in m.mod:9:1"
    )


def test_sizes_may_come_from_below_and_from_other_modules() -> None:
    text = (
        "MODULE a\nVAR num x{rows,columns};\nCONST num rows:=2;\n"
        "PROC main()\nWaitTime 10*Dim(x,1)+Dim(x,2);\nENDPROC\nENDMODULE\n"
        "MODULE b\nCONST num columns:=rows+1;\nENDMODULE\n"
    )
    assert [m.duration for m in run_text(text).motions if isinstance(m, Wait)] == [23]


def test_local_names_of_two_modules_do_not_meet() -> None:
    text = (
        "MODULE a\nLOCAL VAR num x:=1;\nLOCAL PERS num y:=2;\nPROC main()\nWaitTime x+y; show;\nENDPROC\nENDMODULE\n"
        "MODULE b\nLOCAL VAR num x:=10;\nPERS num y:=20;\nPROC show()\nWaitTime x+y; help;\nENDPROC\n"
        "LOCAL PROC help()\nWaitTime 5;\nENDPROC\nENDMODULE\n"
    )
    assert [m.duration for m in run_text(text).motions if isinstance(m, Wait)] == [3, 30, 5]
    assert "help is neither a procedure" in error_text(
        text.replace("show;\nENDPROC\nENDMODULE", "help;\nENDPROC\nENDMODULE")
    )


def test_names_of_the_program_hide_predefined_ones() -> None:
    data = "CONST num v100:=5; CONST num pi:=3;"
    assert trace(
        "VAR num z10:=2; WaitTime v100+pi+z10; WaitTime show(1);",
        data,
        "FUNC num show(num fine)\nRETURN fine;\nENDFUNC",
    ) == [10, 1]


def test_predefined_variables_may_be_changed_and_errors_may_not() -> None:
    assert trace("reg1:=4; WaitTime reg1;") == [4]
    assert error("ERR_DIVZERO:=1;") == "m.mod:4:1: ERR_DIVZERO is predefined and cannot be changed"


LOOKED = "in the program (looked for in PROC main, MODULE m, the other modules' globals and the predefined data)"
FILE = "Else give the file that declares it"
NEITHER = "is neither a procedure of the files read nor a known instruction"
STUB = "give the file that declares it, or ignore it: the line 'stubs: [{}]' in the cell file"


def test_data_that_every_controller_has() -> None:
    """Figures of ABB's reference manual (RAPID instructions, functions and data types: speeddata, zonedata ...)."""
    table = {name: value.data for name, value in predefined().items()}
    unit = ((0, 0, 0), (1, 0, 0, 0))
    load = (0.001, (0, 0, 0.001), (1, 0, 0, 0), 0, 0, 0)
    wanted = {
        "pi": math.pi, "load0": load, "tool0": (True, unit, load), "wobj0": (False, True, "", unit, unit),
        "fine": (True, 0, 0, 0, 0, 0, 0), "z0": (False, 0.3, 0.3, 0.3, 0.03, 0.3, 0.03),
        "z1": (False, 1, 1, 1, 0.1, 1, 0.1), "z15": (False, 15, 23, 23, 2.3, 23, 2.3),
        "z100": (False, 100, 150, 150, 15, 150, 15), "z200": (False, 200, 300, 300, 30, 300, 30),
        "v5": (5, 500, 5000, 1000), "v7000": (7000, 500, 5000, 1000), "vmax": (5000, 500, 5000, 1000),
        "vrot1": (0, 0, 0, 1), "vrot100": (0, 0, 0, 100), "vlin10": (0, 0, 10, 0), "vlin1000": (0, 0, 1000, 0),
        "high": 1, "on": 1, "low": 0, "off": 0, "edge": 2, "btnnone": -1, "btnok": 0, "resunkwn": 0, "op_auto": 1,
        "socket_created": 1, "level_trap": 1,
    }  # fmt: skip
    assert {name: table[name] for name in wanted} == wanted
    counts = {kind: sum(name.startswith(kind) and name[len(kind) :].isdigit() for name in table) for kind in ("v", "z")}
    assert counts == {"v": 25, "z": 14}
    assert list(VARIABLES) == ["reg1", "reg2", "reg3", "reg4", "reg5"]
    assert sorted(ERRORS.values()) == [1001 + i for i in range(len(ERRORS))]
    assert ERRORS["ERR_ACC_TOO_LOW"] == 1001


def test_types_know_their_size_their_depth_and_their_layout() -> None:
    pair, deep = Array(ROBTARGET, (2, 3), 2), Record("deep", (("a", POSE), ("b", NUM), ("c", Array(POS, (4,), 1))))
    assert (NUM.size, POS.size, POSE.size, ROBTARGET.size, pair.size, deep.size) == (1, 3, 7, 17, 102, 20)
    assert (NUM.depth, POS.depth, POSE.depth, pair.depth, deep.depth, Record("none", ()).depth) == (0, 1, 2, 2, 3, 1)
    assert pair.name == "robtarget{*,*}"
    assert pair.inside == Array(ROBTARGET, (3,), 1)
    assert (pair.inside.inside, Array(NUM, None, 2).inside) == (ROBTARGET, Array(NUM, None, 1))
    assert np.shape(np.array(Array(POS, (2, 5), 2).default)) == (2, 5, 3)
    assert TOOLDATA.layout is None
    assert Array(NUM, None, 1).layout is None
    assert Array(NUM, (11_000_000,), 1).layout is None
    for type_, text, data in (
        (POSE, "[[1,2,3],[0.5,0,0,1]]", ((1, 2, 3), (0.5, 0, 0, 1))),
        (deep, "[[[1,2,3],[0.5,0,0,1]],7,[[1,1,1],[2,2,2],[3,3,3],[4,4,4]]]",
         (((1, 2, 3), (0.5, 0, 0, 1)), 7, ((1, 1, 1), (2, 2, 2), (3, 3, 3), (4, 4, 4)))),
        (Array(NUM, (2, 2), 2), "[[1, 2],\n[3e1,-4.5]]", ((1, 2), (30, -4.5))),
        (Array(DNUM, (3,), 1), "[0.1,16777217,3]", (0.1, 16777217, 3)),
        (Array(NUM, (3,), 1), "[0.1,16777217,3]", (float(np.float32(0.1)), 16777216, 3)),
    ):  # fmt: skip
        assert type_.layout is not None
        assert type_.layout.read(text) == data
        assert type_.layout.rounded(data) == data
        for wrong in (
            text[:-1],
            text + "]",
            text.replace(",", ",,", 1),
            text.replace("1", "x"),
            text.replace("1", "1e39"),
        ):
            if wrong != text and not (type_ == Array(DNUM, (3,), 1) and "e39" in wrong):
                assert type_.layout.read(wrong) is None, wrong
    with pytest.raises(OverflowError):
        POS.layout.rounded((1.0, 2.0, 1e39))
    assert Array(NUM, None, 1).default == 0.0
    sizes = [Array(NUM, some, 1) for some in ((2,), (3,), None)]
    assert [[same_type(a, b) for b in sizes] for a in sizes] == [[True, False, True], [False, True, True], [True] * 3]
    assert not same_type(Array(NUM, None, 1), Array(NUM, None, 2))
    assert not same_type(Array(NUM, (2,), 1), Array(DNUM, (2,), 1))
    assert [is_number(one) for one in (NUM, DNUM, BOOL, POS)] == [True, True, False, False]
    opaque = TYPES["clock"]
    assert [is_opaque(one) for one in (opaque, Array(opaque, (2,), 1), NUM, BOOL, POS)] == [
        True,
        True,
        False,
        False,
        False,
    ]
