"""A constraint with named variables and parameters: what is written down in the formulation, and how it is used."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import prod
from types import SimpleNamespace

import casadi as ca
import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array
from trajopt_cli.nlp.block import Block, Expressed, express
from trajopt_cli.nlp.block_cache import Library
from trajopt_cli.nlp.nlp_assembly import BlockNlp
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
    def of(cls, library: Library, name: str, key: str, z: Shapes, p: Shapes, rows: Rows) -> Relation:
        """From rows(z, p) -> [(expression, lower, upper), ...], where z.v is the variable named v. key: equal for
        relations with equal rows only."""
        z_layout, p_layout = Layout(z), Layout(p)

        def flat(z: ca.SX, p: ca.SX) -> Sequence[tuple[ca.SX, float, float]]:
            return rows(SimpleNamespace(**z_layout.split(z)), SimpleNamespace(**p_layout.split(p)))

        def expressed() -> Expressed:
            return express(z_layout.size, p_layout.size, flat)

        return cls(z_layout, p_layout, library.block(name, key, expressed))

    def holds(self, nlp: BlockNlp, z: Parts, p: Parts = NOTHING) -> None:
        """Demand it of the variables with these indices and parameters with these values, or of many at once: parts
        that differ from one to the next have an axis (n, ...) more, in front. Raises ValueError for names or shapes
        that are not the relation's."""
        Z, P = _flat(self.z, z).astype(np.intp), _flat(self.p, p)
        n = max(len(Z), len(P))
        nlp.add(self.block, np.broadcast_to(Z, (n, Z.shape[1])), np.broadcast_to(P, (n, P.shape[1])))

    def value(self, z: Parts, p: Parts = NOTHING) -> Array:
        """g (m,) at values of z and p."""
        return self.block.values(_flat(self.z, z), _flat(self.p, p))[0][0]


def _flat(layout: Layout, parts: Parts) -> Array:
    """Rows (n, size) of all parts side by side; n is 1 where none has an axis more than its shape."""
    if parts.keys() != layout.shapes.keys():
        raise ValueError(f"the parts are {', '.join(layout.shapes)}; found {', '.join(parts)}")
    arrays = {name: np.asarray(part, dtype=np.float64) for name, part in parts.items()}
    n = next((len(arrays[name]) for name, shape in layout.shapes.items() if arrays[name].ndim > len(shape)), 1)
    out, at = np.empty((n, layout.size)), 0
    for name, shape in layout.shapes.items():
        part, size = arrays[name], prod(shape)
        if part.shape not in (shape, (n, *shape)):
            raise ValueError(f"{name} has shape {part.shape}, wanted {shape} or {(n, *shape)}")
        if len(shape) > 1:  # column by column
            part = np.swapaxes(part, -1, -2)
        out[:, at : at + size] = part.reshape(n if part.ndim > len(shape) else 1, size)
        at += size
    return out
