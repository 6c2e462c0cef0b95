"""What MuJoCo cannot do is said in one line: not there, a body it refuses, contacts too hard, a state that is none."""

import re
import sys
from dataclasses import replace

import numpy as np
import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.iiwa.controller.admittance import Controller
from trajopt_cli.iiwa.controller.loop import run
from trajopt_cli.iiwa.controller.parameters import Settings, StopKind
from trajopt_cli.iiwa.task.model import Compliance
from trajopt_cli.iiwa.world.mujoco_world import FINEST, MujocoWorld, available
from trajopt_cli.iiwa.world.worlds import Engine, make_world
from trajopt_cli.robot.dynamics import Dynamics, ToolLoad
from trajopt_cli.robot.srs_inverse import ArmAngle

mujoco = pytest.importorskip("mujoco")
H = 1e-3
START = (0.0, *np.radians([30.0, 0.0, -100.0, 0.0, 50.0, 0.0]).tolist())
COM = np.array([0.01, -0.02, 0.07])


def one_line(error):
    assert "\n" not in str(error.value)
    return str(error.value)


def test_a_missing_mujoco_says_what_to_do(iiwa7, X_FT, monkeypatch):
    assert available() == mujoco.__version__
    monkeypatch.setitem(sys.modules, "mujoco", None)
    assert available() is None
    with pytest.raises(InputError, match=r"^MuJoCo is not installed: pip install 'trajopt-cli\[sim\]', or use the"):
        make_world(Engine.MUJOCO, iiwa7, X_FT, None, None, H)
    assert make_world(Engine.SPRING, iiwa7, X_FT, None, None, H).name == "ideal arm"


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        ("raise ImportError('libmujoco.so:\\n  no such file')", "libmujoco.so: no such file"),
        ("raise OSError('libGL.so.1: wrong ELF class')", "libGL.so.1: wrong ELF class"),
        (
            "raise RuntimeError('invalid value for environment variable MUJOCO_GL: x')",
            "invalid value for .* MUJOCO_GL: x",
        ),
        ("import a_module_that_mujoco_misses", "No module named 'a_module_that_mujoco_misses'"),
        ("__version__ = '2.0'", "cannot import name 'MjLogConfig' from 'mujoco'"),
    ],
)
def test_an_installed_mujoco_that_cannot_be_imported_is_none(iiwa7, X_FT, monkeypatch, tmp_path, content, reason):
    (tmp_path / "mujoco").mkdir()
    (tmp_path / "mujoco" / "__init__.py").write_text(content + "\n")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.delitem(sys.modules, "mujoco")
    assert available() is None
    with pytest.raises(
        InputError, match=f"^MuJoCo cannot be imported: {reason}.*; pip install .* spring wall$"
    ) as error:
        make_world(Engine.MUJOCO, iiwa7, X_FT, None, None, H)
    one_line(error)


@pytest.mark.parametrize("moments", [(0.0, 0.0, 0.0), (2e-3, 2e-3, 0.0), (0.0, 1e-3, 1e-3)])
def test_a_load_of_points_moves_as_pins(crooked, X_FT, floor, moments):
    load = ToolLoad(1.3, COM, np.diag(moments))
    world, dynamics = MujocoWorld(crooked, X_FT, load, floor(0.001, robot=crooked), H), Dynamics(crooked, load)
    world.model.dof_damping[:] = world.model.dof_frictionloss[:] = 0.0
    data = mujoco.MjData(world.model)
    for state in np.random.default_rng(8).uniform(-1.5, 1.5, (10, 3, 7)):
        data.qpos[:], data.qvel[:], data.qacc[:] = state
        world.model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
        mujoco.mj_inverse(world.model, data)
        np.testing.assert_allclose(data.qfrc_inverse, dynamics.torque(*state), rtol=0, atol=1e-9)


def test_a_tool_of_points_presses_with_stiffness_times_depth(smooth, X_FT, floor):
    world = MujocoWorld(smooth, X_FT, ToolLoad(0.8, COM, np.zeros((3, 3))), floor(0.002, 2e4, 200.0), H)
    world.reset(START)
    for _ in range(1100):
        measured = world.step(START)
    assert measured.contact[2] == pytest.approx(2e4 * measured.depth, rel=1e-6)
    assert measured.depth > 5e-4


def test_a_link_without_mass_is_named(iiwa7, X_FT, tmp_path):
    head, link, tail = re.split(
        r'(<link name="link_3">.*?</link>)', iiwa7.urdf.read_text(), maxsplit=1, flags=re.DOTALL
    )
    urdf = tmp_path / "massless.urdf"
    urdf.write_text(head + re.sub(r"<inertial>.*?</inertial>", "", link, flags=re.DOTALL) + tail)
    with pytest.raises(InputError, match=r"^MuJoCo refuses the arm.* 'link_3'; correct its mass") as error:
        MujocoWorld(replace(iiwa7, urdf=urdf), X_FT, None, None, H)
    assert "line 1" not in one_line(error)


def test_a_load_beyond_all_numbers_is_refused(iiwa7, X_FT, floor, capfd):
    with pytest.raises(
        InputError, match=r"^MuJoCo cannot resolve the inertia of the arm with this load: correct"
    ) as error:
        MujocoWorld(iiwa7, X_FT, ToolLoad(1e300, COM, np.zeros((3, 3))), floor(0.001), H)
    one_line(error)
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize(
    ("stiffness", "damping", "message"),
    [
        (9e8, 0.0, r"stiffness 9e\+08 N/m, at most [4-5]\.\d*e\+07 N/m"),
        (1e4, 1e8, r"damping 1e\+08 N s/m, at most [3-4]\.\d*e\+04 N s/m"),
    ],
)
def test_contacts_too_hard_for_the_physics_steps_are_refused(iiwa7, X_FT, load, floor, stiffness, damping, message):
    with pytest.raises(ValueError, match=f"^obstacle 'floor': {message}") as error:
        MujocoWorld(iiwa7, X_FT, load, floor(0.001, stiffness, damping), H)
    one_line(error)


@pytest.mark.parametrize(("stiffness", "damping"), [(9e8, 0.0), (1e4, 1e6)])
def test_the_hardest_contact_that_is_taken_takes_the_finest_steps_and_holds(
    iiwa7, X_FT, load, floor, stiffness, damping
):
    with pytest.raises(ValueError, match=r", at most ") as error:
        MujocoWorld(iiwa7, X_FT, load, floor(0.001, stiffness, damping, 0.0), H)
    bound = 0.999 * float(str(error.value).split("at most ")[1].split()[0])
    hardest = (bound, damping) if damping == 0.0 else (stiffness, bound)
    world = MujocoWorld(iiwa7, X_FT, load, floor(0.001, *hardest, 0.0), H)
    world.reset(START)
    assert world.model.opt.timestep == pytest.approx(FINEST, rel=0.05)
    for _ in range(120):
        measured = world.step(START)
    assert 1.0 < measured.contact[2] < 200.0
    np.testing.assert_allclose(measured.q, START, rtol=0, atol=0.02)


@pytest.fixture
def unstable(iiwa7, X_FT, floor):
    """An arm whose motors drive what they should damp, from an instant on that the test chooses."""
    world = MujocoWorld(iiwa7, X_FT, None, floor(0.001), H)

    def spoil():
        world.model.actuator_biasprm[:, 2] = 1e5
        world.model.actuator_forcelimited[:] = False

    return world, spoil


def test_a_state_that_is_none_stays_none_until_the_reset_and_leaves_no_trace(unstable, tmp_path, monkeypatch, capfd):
    monkeypatch.chdir(tmp_path)
    world, spoil = unstable
    first = world.reset(START)
    damping = world.model.actuator_biasprm[:, 2].copy()
    rows = [world.step(START)]
    spoil()
    rows += [world.step(START) for _ in range(40)]
    finite = [bool(np.isfinite(row.tau).all()) for row in rows]
    assert finite[0]
    assert not any(finite[finite.index(False) :])
    assert np.isnan([*rows[-1].q, *rows[-1].qd, *rows[-1].qdd, *rows[-1].tau, *rows[-1].contact, rows[-1].depth]).all()
    world.model.actuator_biasprm[:, 2] = damping
    assert world.reset(START) == first
    assert list(tmp_path.iterdir()) == []
    assert capfd.readouterr() == ("", "")
    # others' MuJoCo warns as before
    config = mujoco.MjLogConfig.get()
    assert config.logto_console
    assert config.logto_file


def test_a_command_that_is_no_number_has_no_answer(iiwa7, X_FT, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    world = MujocoWorld(iiwa7, X_FT, None, None, H)
    world.reset(START)
    assert np.isnan(world.step((float("nan"), *START[1:])).tau).all()
    assert list(tmp_path.iterdir()) == []


def test_a_start_without_a_state_is_refused(iiwa7, X_FT):
    world = MujocoWorld(iiwa7, X_FT, None, None, H)
    with pytest.raises(InputError, match=r"^MuJoCo finds no forces at the start: start outside of the obstacles"):
        world.reset((float("nan"), *START[1:]))


def test_the_loop_stops_where_the_physics_end(unstable, iiwa7, X_FT):
    world, spoil = unstable
    law = Compliance(
        np.array([1e3] * 3 + [30.0] * 3), np.array([500.0] * 3 + [20.0] * 3), np.array([25.0] * 3 + [3.0] * 3)
    )

    class Spoilt:
        name = world.name

        def reset(self, q):
            self.steps = 0
            return world.reset(q)

        def step(self, q):
            self.steps += 1
            if self.steps == 20:
                spoil()
                # at once what it would be after a while: the controller stops for its speed otherwise
                for _ in range(40):
                    world.step(q)
            return world.step(q)

    still = np.zeros(6)
    still[:3] = (iiwa7.forward(np.array(START)) @ X_FT)[:3, 3]
    settings = Settings(law, H, ArmAngle.FARIA, X_FT=X_FT)
    loop = run(Controller(iiwa7, settings, START), np.tile(still, (60, 1)), Spoilt(), iiwa7.profile("default"))
    assert loop.stop is not None
    assert loop.stop.kind is StopKind.TORQUE
    assert loop.stop.message == "at 0.020 s the measured torques are not finite"
    assert len(loop.t) == 20
    assert np.isfinite(loop.q).all()
