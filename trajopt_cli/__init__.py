"""trajopt: the fastest legal motion for the robot program a cell already runs.

The data's journey, each step a function: read_program, load_cell, build_plant, build_problem, optimize, verify,
export. What they need is imported when they are first asked for.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from trajopt_cli.cell.loader import load_cell
    from trajopt_cli.errors import InputError
    from trajopt_cli.exporters.files import export
    from trajopt_cli.judge.verify import verify
    from trajopt_cli.plan import optimize
    from trajopt_cli.problem.build import build_problem
    from trajopt_cli.problem.plan import Infeasible, Target
    from trajopt_cli.problem.plant import build_plant
    from trajopt_cli.rapid.reader import read_program

__version__ = "0.2.0"
__all__ = [
    "Infeasible",
    "InputError",
    "Target",
    "build_plant",
    "build_problem",
    "export",
    "load_cell",
    "optimize",
    "read_program",
    "verify",
]

# Where each stands.
_DOORS = {
    "read_program": "trajopt_cli.rapid.reader:read_program",
    "load_cell": "trajopt_cli.cell.loader:load_cell",
    "build_plant": "trajopt_cli.problem.plant:build_plant",
    "build_problem": "trajopt_cli.problem.build:build_problem",
    "optimize": "trajopt_cli.plan:optimize",
    "verify": "trajopt_cli.judge.verify:verify",
    "export": "trajopt_cli.exporters.files:export",
    "Target": "trajopt_cli.problem.plan:Target",
    "Infeasible": "trajopt_cli.problem.plan:Infeasible",
    "InputError": "trajopt_cli.errors:InputError",
}


def __getattr__(name: str) -> object:
    if name not in _DOORS:
        raise AttributeError(f"module 'trajopt_cli' has no attribute '{name}'")
    module, attribute = _DOORS[name].split(":")
    return getattr(import_module(module), attribute)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
