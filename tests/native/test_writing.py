"""Compiled functions against CasADi's own evaluation, operation by operation and in long lists."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca
import numpy as np
import pytest

from trajopt_cli.geometry import Array
from trajopt_cli.native import writing
from trajopt_cli.native.machine import machine

OPERATIONS: dict[str, Callable[[ca.SX, ca.SX], ca.SX]] = {
    "+": lambda x, y: x + y, "-": lambda x, y: x - y, "*": lambda x, y: x * y, "/": lambda x, y: x / y,
    "-x": lambda x, y: -x, "x^2": lambda x, y: x**2, "2x": lambda x, y: 2 * x, "1/x": lambda x, y: 1 / x,
    "x^3": lambda x, y: ca.fabs(x) ** 3.3, "x^y": lambda x, y: ca.fabs(x) ** y, "constant": lambda x, y: x * 0 + 0.1,
    "sqrt": lambda x, y: ca.sqrt(ca.fabs(x)), "max": ca.fmax, "min": ca.fmin, "<": lambda x, y: x < y,
    "<=": lambda x, y: x <= y, "==": lambda x, y: x == y, "!=": lambda x, y: x != y,
    "sin": lambda x, y: ca.sin(x), "cos": lambda x, y: ca.cos(x), "tan": lambda x, y: ca.tan(x),
    "asin": lambda x, y: ca.asin(x / 9), "acos": lambda x, y: ca.acos(x / 9), "atan": lambda x, y: ca.atan(x),
    "atan2": ca.atan2, "exp": lambda x, y: ca.exp(x), "log": lambda x, y: ca.log(ca.fabs(x)),
}  # fmt: skip


def evaluated(function: ca.Function, x: Array) -> Array:
    """Rows (n, m) of the compiled function at rows (n, k), n a multiple of the lanes."""
    lanes = machine().lanes
    kernel = machine().loaded(machine().compiled({"f": function}), ("f",))["f"]
    groups = len(x) // lanes
    packed = np.ascontiguousarray(x.reshape(groups, lanes, -1).transpose(0, 2, 1))
    out = np.full((groups, function.nnz_out(0), lanes), np.nan)
    kernel.bound(groups, packed, np.zeros(0), np.zeros(0), out)()
    return out.transpose(0, 2, 1).reshape(len(x), -1)


def test_every_operation_gives_what_casadi_gives() -> None:
    x = ca.SX.sym("x", 2)
    function = ca.Function("f", [x], [ca.vertcat(*(of(x[0], x[1]) for of in OPERATIONS.values()))])
    at = np.random.default_rng(3).normal(size=(4 * machine().lanes, 2)) * 2
    at[::5, 1] = at[::5, 0]  # equal ones
    wanted = np.array(function(at.T)).T
    assert np.all(np.isfinite(wanted))
    np.testing.assert_allclose(evaluated(function, at), wanted, rtol=1e-15, atol=0)


def test_values_reach_from_one_part_of_a_long_list_into_the_others(monkeypatch: pytest.MonkeyPatch) -> None:
    """Parts of seven instructions: nearly everything goes through memory, registers are used again and again."""
    x = ca.SX.sym("x", 5)
    rng, pool = np.random.default_rng(4), [x[i] for i in range(5)]
    for _ in range(300):
        a, b = (pool[rng.integers(max(0, len(pool) - 40), len(pool))] for _ in "ab")
        pool.append(rng.choice([lambda a, b: a * b, lambda a, b: ca.sin(a) - b])(a, b))
    function = ca.Function("f", [x], [ca.vertcat(*pool[-20:])])
    at = rng.uniform(-1, 1, (machine().lanes, 5))
    monkeypatch.setattr(writing, "CHUNK", 7)
    np.testing.assert_array_equal(evaluated(function, at), np.array(function(at.T)).T)


def test_what_is_found_in_several_places_is_worked_out_once() -> None:
    x = ca.SX.sym("x", 2)
    gives = [f(ca.sin(x[0] * x[1])) for f in (lambda y: y, lambda y: 2 + y, lambda y: y / 2)]
    function = ca.Function("f", [x], [ca.vertcat(*gives)])
    assert sum(function.instruction_id(k) == ca.OP_SIN for k in range(function.n_instructions())) == len(gives)
    assert writing.module_text({"f": function}, 4).count("call %V @lanes.sin") == 1
    at = np.random.default_rng(5).normal(size=(machine().lanes, 2))
    np.testing.assert_array_equal(evaluated(function, at), np.array(function(at.T)).T)


def test_a_negated_zero_keeps_its_sign() -> None:
    x = ca.SX.sym("x", 2)
    found = evaluated(ca.Function("f", [x], [-x]), np.tile([0.0, -0.0], (machine().lanes, 1)))
    assert np.all(np.signbit(found) == [True, False])


def test_what_has_no_counterpart_is_refused() -> None:
    x = ca.SX.sym("x")
    with pytest.raises(ValueError, match=r"erf: CasADi's operation .* has no counterpart in native code"):
        writing.module_text({"erf": ca.Function("f", [x], [ca.erf(x)])}, 4)
    with pytest.raises(ValueError, match="f: 4 inputs and 1 outputs; wanted at most 3 and 1"):
        writing.module_text({"f": ca.Function("f", [x] + [ca.SX.sym("y") for _ in range(3)], [x])}, 4)
