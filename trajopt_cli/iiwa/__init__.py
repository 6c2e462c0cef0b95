"""The compliant job: segments for a KUKA LBR iiwa, its joints, controller, judge and experiments, behind one door.

Commands call what is named here and nothing further inside; each is imported when it is first asked for.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from trajopt_cli.iiwa.experiments.catalogue import run_experiments
    from trajopt_cli.iiwa.job.commands import commanded, joints, schedule_feed, segments, simulate
    from trajopt_cli.iiwa.judge.verify import verify_folder, verify_joints
    from trajopt_cli.iiwa.report.answer import Answer, Refused
    from trajopt_cli.iiwa.task.document import task_schema

_MODULES = {
    "experiments.catalogue": ("run_experiments",),
    "job.commands": ("commanded", "joints", "schedule_feed", "segments", "simulate"),
    "judge.verify": ("verify_folder", "verify_joints"),
    "report.answer": ("Answer", "Refused"),
    "task.document": ("task_schema",),
}

__all__ = [
    "Answer",
    "Refused",
    "commanded",
    "joints",
    "run_experiments",
    "schedule_feed",
    "segments",
    "simulate",
    "task_schema",
    "verify_folder",
    "verify_joints",
]


def __getattr__(name: str) -> object:
    for module, names in _MODULES.items():
        if name in names:
            return getattr(import_module(f"trajopt_cli.iiwa.{module}"), name)
    raise AttributeError(f"module 'trajopt_cli.iiwa' has no attribute '{name}'")
