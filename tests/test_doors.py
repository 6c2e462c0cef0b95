"""`import trajopt_cli` is cheap and gives every step of the data's journey, whatever was imported before."""

from __future__ import annotations

import ast
import inspect
import re
import subprocess
import sys
from pathlib import Path

import pytest

import trajopt_cli

REPOSITORY = Path(__file__).parents[1]
SOURCE = (REPOSITORY / "trajopt_cli" / "__init__.py").read_text(encoding="utf-8")
NOT_YET: set[str] = set()
STEPS = ["read_program", "load_cell", "build_plant", "build_problem", "optimize", "verify", "export"]
HEAVY = ("numpy", "casadi", "pinocchio", "coal", "toppra", "ruckig", "scipy", "matplotlib", "pydantic", "ruamel.yaml")
TINY = """MODULE Tiny
    CONST jointtarget j_home:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j_side:=[[20,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        MoveAbsJ j_side, v1000, fine, tool0;
        MoveAbsJ j_home, v1000, fine, tool0;
    ENDPROC
ENDMODULE
"""
CELL = "robot: irb140\nstart: {joints: '[0, 0, 0, 0, 30, 0] deg'}\n"


def loaded(code: str, *wanted: str) -> list[str]:
    """Which of wanted are imported after code, in a process of its own."""
    code += f"\nimport sys\nprint('loaded:', *[name for name in {wanted!r} if name in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=REPOSITORY)
    return done.stdout.splitlines()[-1].split()[1:]


def test_nothing_heavy_comes_with_the_package() -> None:
    assert loaded("import trajopt_cli; dir(trajopt_cli)", *HEAVY) == []


@pytest.mark.parametrize(
    ("arguments", "absent"),
    [(["--help"], HEAVY), (["parse", "programs/bench_irb140.mod"], ("casadi", "toppra", "scipy", "matplotlib"))],
)
def test_what_needs_no_solver_imports_none(arguments: list[str], absent: tuple[str, ...]) -> None:
    assert loaded(f"from trajopt_cli.cli import run; assert run({arguments!r}) == 0", *absent) == []


def test_the_table_of_doors_is_what_the_package_promises() -> None:
    assert set(trajopt_cli._DOORS) == set(trajopt_cli.__all__)
    assert set(trajopt_cli.__all__) <= set(dir(trajopt_cli))
    assert set(STEPS) <= set(trajopt_cli.__all__)


def test_type_checkers_see_the_same_as_python() -> None:
    """The names under TYPE_CHECKING are the very objects that the doors open to."""
    (block,) = [node for node in ast.parse(SOURCE).body if isinstance(node, ast.If)]
    seen = {}
    for node in block.body:
        assert isinstance(node, ast.ImportFrom)
        module = __import__(str(node.module), fromlist=["*"])
        seen |= {alias.name: getattr(module, alias.name) for alias in node.names}
    assert set(seen) == set(trajopt_cli.__all__) - NOT_YET
    for name, wanted in seen.items():
        assert getattr(trajopt_cli, name) is wanted


@pytest.mark.parametrize("name", [step for step in STEPS if step not in NOT_YET])
def test_every_step_can_be_called_and_says_how(name: str) -> None:
    door = getattr(trajopt_cli, name)
    assert callable(door)
    assert inspect.signature(door).parameters
    assert door.__doc__


def test_no_package_hides_a_step() -> None:
    """A package of a step's name would take its place as soon as it is imported."""
    assert not [step for step in STEPS if (REPOSITORY / "trajopt_cli" / step).exists()]


def test_another_name_is_no_door() -> None:
    with pytest.raises(AttributeError, match=r"^module 'trajopt_cli' has no attribute 'optimise'$"):
        trajopt_cli.optimise  # noqa: B018


def test_the_manuals_example_runs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Word for word, on two joint moves under the name of its program."""
    match = re.search(r"# From Python\n.*?```python\n(.+?)```", (REPOSITORY / "docs/python.md").read_text(), re.DOTALL)
    assert match
    monkeypatch.chdir(tmp_path)
    (tmp_path / "programs").mkdir()
    (tmp_path / "programs/bench_irb140.mod").write_text(TINY)
    (tmp_path / "programs/bench_irb140.yaml").write_text(CELL)
    exec(compile(match[1], "python.md", "exec"), {})
    cycle, verdict = capsys.readouterr().out.splitlines()
    # rest to rest over 20 deg and back, within 2.5 m/s of the tool: no closed form, but neither 0 nor a second each
    assert 0.2 < float(cycle.split()[0]) < 2.0
    assert verdict == "True"
    rows = (tmp_path / "joints.csv").read_text().splitlines()
    assert rows[0].startswith("t [s],joint_1 [rad],")
    assert float(rows[2].split(",")[0]) - float(rows[1].split(",")[0]) == pytest.approx(0.002)
    assert float(rows[-1].split(",")[0]) == pytest.approx(float(cycle.split()[0]), abs=1e-3)
