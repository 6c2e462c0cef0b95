"""`trajopt parse PROGRAM`: the flat motions, each with its place."""

from __future__ import annotations

from trajopt_cli.cli.options import AsJson, CellPath, ProgramPath


def parse(program: ProgramPath, cell: CellPath = None, as_json: AsJson = False) -> None:
    """Run PROGRAM on paper and print its motions in order, each with file and line, in the units of RAPID.

    Needs no cell file; where there is one, its signal values and waits are used.
    """
    import json

    import typer

    from trajopt_cli.job import cell_for, read_flat, scenario_of
    from trajopt_cli.rapid.listing import describe

    flat = read_flat([program], scenario_of(cell_for([program], cell)))
    listing = describe(flat)
    if as_json:
        from trajopt_cli.cli.listing_record import listing_record

        typer.echo(json.dumps(listing_record(flat, listing), indent=2, ensure_ascii=False, allow_nan=False))
        return
    from trajopt_cli.cli.console import stdout
    from trajopt_cli.cli.listing import listing_table

    console = stdout()
    console.print(listing_table(str(program), listing))
    console.print(f"{len(listing.rows)} motions, {listing.line_length:.1f} mm of lines with a known start")
    if listing.fly_by:
        console.print(f"{listing.fly_by} fly-by zones; optimize plans them as stops")
    for warning in flat.warnings:
        console.print(f"warning: {warning}")
