"""The files of rapid import each other without a circle: handlers know the Context, and no handler the interpreter."""

from __future__ import annotations

import ast
from graphlib import TopologicalSorter
from pathlib import Path

ROOT = Path(__file__).parents[2]


def imports() -> dict[str, set[str]]:
    """What each module of rapid imports of rapid, for types alone and inside functions too."""
    paths = (ROOT / "trajopt_cli" / "rapid").rglob("*.py")
    trees = {
        ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__"): ast.parse(path.read_text())
        for path in paths
    }
    graph: dict[str, set[str]] = {}
    for name, tree in trees.items():
        nodes = [node for node in ast.walk(tree) if isinstance(node, ast.ImportFrom) and node.module]
        found = {f"{node.module}.{one.name}" for node in nodes for one in node.names} | {str(n.module) for n in nodes}
        graph[name] = {one for one in found & trees.keys() if not one.endswith(("instructions", "functions", "rapid"))}
    return graph


def test_no_file_of_rapid_imports_itself_by_way_of_others() -> None:
    TopologicalSorter(imports()).prepare()


def test_no_handler_knows_the_interpreter() -> None:
    interpreter = "trajopt_cli.rapid.execution.interpreter"
    assert {name for name, known in imports().items() if interpreter in known} == {"trajopt_cli.rapid.reader"}
