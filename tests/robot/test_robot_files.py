"""Robot files: what ships, what is said of a mistake, and what loading must not import."""

import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from ruamel.yaml import YAML

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.errors import InputError, InputErrorGroup
from trajopt_cli.limits import SPREADS
from trajopt_cli.robot import catalogue
from trajopt_cli.robot.catalogue import find_robot
from trajopt_cli.robot.model import Structure, load_robot, robot_names

JOINTS = tuple(f"joint_{i}" for i in range(1, 7))
ROBOTS = Path(__file__).parents[2] / "robots"


@pytest.fixture
def copy(tmp_path):
    """Writes irb140 with edits into a folder of its own: copy(yaml={old: new}, urdf={old: new}) -> path."""

    def write(yaml=None, urdf=None):
        for suffix, edits in (("yaml", yaml or {}), ("urdf", urdf or {})):
            text = (ROBOTS / f"irb140.{suffix}").read_text()
            for old, new in edits.items():
                assert text.count(old) >= 1, old
                text = text.replace(old, new, 1)
            (tmp_path / f"irb140.{suffix}").write_text(text)
        return str(tmp_path / "irb140.yaml")

    return write


def line_with(text, path):
    """The first line, from 1, that holds text."""
    return next(i for i, line in enumerate(Path(path).read_text().splitlines(), 1) if text in line)


def test_the_robots_ship_and_load():
    arms = ("irb120", "irb1200_5_90", "irb140", "irb1600_6_120", "irb2600_12_165", "irb4600_40_255")
    arms += ("irb6640_180_255", "irb6700_200_260", "crb15000_5_95", "kr6_r900", "puma560", "ur10e", "ur5e")
    assert robot_names(Structure.SIX_AXIS) == tuple(sorted([*arms, *(f"{name}_rail" for name in arms)]))
    assert set(robot_names()) == {"iiwa14", "iiwa7", *robot_names(Structure.SIX_AXIS)}
    assert robot_names(Structure.SRS) == ("iiwa14", "iiwa7")
    assert load_robot("irb140").axis_names == tuple(f"joint_{i}" for i in range(1, 7))
    rail = load_robot("irb140_rail")
    assert rail.axis_names == ("rail", *(f"joint_{i}" for i in range(1, 7)))
    assert rail.has_rail
    assert not load_robot("irb140").has_rail
    np.testing.assert_array_equal(rail.rail_axes, [[0, 1, 0]])
    arm = load_robot("irb140").arm
    assert arm.lengths == {"a1": 0.07, "a2": 0.0, "b": 0.0, "c1": 0.352, "c2": 0.36, "c3": 0.38, "c4": 0.065}
    for one in (arm, rail.arm):  # exactly: expressions drop products with zeros and ones
        assert one.lengths == arm.lengths
        assert one.canonical_joints
        assert one.canonical_flange
        assert not one.converted
        np.testing.assert_array_equal(one.X_BC, np.eye(4))
        np.testing.assert_array_equal(rail.turns[:2], [[0] * 6, [0, 0, 0, 0, 0, -2 * np.pi]])


def test_limits_are_those_of_the_data_sheet_and_the_profiles():
    robot = load_robot("irb140_rail")
    default, optimistic = robot.profile(), robot.profile("optimistic")
    np.testing.assert_allclose(np.degrees(default.lower[1:]), [-180, -90, -230, -200, -115, -400], rtol=1e-15)
    np.testing.assert_allclose(np.degrees(default.upper[1:]), [180, 110, 50, 200, 115, 400], rtol=1e-15)
    np.testing.assert_allclose(np.degrees(default.velocity[1:]), [200, 200, 260, 360, 360, 450], rtol=1e-15)
    np.testing.assert_array_equal(default.acceleration, [2, 15, 15, 20, 40, 40, 50])
    np.testing.assert_array_equal(optimistic.acceleration, [2, 35, 35, 45, 63, 63, 79])
    assert default.velocity[0] == 1.0
    assert (robot.tcp.speed, robot.tcp.acceleration) == (2.5, 20.0)


def test_every_number_has_a_source_and_a_grade(mounted):
    for limits in mounted.profiles.values():
        wanted = {f"{n}.{k}" for n in mounted.axis_names for k in ("position", "velocity", "acceleration")}
        if limits.jerk is not None:
            wanted |= {f"{n}.jerk" for n in mounted.axis_names}
        if limits.torque is not None:
            wanted |= {
                f"{n}.torque" for n, torque in zip(limits.names, limits.torque, strict=True) if np.isfinite(torque)
            }
        assert set(limits.sources) == wanted
        assert all(text.endswith(tuple(f"(grade {g})" for g in "ABCD")) for text in limits.sources.values())
    by_table = mounted.profile().table is not None
    assert mounted.profile().sources["joint_3.acceleration"].endswith("(grade B)" if by_table else "(grade D)")
    assert mounted.profile("optimistic").sources["joint_3.acceleration"].endswith(("(grade C)", "(grade D)"))
    for key in ("tcp.speed", "tcp.acceleration", "geometry", "confdata"):
        assert mounted.notes[key].endswith(tuple(f"(grade {g})" for g in "ABCD"))
    faster = (
        mounted.profile("optimistic").acceleration[-6:]
        / mounted.profile("conservative" if by_table else None).acceleration[-6:]
    )
    assert np.all((faster > 1) & (faster < 5))


def test_a_number_may_say_between_what_the_true_one_is_else_its_grade_does(copy):
    path = copy(yaml={"{value: 15.0,": "{value: 15.0, low: 12, high: 30,"})
    spread = load_robot(path).profile().spread
    assert spread["joint_1.acceleration"] == (0.8, 2.0)
    assert spread["joint_2.acceleration"] == SPREADS["acceleration"]["D"]
    assert spread["joint_1.velocity"] == (1.0, 1.0)  # grade A
    cell = "robot: {}\nstart: {{joints: [0, 0, 0, 0, 0.5, 0]}}\nlimits: {{joint_1: {{acceleration: 20, source: ours}}}}"
    in_force = parse_cell(cell.format(path), "cell.yaml").apply_limits(load_robot(path).profile(), JOINTS).spread
    assert in_force.keys() == spread.keys() - {"joint_1.acceleration"}


def test_how_long_axes_settle_is_the_robots_files(copy):
    assert load_robot("ur5e").settle is None
    for name in robot_names(Structure.SIX_AXIS):
        if name.startswith(("irb", "crb")):
            assert load_robot(name).settle[:2] == (0.1, 0.1)  # at \\Inpos as at fine points, where nobody says more
    line = "  fine: {value: 0.1,"
    more = '  inpos: {value: 0.3, source: "a log", grade: B}\n' + line
    assert load_robot(copy(yaml={line: more})).settle[:2] == (0.1, 0.3)
    for value in ("0", "-0.1", "100"):  # milliseconds
        path = copy(yaml={line: line.replace("0.1", value)})
        with pytest.raises(InputError) as refused:
            load_robot(path)
        assert refused.value.line == line_with("fine: {value", path)


def test_an_unknown_robot_or_profile_lists_the_known():
    with pytest.raises(InputError) as error:
        load_robot("irb41")
    assert str(error.value) == (
        "unknown robot 'irb41'; did you mean 'irb140'? 'trajopt robot list' shows all, or give the path of a robot's"
        " .yaml file"
    )
    with pytest.raises(
        InputError, match=r"unknown robot 'xyz'; known: crb15000_5_95, .*, ur5e_rail; 'trajopt robot list' shows"
    ):
        find_robot("xyz")
    with pytest.raises(InputError, match=r"irb140 has no limit profile 'fast': known are default, rule, optimistic"):
        load_robot("irb140").profile("fast")
    with pytest.raises(InputError, match=r"robot file 'nowhere/x\.yaml' does not exist"):
        load_robot("nowhere/x.yaml")


def test_a_robot_loads_from_a_path(copy):
    robot = load_robot(copy())
    assert robot.arm.lengths == load_robot("irb140").arm.lengths
    assert robot.urdf.parent == Path(copy()).parent


@pytest.mark.parametrize(
    ("edit", "place", "words"),
    [
        ({"grade: A\naxes": "grad: A\naxes"}, "grad: A", "unknown key 'geometry.grad'"),
        ({"speed: {value: 2.5, ": "speed: {"}, "  speed:", "'tcp.speed.value' is missing"),
        ({"value: 20.0": "value: -20.0"}, "acceleration: {value: -20.0", "'tcp.acceleration.value': input should be"),
        ({"value: 20.0": "value: .nan"}, "value: .nan", "'tcp.acceleration.value': input should be"),
        ({"value: 20.0": "value: .inf"}, "value: .inf", "'tcp.acceleration.value': input should be"),
        ({"value: 20.0": "value: many"}, "value: many", "'tcp.acceleration.value': input should be a valid number"),
        ({"value: 20.0": "value: 20.0, low: 9"}, "low: 9", "'tcp.acceleration': has low alone"),
        ({"value: 20.0": "value: 20.0, low: 25, high: 30"}, "low: 25", "'tcp.acceleration': low 25, value 20, high 30"),
        ({"grade: D": "grade: E"}, "grade: E", "'profiles.default.acceleration.joint_1.grade': input should be"),
        ({"rule: abb_six_axis": "rule: kuka"}, "rule: kuka", "'confdata.rule': input should be 'abb_six_axis'"),
        ({"  joint_2: {position": "  joint_7: {position"}, "joint_7:", "'axes.joint_7' is no axis of the URDF"),
        (
            {"      joint_6: {": "      # joint_6: {"},
            "    acceleration:",
            "'profiles.default.acceleration.joint_6' is missing",
        ),
        ({"  default:": "  careful:"}, "profiles:", "'profiles.default' is missing"),
        ({"urdf: irb140.urdf": "urdf: other.urdf"}, "urdf: other", "'other.urdf' does not exist beside this file"),
        ({"confdata:": "confdata: ["}, None, "not YAML: "),
        (
            {"confdata:": "structure: scara\nconfdata:"},
            "structure: scara",
            "'structure': scara is none; known are six_axis",
        ),
        ({"confdata:": "structure: [srs]\nconfdata:"}, "structure: [srs]", "'structure': ['srs'] is none; known are"),
        ({"confdata:": "structure: srs\nconfdata:"}, "confdata:", "unknown key 'confdata'"),
        ({"confdata:": "structure: srs\nconfdata:"}, "  joint_1:", "'axes.joint_1.torque' is missing"),
        ({"confdata:": "structure: srs\nconfdata:"}, None, "'inertia' is missing"),
    ],
)
def test_a_mistake_in_the_yaml_is_named_with_its_line(copy, edit, place, words):
    path = copy(yaml=edit)
    with pytest.raises(InputError) as error:
        load_robot(path)
    told = error.value.errors if isinstance(error.value, InputErrorGroup) else (error.value,)
    (named,) = (one for one in told if words in str(one))
    assert named.file == path
    assert place is None or named.line == line_with(place, path)
    assert str(named).startswith(f"{path}:{named.line}: ")


@pytest.mark.parametrize("edit", [{}, {"confdata:": "confdata: ["}, {"  default:": "  careful:"}])
def test_the_same_text_in_two_places_is_the_same_robot_and_told_by_its_own_name(copy, tmp_path, edit):
    path = Path(copy(yaml=edit))
    (tmp_path / "other").mkdir()
    paths = [path, Path(shutil.copy(path, tmp_path / "other")), path]
    shutil.copy(path.with_suffix(".urdf"), tmp_path / "other")
    if not edit:
        (one, raw), (two, same), _ = map(catalogue.read_robot_file, paths)
        assert (one, raw) == (two, same)
        assert [load_robot(str(one)).urdf.parent for one in paths] == [one.parent for one in paths]
    for one in paths if edit else ():
        with pytest.raises(InputError) as error:
            load_robot(str(one))
        assert error.value.file == str(one)


def test_several_mistakes_are_told_at_once(copy):
    with pytest.raises(InputErrorGroup) as error:
        load_robot(copy(yaml={"title:": "titel:", "value: 20.0": "value: 0"}))
    assert len(error.value.errors) == 3  # title missing, titel unknown, value


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        (
            {'"0 0 0.36" rpy="0 0 0"': '"0 0 0.36" rpy="0.1 0 0"'},
            "axes 2 and 3 ('joint_2' and 'joint_3') are 5.72958° ",
        ),
        (
            {'0 0.352" rpy="0 0 0"': '0 0.352" rpy="0.1 0 0"'},
            "('joint_1' and 'joint_2') are 5.72958° from a right angle",
        ),
        (
            {'"0.239 0 0" rpy="0 0 0"': '"0.239 0 0" rpy="0 0 0.2"'},
            "('joint_3' and 'joint_4') are 11.4592° from a right",
        ),
        (
            {'"0.141 0 0" rpy="0 0 0"': '"0.141 0 0" rpy="0 0 0.1"'},
            "axes 4 and 5 ('joint_4' and 'joint_5') are 5.72958°",
        ),
        (
            {'"0 0 0.36" rpy="0 0 0"': '"0 0 0.36" rpy="1e-7 0 0"'},
            "from parallel, at most 6e-08°: six axes are served whose",
        ),
        (
            {'"0.141 0 0"': '"0.141 0 0.01"'},
            "the wrist: axis 5 passes axis 4 by 10 mm, at most 1e-06: six",
        ),
        ({'"0 0 0.36"': '"0 0.1 0"'}, "axes 2 and 3 are 0 mm apart, at least 0.001: six axes"),
        ({'"0.239 0 0"': '"-0.141 0 0"'}, "the wrist centre and axis 3 are 0 mm apart, at least 0.001"),
        ({'type="revolute"': 'type="continuous"'}, "joint 'joint_1' has type 'continuous'"),
        ({'type="revolute"': 'type="prismatic"'}, "wanted six revolute joints in a row"),
        ({'velocity="3': 'speed="3'}, "joint 'joint_1': <limit> has no velocity"),
        ({' effort="0"/>': "/>"}, "joint 'joint_1': <limit> has no effort"),
        ({'lower="-3': 'lower="3'}, "joint 'joint_1': wanted lower < upper and velocity > 0"),
        ({'xyz="0 0 0.36"': 'xyz="0 0"'}, "joint 'joint_3': <origin> xyz=\"0 0\" is not 3 finite number(s)"),
        ({'xyz="0 0 0.36"': 'xyz="0 0 x"'}, "joint 'joint_3': <origin> xyz=\"0 0 x\" is not 3 number(s)"),
        ({'xyz="0 0 0.36"': 'xyz="0 0 nan"'}, "joint 'joint_3': <origin> xyz=\"0 0 nan\" is not 3 finite number(s)"),
        ({'xyz="0 0 0.36"': 'xyz="0 0 0.36 1"'}, 'xyz="0 0 0.36 1" is not 3 finite number(s)'),
        ({'<axis xyz="1 0 0"/>': '<axis xyz="2 0 0"/>'}, "joint 'joint_4' has an axis of length 2, wanted 1"),
        ({"</robot>": ""}, "not a URDF: "),
        ({'name="tool0"': 'name="tcp"', 'link="tool0"': 'link="tcp"'}, "no joint leads to link 'tool0'"),
    ],
)
def test_a_urdf_the_closed_form_does_not_fit_is_refused(copy, edit, words):
    path = copy(urdf=edit)
    with pytest.raises(InputError) as error:
        load_robot(path)
    assert words in str(error.value)
    assert str(error.value).startswith(path.replace(".yaml", ".urdf"))


@pytest.mark.parametrize("share", [0.9, 1.1])
@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('"0 0 0.36" rpy="0 0 0"', '"0 0 0.36" rpy="{0} 0 0"', "from parallel"),
        ('0 0.352" rpy="0 0 0"', '0 0.352" rpy="{0} 0 0"', "from a right angle"),
        ('"0.141 0 0" rpy="0 0 0"', '"0.141 0 0" rpy="0 0 {0}"', "from a right angle"),
        ('"0.141 0 0"', '"0.141 0 {0}"', "the wrist: axis 5 passes axis 4 by"),
        ('<axis xyz="1 0 0"/>', '<axis xyz="{1!r} 0 0"/>', "has an axis of length 1, wanted 1"),
    ],
)
def test_how_far_a_chain_may_be_off(copy, old, new, words, share):
    """A nanometre, a nanoradian: ten printed digits."""
    path = copy(urdf={old: new.format(share * 1e-9, 1 + share * 1e-9)})
    if share < 1:
        lengths = load_robot(path).arm.lengths
        assert lengths == pytest.approx(load_robot("irb140").arm.lengths, abs=2e-9)
    else:
        with pytest.raises(InputError, match=words):
            load_robot(path)


def test_lengths_come_from_the_urdf_as_it_is_now(copy):
    assert load_robot(copy()).arm.c2 == 0.36
    longer = load_robot(
        copy(urdf={'"0 0 0.36"': '"0 0 0.4"', '"0.141 0 0"': '"0.151 0 0"', '"0 0 0" rpy': '"0 0 0.1" rpy'})
    )
    arm = longer.arm
    np.testing.assert_allclose([arm.a1, arm.c1, arm.c2, arm.c3, arm.c4], [0.07, 0.452, 0.4, 0.39, 0.065], rtol=1e-14)
    q = np.array([0.3, 0.2, -0.4, 0.5, 0.6, -0.7])
    import pinocchio as pin

    model = longer.pin_model
    data = model.createData()
    pin.framesForwardKinematics(model, data, q)
    wanted = data.oMf[model.getFrameId("tool0")].homogeneous
    np.testing.assert_allclose(longer.forward(q), wanted, rtol=0, atol=1e-14)


def test_a_turned_rail_in_the_urdf_equals_pin(tmp_path):
    for suffix in ("yaml", "urdf"):
        text = (ROBOTS / f"irb140_rail.{suffix}").read_text()
        straight = 'xyz="0 0 0" rpy="0 0 0"'  # the first is the rail's
        (tmp_path / f"irb140_rail.{suffix}").write_text(
            text.replace(straight, 'xyz="0.1 0.2 0.3" rpy="0.3 -0.4 0.5"', 1) if suffix == "urdf" else text
        )
    robot = load_robot(str(tmp_path / "irb140_rail.yaml"))
    model = robot.pin_model
    import pinocchio as pin

    data = model.createData()
    q = np.array([0.7, 0.3, 0.2, -0.4, 0.5, 0.6, -0.7])
    pin.framesForwardKinematics(model, data, q)
    np.testing.assert_allclose(robot.forward(q), data.oMf[model.getFrameId("tool0")].homogeneous, rtol=0, atol=1e-14)
    jacobian = pin.computeFrameJacobian(model, data, q, model.getFrameId("tool0"), pin.LOCAL_WORLD_ALIGNED)
    np.testing.assert_allclose(robot.jacobian(q), jacobian, rtol=0, atol=1e-14)


def test_the_sliding_axis_has_the_name_that_cell_files_use(tmp_path):
    for suffix in ("yaml", "urdf"):
        text = (ROBOTS / f"irb140_rail.{suffix}").read_text()
        (tmp_path / f"irb140_rail.{suffix}").write_text(text.replace('name="rail"', 'name="slide"'))
    with pytest.raises(InputError, match="joint 'slide' is the sliding axis: call it 'rail'"):
        load_robot(str(tmp_path / "irb140_rail.yaml"))


def test_a_mounting_must_be_a_pose():
    with pytest.raises(ValueError, match=r"X_WR has shape \(3, 3\), wanted \(4, 4\)"):
        load_robot("irb140", X_WR=np.eye(3))
    with pytest.raises(ValueError, match=r"X_WR is not a pose: its rotation is off by 3"):
        load_robot("irb140", X_WR=np.diag([2.0, 1, 1, 1]))


def test_line_of_falls_back_to_the_nearest_key_above():
    raw = YAML().load("a:\n  b:\n    c: 1\n")
    assert [catalogue.line_of(raw, keys) for keys in (("a", "b", "c"), ("a", "b", "x"), ("y",))] == [3, 2, 1]


def test_an_installed_package_uses_its_own_robots_and_not_its_neighbours(tmp_path):
    root = ROBOTS.parent
    shutil.copytree(root / "trajopt_cli", tmp_path / "trajopt_cli", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copytree(ROBOTS, tmp_path / "trajopt_cli" / "robots")
    (tmp_path / "robots").mkdir()  # some other distribution's
    (tmp_path / "robots" / "foreign.yaml").write_text("name: foreign\n")
    code = "from trajopt_cli.robot.model import *; print(robot_names(), load_robot('irb140').urdf)"
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True)
    urdf = tmp_path / "trajopt_cli" / "robots" / "irb140.urdf"
    assert done.stdout.strip() == f"{robot_names()} {urdf}"


def test_loading_a_robot_imports_neither_pin_nor_casadi():
    code = (
        "import sys, trajopt_cli.robot.model as m; heavy = {'pinocchio', 'casadi', 'pydantic', 'scipy'};"
        "print(sorted(heavy & set(sys.modules))); m.load_robot('irb140_rail');"
        "print(sorted({'pinocchio', 'casadi', 'scipy'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=ROBOTS.parent, capture_output=True, text=True, check=True)
    assert done.stdout.split("\n")[:2] == ["[]", "[]"]
