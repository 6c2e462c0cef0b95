"""Functions of numbers, bits, strings and frames: values by hand, by closed form, or by numpy and scipy."""

from __future__ import annotations

from math import sqrt

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from trajopt_cli.errors import InputError
from trajopt_cli.motion import MoveL, TextFile, Wait
from trajopt_cli.rapid.reader import run_program


def durations(body: str, data: str = "") -> list[float]:
    text = f"MODULE m\n{data}\nPROC main()\n{body}\nENDPROC\nENDMODULE\n"
    program = run_program([TextFile("m.mod", text, "utf-8")])
    return [motion.duration for motion in program.motions if isinstance(motion, Wait)]


def value(expression: str) -> float:
    (seconds,) = durations(f"WaitTime {expression};")
    return seconds


def truth(condition: str, data: str = "") -> bool:
    return durations(f"IF {condition} THEN WaitTime 1; ELSE WaitTime 0; ENDIF", data) == [1.0]


def problem(expression: str, data: str = "") -> str:
    with pytest.raises(InputError) as caught:
        durations(f"WaitTime {expression};", data)
    return caught.value.message


def pose_of(expression: str, data: str = "") -> np.ndarray:
    """A pose, as the place of a target in a work object whose user frame it is."""
    text = (
        f'MODULE m\n{data}\nPERS wobjdata w:=[FALSE,TRUE,"",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];\n'
        "CONST robtarget p:=[[0,0,0],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
        f"PROC main()\nw.uframe:={expression};\nMoveL p,v100,fine,tool0\\WObj:=w;\nENDPROC\nENDMODULE\n"
    )
    (motion,) = run_program([TextFile("m.mod", text, "utf-8")]).motions
    assert isinstance(motion, MoveL)
    return motion.X_WT


@pytest.mark.parametrize(
    ("expression", "wanted"),
    [
        ("SinDnum(30)*2", 1.0),
        ("ATan2Dnum(1,-1)", 135.0),
        ("SqrtDnum(2)*SqrtDnum(2)", 2.0),
        ("RoundDnum(0.123456789012\\Dec:=10)*1E10 MOD 1000", 890.0),
        ("TruncDnum(9.99)", 9.0),
        ("NumToDnum(2.5)+DnumToNum(1.5)", 4.0),
        ("Max(3,7)-Min(3,7)", 4.0),
        ("BitAnd(12,10)", 8.0),
        ("BitOr(12,10)", 14.0),
        ("BitXOr(12,10)", 6.0),
        ("BitNeg(0)", 255.0),
        ("BitLSh(129,1)", 2.0),
        ("BitRSh(129,1)", 64.0),
        ("BitAndDnum(4503599627370495,4294967296)/65536", 65536.0),
        ('StrFind("Robotics",1,"aeiou")', 2.0),
        ('StrFind("Robotics",1,"aeiou"\\NotInSet)', 1.0),
        ('StrFind("xyz",1,"abc")', 4.0),
        ('StrMatch("Robotics",1,"bo")', 3.0),
        ('StrMatch("Robotics",4,"bo")', 9.0),
        ('StrToByte("7F"\\Hex)', 127.0),
        ('StrToByte("A"\\Char)', 65.0),
        ('StrToByte("00001010"\\Bin)', 10.0),
        ('StrToByte("012"\\Okt)', 10.0),
        ('StrLen(StrPart("abc",4,0))', 0.0),
    ],
)
def test_functions_of_numbers(expression: str, wanted: float) -> None:
    assert value(expression) == pytest.approx(wanted, rel=1e-7)


@pytest.mark.parametrize(
    "condition",
    [
        "BitCheck(5,3)",
        "NOT BitCheck(5,2)",
        'StrMemb("Robotics",2,"aeiou")',
        'StrOrder("FIRST","SECOND",STR_UPPER)',
        'NOT StrOrder("FIRSTB","FIRST",STR_UPPER)',
        'StrOrder("FIRST","FIRSTB",STR_UPPER)',
        'StrMap("Robotics","aeiou","AEIOU")="RObOtIcs"',
        'StrMap("aab","aa","xy")="xxb"',
        'ByteToStr(122)="122"',
        'ByteToStr(122\\Hex)="7A"',
        'ByteToStr(10\\Okt)="012"',
        'ByteToStr(5\\Bin)="00000101"',
        'ByteToStr(65\\Char)="A"',
        'DecToHex("99999999")="5F5E0FF"',
        'HexToDec("5F5E0FF")="99999999"',
        'ValToStr(3.85)="3.85"',
        'ValToStr(1234567)="1.23457E+06"',
        'ValToStr(-0)="0"',
        'ValToStr(TRUE)="TRUE"',
        'NumToStr(3.14159265,2)="3.14"',
        'NumToStr(312.5,2\\Exp)="3.12E+02" OR NumToStr(312.5,2\\Exp)="3.13E+02"',
        'NumToStr(-7,0)="-7"',
        'DnumToStr(123456789012,0)="123456789012"',
        'StrPart("Robotics",1,5)="Robot"',
    ],
)
def test_functions_of_bits_and_strings(condition: str) -> None:
    assert truth(condition)


def test_a_string_is_read_as_a_value_of_the_variables_own_type() -> None:
    data = "VAR num n:=7;\nVAR pos p;\nVAR bool b;\nVAR string s;\nVAR num other:=3;"
    assert truth('StrToVal("3.85",n) AND n=3.85', data)
    assert truth('StrToVal("-2",n) AND n=-2', data)
    assert truth('StrToVal("[600,500,225.3]",p) AND p.x=600 AND p.z=225.3', data)
    assert truth('StrToVal("TRUE",b) AND b', data)
    for text in ("abc", "[1,2]", "TRUE", "1+1", "other", "", "1 2"):
        assert durations(f'IF NOT StrToVal("{text}",n) WaitTime n;', data) == [7.0], text


def test_a_pose_written_as_a_string_is_what_one_would_write() -> None:
    data = "CONST pos p:=[100,-0.5,1E6];"
    assert truth('ValToStr(p)="[100,-0.5,1E+06]"', data)


POINTS = "\n".join(
    f"CONST robtarget {name}:=[[{x},{y},{z}],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];"
    for name, x, y, z in [
        ("o", 100, 200, 300), ("x", 100, 700, 300), ("xy", -50, 350, 300),
        ("o2", 0, 0, 0), ("x2", 10, 0, 0), ("xy2", 4, 9, 0), ("on", 100, 900, 300),
    ]
)  # fmt: skip


@pytest.mark.parametrize(("origin", "place"), [("", (0.1, 0.2, 0.3)), ("\\Origin:=2", (0.1, 0.7, 0.3)),
                                               ("\\Origin:=3", (0.1, 0.35, 0.3))])  # fmt: skip
def test_a_frame_from_three_points(origin: str, place: tuple[float, ...]) -> None:
    X = pose_of(f"DefFrame(o,x,xy{origin})", POINTS)
    # x along +y of the world, the third point on the side of -x: so y points along -x, z stays up.
    np.testing.assert_allclose(X[:3, :3], np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1]]).T, atol=1e-7)
    np.testing.assert_allclose(X[:3, 3], place, atol=1e-7)


def test_a_displacement_brings_the_old_points_to_the_new_frame() -> None:
    X = pose_of("DefDFrame(o2,x2,xy2,o,x,xy)", POINTS)
    # The old points lie in the world's own frame, so the displacement is the new frame itself.
    np.testing.assert_allclose(X, pose_of("DefFrame(o,x,xy)", POINTS), atol=1e-7)
    back = pose_of("DefDFrame(o,x,xy,o2,x2,xy2)", POINTS)
    np.testing.assert_allclose(back @ X, np.eye(4), atol=1e-6)


def test_orientations_agree_with_scipy() -> None:
    X = pose_of("[[0,0,0],OrientZYX(40,-30,20)]")
    wanted = Rotation.from_euler("ZYX", [40, -30, 20], degrees=True).as_matrix()
    np.testing.assert_allclose(X[:3, :3], wanted, atol=1e-6)
    both = pose_of("PoseMult([[10,20,30],OrientZYX(40,-30,20)],PoseInv([[1,2,3],OrientZYX(5,6,7)]))")
    a = np.eye(4)
    a[:3, :3], a[:3, 3] = wanted, [0.01, 0.02, 0.03]
    b = np.eye(4)
    b[:3, :3], b[:3, 3] = Rotation.from_euler("ZYX", [5, 6, 7], degrees=True).as_matrix(), [0.001, 0.002, 0.003]
    np.testing.assert_allclose(both, a @ np.linalg.inv(b), atol=1e-6)
    assert value("VectMagn(PoseVect([[0,0,0],OrientZYX(90,0,0)],[3,4,0])-[-4,3,0])") == pytest.approx(0, abs=1e-5)
    assert durations("WaitTime VectMagn(a*b);", "CONST pos a:=[1,1,1];\nCONST pos b:=[1,0,0];") == [
        pytest.approx(sqrt(2), rel=1e-6)
    ]


def called(body: str, rest: str, data: str = "") -> list[float]:
    text = f"MODULE m\n{data}\nPROC main()\n{body}\nENDPROC\n{rest}\nENDMODULE\n"
    program = run_program([TextFile("m.mod", text, "utf-8")])
    return [motion.duration for motion in program.motions if isinstance(motion, Wait)]


def test_a_parameter_knows_what_it_stands_for() -> None:
    routine = (
        "PROC show(INOUT num a,num b)\n"
        'IF ArgName(a)="count" WaitTime 1;\nIF ArgName(b)="2*count" WaitTime 2;\n'
        "IF IsPers(a) WaitTime 3;\nIF IsVar(a) WaitTime 4;\nENDPROC\n"
        "PROC pass(INOUT num inner)\nshow inner,0;\nENDPROC"
    )
    assert called("show count,2*count;", routine, "VAR num count;") == [1, 2, 4]
    assert called("show count,2*count;", routine, "PERS num count:=0;") == [1, 2, 3]
    assert called("pass count;", routine, "VAR num count;") == [1, 4]
    assert called("show c{2},0;", routine, "VAR num c{3};") == [4]
    with pytest.raises(InputError, match="count is not a parameter of the routine"):
        called('IF ArgName(count)="" WaitTime 1;', "", "VAR num count;")


def test_types_and_sizes_of_data() -> None:
    data = "VAR robtarget p;\nVAR num a{2,3,4};\nVAR shelf s{5};\nVAR pos q{7};"
    assert truth('Type(p)="robtarget" AND Type(p.trans)="pos" AND Type(q)="pos"', data)
    assert durations("FOR i FROM 1 TO 3 DO WaitTime Dim(a,i); ENDFOR WaitTime Dim(s,1);", data) == [2, 3, 4, 5]
    assert problem("Dim(q,2)", data) == "q has no dimension 2"


def test_bits_are_set_and_cleared() -> None:
    data = "VAR byte b:=130;\nVAR dnum d:=0;"
    assert durations("BitSet b,1; WaitTime b; BitClear b,8; WaitTime b;", data) == [131, 3]
    assert durations("BitSet d,40; WaitTime d/BitLShDnum(1,39);", data) == [1]
    with pytest.raises(InputError, match=r"BitPos 9 lies outside 1\.\.8"):
        durations("BitSet b,9;", data)
