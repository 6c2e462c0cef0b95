"""`trajopt play egm FILE|RESULTS`: a stream tried on a simulated controller, on the loopback."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from threading import Thread
from typing import TYPE_CHECKING, Annotated

import typer

from trajopt_cli.cli import options as opt
from trajopt_cli.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Iterable

    from trajopt_cli.exporters.egm import Stream
    from trajopt_cli.exporters.egm_player import Lag
    from trajopt_cli.table import TextTable

app = typer.Typer(help="Play a stream to a simulated controller on this machine.", rich_markup_mode=None)
_SETTLED = 10  # time constants behind the last set point, in which a follower arrives


@app.callback()
def _group() -> None:
    """Play a stream to a simulated controller on this machine: it moves no robot."""


@app.command("egm", short_help="Answer EGM on the loopback; log and lag of what comes back.")
def egm(
    source: Annotated[
        Path, typer.Argument(metavar="FILE|RESULTS", help="File of trajopt export egm, or folder of trajopt optimize.")
    ],
    to: Annotated[
        str, opt.given("--to", "HOST:PORT", "Loopback address that a simulated controller sends to.")
    ] = "127.0.0.1:6510",
    log: Annotated[Path | None, opt.given("--log", "FILE.csv", "Write what came back, and what was set.")] = None,
    constant: Annotated[
        float, opt.given("--follower-time-constant", "S", "Of the first-order follower that predicts lag.")
    ] = 0.05,
    echo: Annotated[
        bool, typer.Option("--echo", help="Be the controller, too: such a follower, as fast as answers come.")
    ] = False,
    silence: Annotated[float, opt.given("--silence", "S", "How long to wait for a message of the controller.")] = 30.0,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
) -> None:
    """Answer every EgmRobot message with the set point due on the controller's clock, and say how far every axis lags.

    \b
    Example:
      trajopt play egm results/hinge_cell --echo --log back.csv
    """
    from trajopt_cli.cli.console import print_json, show, stdout
    from trajopt_cli.cli.export import check_output
    from trajopt_cli.exporters.egm_player import address, bound, lags, log_text, play, simulated_controller
    from trajopt_cli.runs.files import write_file

    for value, option in ((constant, "--follower-time-constant"), (silence, "--silence")):
        if not 0 < value < 1e4:
            raise InputError(f"{option} {value:g}: wanted seconds above 0 and below 10,000")
    host, port = address(to)
    if log is not None:
        check_output(log, source, "--log")
    stream, settle = _stream(source), _SETTLED * constant
    with bound(host, port) as here:
        port = here.getsockname()[1]
        if not quiet:
            typer.echo(
                f"{source}: {len(stream.q)} set points in {stream.duration:.3f} s, answered on {host}:{port}", err=True
            )
        if echo:
            arguments = stream, (host, port), constant, settle
            Thread(target=simulated_controller, args=arguments, daemon=True).start()
        played = play(stream, here, settle, silence)
    if log is not None and len(played.t):
        write_file(log, log_text(stream, played).encode("ascii"))
    found = list(lags(stream, constant, played))
    if as_json:
        told = {"answered": len(played.t), "lost": played.lost, "strangers": played.strangers}
        print_json({**told, "axes": [asdict(lag) for lag in found], "why_not": played.why_not or None})
    elif not quiet:
        show(stdout(), _table(constant, found))
    if len(played.t) and not as_json:
        also = f", {played.strangers} datagrams that were none of its messages" if played.strangers else ""
        typer.echo(f"{len(played.t)} messages of the controller answered, {played.lost} lost{also}")
    if log is not None and len(played.t) and not as_json and not quiet:
        typer.echo(f"{log}: what came back, {len(played.t)} rows")
    if played.why_not:
        typer.echo(played.why_not, err=True)
        raise typer.Exit(1)


def _stream(source: Path) -> Stream:
    from trajopt_cli.cli.export import egm_stream
    from trajopt_cli.exporters.egm import read_stream
    from trajopt_cli.runs.folder import read_bytes

    if source.is_dir():
        return egm_stream(source)[1]
    if source.exists() and not source.is_file():
        raise InputError("is not a regular file; give one of trajopt export egm", file=str(source))
    return read_stream(read_bytes(source), str(source))


def _table(constant: float, found: Iterable[Lag]) -> TextTable:
    from trajopt_cli.table import tabulate

    return tabulate(
        f"lag behind the set points, predicted for a follower of {1000 * constant:g} ms",
        found,
        {
            "axis": lambda lag: lag.name,
            ">fastest": lambda lag: f"{lag.fastest:.2f}",
            "": lambda lag: f"{lag.unit}/s",
            ">speed x time": lambda lag: f"{lag.ramp:.3f}",
            ">predicted": lambda lag: f"{lag.foretold:.3f}",
            ">received": lambda lag: "" if lag.measured is None else f"{lag.measured:.3f}",
            " ": lambda lag: lag.unit,
            ">as of": lambda lag: "" if lag.constant is None else f"{1000 * lag.constant:.1f} ms",
        },
    )
