"""`trajopt doctor`: what is installed, what is missing and how to get it, and whether a small problem is solved."""

from __future__ import annotations

import typer

from trajopt_cli.cli.options import AsJson, Quiet


def doctor(as_json: AsJson = False, quiet: Quiet = False) -> None:
    """Look at Python, packages, extras, cache, cores and memory, and solve a problem whose answer is known.

    Exit code 1 when something is missing that trajopt needs. Send the output along with a report of an error.

    \b
    Example:
      trajopt doctor
    """
    from trajopt_cli.cli.console import print_answer
    from trajopt_cli.cli.health import State, looked_at

    found = looked_at()
    wrong = [one for one in found if one.state is State.WRONG]
    checks = [{"what": one.what, "state": one.state.value, "found": one.found, "remedy": one.remedy} for one in found]
    lines = [(f"{one.state.value:<7}  {one.what}: {one.found}", one.remedy and " " * 9 + one.remedy) for one in found]
    missing = "; ".join(f"{one.what}: {one.found}" for one in wrong)
    last = f"something is missing: {missing}" if wrong else "all that is needed is there"
    told = [*(line for both in lines for line in both if line), "", last]
    print_answer(as_json, quiet, lambda: {"healthy": not wrong, "checks": checks}, last, told)
    if wrong:
        raise typer.Exit(1)
