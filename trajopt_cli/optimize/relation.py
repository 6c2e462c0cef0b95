"""A constraint with named variables and parameters: what is written down in the formulation, and how it is used."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from types import SimpleNamespace

import casadi as ca
import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array
from trajopt_cli.optimize.blocks import Block, BlockNlp, make_block
from trajopt_cli.path.symbols import Layout

Shapes = Mapping[str, tuple[int, ...]]
Rows = Callable[[SimpleNamespace, SimpleNamespace], Sequence[tuple[ca.SX, float, float]]]
Parts = Mapping[str, ArrayLike]
NOTHING: Parts = {}


@dataclass(frozen=True, eq=False)
class Relation:
    """lower <= g(z, p) <= upper for variables z and parameters p, each with names."""

    z: Layout
    p: Layout
    block: Block

    @classmethod
    def of(cls, name: str, z: Shapes, p: Shapes, rows: Rows) -> Relation:
        """From rows(z, p) -> [(expression, lower, upper), ...], where z.v is the variable named v."""
        z_layout, p_layout = Layout(z), Layout(p)

        def flat(z: ca.SX, p: ca.SX) -> Sequence[tuple[ca.SX, float, float]]:
            return rows(SimpleNamespace(**z_layout.split(z)), SimpleNamespace(**p_layout.split(p)))

        return cls(z_layout, p_layout, make_block(name, z_layout.size, p_layout.size, flat))

    def holds(self, nlp: BlockNlp, z: Parts, p: Parts = NOTHING) -> None:
        """Demand it of the variables with these indices and parameters with these values. Raises ValueError for names
        or shapes that are not the relation's."""
        nlp.add(self.block, _flat(self.z, z).astype(np.intp), _flat(self.p, p))

    def value(self, z: Parts, p: Parts = NOTHING) -> Array:
        """g (m,) at values of z and p."""
        return np.ravel(self.block.g(_flat(self.z, z), _flat(self.p, p)))


def _flat(layout: Layout, parts: Parts) -> Array:
    return layout.vector(parts) if parts or layout.size else np.zeros(0)
