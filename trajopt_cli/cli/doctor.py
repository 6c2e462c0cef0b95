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
    from trajopt_cli.cli.console import print_json, result, stdout, tell
    from trajopt_cli.cli.health import State, looked_at

    found = looked_at()
    wrong = [one for one in found if one.state is State.WRONG]
    if as_json:
        checks = [
            {"what": one.what, "state": one.state.value, "found": one.found, "remedy": one.remedy} for one in found
        ]
        print_json({"healthy": not wrong, "checks": checks})
    elif not quiet:
        console = stdout()
        for one in found:
            tell(
                console,
                [f"{one.state.value:<7}  {one.what}: {one.found}", *([f"         {one.remedy}"] if one.remedy else [])],
            )
        console.print()
    last = "; ".join(f"{one.what}: {one.found}" for one in wrong)
    if not as_json:
        result(f"something is missing: {last}" if wrong else "all that is needed is there")
    if wrong:
        raise typer.Exit(1)
