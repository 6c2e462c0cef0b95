"""A cell before anything is planned: its bodies as a table, and a page that draws them."""

from __future__ import annotations

import numpy as np

from trajopt_cli.page.document import Section, document
from trajopt_cli.page.encode import text
from trajopt_cli.page.scene import HOLDER, SCRIPTS, plant_scene
from trajopt_cli.page.tables import drawn, points
from trajopt_cli.problem.plant import Plant
from trajopt_cli.scene import Cycle, tables_of
from trajopt_cli.shapes import Mesh, Shape, Solid, outline
from trajopt_cli.table import TextTable, tabulate
from trajopt_cli.units import MM

_TURN = 4.0  # s in which the page turns every positioner through its range


def bodies_table(plant: Plant) -> TextTable:
    """What stands in a cell and what the flange carries: a row for each body, with the box around it as it stands."""
    columns = {
        "~body": lambda one: one.name,
        "kind": lambda one: _kind(one.loaded),
        "size [mm]": lambda one: _figures(np.ptp(_ends(one.loaded), axis=0)),
        "middle [mm]": lambda one: _figures(_ends(one.loaded).mean(axis=0)),
        "on": lambda one: _carrier(plant, one),
        "may touch": lambda one: ", ".join(sorted(one.ignore)),
    }
    return tabulate("Bodies: the box around each, in the world or on the flange", _all(plant), columns)


def bodies_record(plant: Plant) -> list[dict[str, object]]:
    """The same as plain data [m]."""
    return [
        {"name": one.name, "kind": _kind(one.loaded), "low": low.tolist(), "high": high.tolist(),
         "on": _carrier(plant, one), "ignore": sorted(one.ignore)}
        for one in _all(plant)
        for low, high in [_ends(one.loaded)]
    ]  # fmt: skip


def cell_page(plant: Plant, title: str) -> bytes:
    """The page of a cell at its start, robot and bodies; where bodies ride on positioners, its clock turns these from
    the start to the ends of their ranges and back."""
    tables = tables_of(plant)
    ranges = np.array([plant.units[one.unit][one.number].range for one in tables]).reshape(-1, 2)
    since = ranges - np.array([[one.start] for one in tables]).reshape(-1, 1)
    turned = np.stack([0 * since[:, 0], since[:, 1], since[:, 0], 0 * since[:, 0]])
    t = np.linspace(0, _TURN, 4)
    cycle = Cycle("at the start", t, np.tile(plant.start, (4, 1)), turned=turned if tables else None)
    clock = {"duration": _TURN, "cycles": [{"name": "at the start", "duration": _TURN}]}
    data = {"clock": clock, "scene": plant_scene(plant, [], [cycle])}
    lead = "Play turns each positioner through its range." if tables else "The robot stands at its start."
    sections = [
        Section("cell", "The cell", HOLDER, lead),
        Section("bodies", "Bodies", drawn(bodies_table(plant)) + points(plant.unchecked)),
    ]
    return document(f"{title} · trajopt", f"<h1>{text(title)}</h1>", sections, data, SCRIPTS)


def _all(plant: Plant) -> tuple[Solid, ...]:
    return (*plant.obstacles, *plant.attached)


def _carrier(plant: Plant, solid: Solid) -> str:
    if solid.rides is None:
        return "flange" if solid in plant.attached else ""
    return solid.rides.unit + (f".{solid.rides.axes}" if len(plant.units[solid.rides.unit]) > 1 else "")


def _kind(shape: Shape) -> str:
    if not isinstance(shape, Mesh):
        return type(shape).__name__.lower()
    from trajopt_cli.proximity.meshes import convex

    return f"mesh of {len(shape.triangles):,}, {'surface' if convex(shape) is None else 'solid'}"


def _ends(shape: Shape) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """The lowest and the highest corner (2, 3) of the box around a shape, along the axes it is given in."""
    corners, radius = outline(shape)
    if isinstance(shape, Mesh):
        corners = shape.vertices @ shape.X[:3, :3].T + shape.X[:3, 3]
    return np.array([corners.min(axis=0) - radius, corners.max(axis=0) + radius])


def _figures(values: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> str:
    return " ".join(f"{value / MM + 0.0:.0f}" for value in values)
