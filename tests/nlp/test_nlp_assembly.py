"""Programs put together from blocks: known optima, and derivatives against casadi's own of the same program."""

from __future__ import annotations

from pathlib import Path

import casadi as ca
import numpy as np
import pytest

from trajopt_cli.native.machine import machine
from trajopt_cli.native.store import Store
from trajopt_cli.nlp.block import Block, express
from trajopt_cli.nlp.block_cache import Library, Maps, Native
from trajopt_cli.nlp.nlp_assembly import BlockNlp

INF = float("inf")


def product_block() -> Block:
    """a b >= c."""
    return express(2, 1, lambda z, p: [(z[0] * z[1] - p[0], 0.0, INF)]).block("product")


def curvy_rows(z: ca.SX, p: ca.SX) -> list[tuple[ca.SX, float, float]]:
    return [(ca.sin(z[0] * z[1]) * p[0] + z[2] ** 3, -1.0, 2.0), (ca.vertcat(z[1] * z[2], z[0] - p[1]), -3.0, 3.0)]


def linear_rows(z: ca.SX, p: ca.SX) -> list[tuple[ca.SX, float, float]]:
    return [(z[0] - 2 * z[1], -0.5, 0.5)]


def test_copies_that_share_a_variable_find_the_known_optimum() -> None:
    """min x + y + z with xy >= 1 and yz >= 4: x = 1/y, z = 4/y, y = sqrt 5."""
    nlp, block = BlockNlp(), product_block()
    x = nlp.variables(np.ones(3), 0.01, 100.0)
    for i in x:
        nlp.minimise(int(i))
    nlp.add(block, x[:2], [1.0])
    nlp.add(block, x[1:], [4.0])
    result = nlp.solve()
    assert result.converged
    r = np.sqrt(5)
    np.testing.assert_allclose(result.x, [1 / r, r, 4 / r], atol=1e-7)
    # 1 = lambda1 y at x, 1 = lambda2 y at z: both multipliers are -1/y in casadi's sign
    np.testing.assert_allclose(result.lam_g, [-1 / r, -1 / r], atol=1e-6)


def test_weights_add_up_and_bounds_hold() -> None:
    """min 2x + 2x + y with xy >= 1 and x >= 0.4 or more: y = 1/x, x = 1/2; then the bound 0.7 binds."""
    for low, wanted in ((0.01, 0.5), (0.7, 0.7)):
        nlp = BlockNlp()
        x, y = nlp.variables([1.0], low, 10.0), nlp.variables([1.0], 0.0, 10.0)
        nlp.minimise(int(x[0]), 2.0)
        nlp.minimise(int(x[0]), 2.0)
        nlp.minimise(int(y[0]))
        nlp.add(product_block(), np.r_[x, y], [1.0])
        result = nlp.solve()
        np.testing.assert_allclose(result.x, [wanted, 1 / wanted], atol=1e-6)


def test_damped_variables_have_their_parabola() -> None:
    """min x + y + 0.3/2 x^2, twice damped, x - 2y in [-0.5, 0.5]; y = (x - 0.5)/2 and 1.5 + 0.3 x = 0."""
    nlp = BlockNlp()
    x = nlp.variables(np.zeros(2), -50.0, 50.0)
    nlp.minimise(int(x[0]))
    nlp.minimise(int(x[1]))
    nlp.damp(x[:1], 0.1)
    nlp.damp(x[:1], 0.2)
    nlp.add(express(2, 0, linear_rows).block("line"), x)
    result = nlp.solve()
    np.testing.assert_allclose(result.x, [-5.0, -2.75], atol=1e-6)


def assembled(library: Library, repeat: bool) -> tuple[BlockNlp, list[tuple[np.ndarray, np.ndarray]]]:
    """Seven variables, three copies of a curvy block that share some, in no order, and two linear ones."""
    nlp = BlockNlp()
    first, second = nlp.variables(np.arange(4.0), -9.0, 9.0), nlp.variables(np.ones(3), -9.0, 9.0)
    x = np.r_[first, second]
    curvy = library.block("curvy", "curvy", lambda: express(3, 2, curvy_rows))
    line = library.block("line", "line", lambda: express(2, 0, linear_rows))
    copies = [(x[[0, 1, 2]], [0.7, 0.1]), (x[[5, 2, 0]], [1.3, -0.4]), (x[[6, 3, 2]], [-2.0, 0.9])]
    if repeat:
        copies.append((x[[4, 4, 1]], [0.5, 0.5]))
    for i, (z, p) in enumerate(copies):
        nlp.add(curvy, z, p)
        if i < 2:
            nlp.add(line, x[[i, 4]])
    for i, weight in ((0, 1.0), (4, 2.5), (0, 0.5)):
        nlp.minimise(int(x[i]), weight)
    nlp.damp(x[1:4], 0.02)
    nlp.damp(x[2:6], 0.03)
    nlp.build()
    return nlp, [(z, np.array(p)) for z, p in copies]


@pytest.mark.parametrize("native", [False, True], ids=["by casadi", "native"])
def test_assembled_derivatives_equal_casadis(native: bool, tmp_path: Path) -> None:
    compare(*assembled(Native(machine(), Store(tmp_path)) if native else Maps(), repeat=False))


def test_a_copy_that_holds_a_variable_twice_is_refused() -> None:
    with pytest.raises(ValueError, match=r"block curvy: a variable stands twice in z = \[4, 4, 1\]"):
        assembled(Maps(), repeat=True)


def compare(nlp: BlockNlp, copies: list[tuple[np.ndarray, np.ndarray]]) -> None:
    """One expression of the whole program, differentiated by casadi, in the blocks' order."""
    x = ca.MX.sym("x", 7)
    g = []
    for z, p in copies:
        v = [x[int(i)] for i in z]
        g += [ca.sin(v[0] * v[1]) * p[0] + v[2] ** 3, v[1] * v[2], v[0] - p[1]]
    g += [x[0] - 2 * x[4], x[1] - 2 * x[4]]
    g = ca.vertcat(*g)
    f = 1.5 * x[0] + 2.5 * x[4] + 0.01 * ca.sumsqr(x[1:4]) + 0.015 * ca.sumsqr(x[2:6])
    lam, sigma = ca.MX.sym("lam", g.numel()), ca.MX.sym("sigma")
    lagrangian = sigma * f + ca.dot(lam, g)
    whole = ca.Function(
        "w",
        [x, sigma, lam],
        [f, ca.gradient(f, x), g, ca.jacobian(g, x), ca.triu(ca.hessian(lagrangian, x)[0])],
    )
    of = nlp._evaluation
    of.put([held.all_p for held in nlp._held.values()])
    rng = np.random.default_rng(1)
    for _ in range(5):
        at, multipliers = rng.normal(size=7), rng.normal(size=g.numel())
        f_0, grad_0, g_0, jac_0, hess_0 = (np.squeeze(o.full()) for o in whole(at, 1.0, multipliers))
        f_1, grad_1, g_1 = of.cost(at), of.gradient(at), of.constraints(at)
        jac_1, hess_1 = np.zeros((g.numel(), 7)), np.zeros((7, 7))
        np.add.at(jac_1, of.jacobian_at, of.jacobian(at))
        np.add.at(hess_1, of.hessian_at, of.hessian(at, multipliers))
        for ours, theirs in ((f_1, f_0), (grad_1, grad_0), (g_1, g_0), (jac_1, jac_0), (hess_1, hess_0)):
            np.testing.assert_allclose(ours, theirs, rtol=0, atol=1e-13)
    assert np.all(np.tril(hess_1, -1) == 0)


def test_a_warm_start_from_the_answer_needs_few_iterations() -> None:
    block = product_block()

    def build(c: float) -> BlockNlp:
        nlp = BlockNlp()
        x = nlp.variables(np.ones(3), 0.01, 100.0)
        for i in x:
            nlp.minimise(int(i))
        nlp.add(block, x[:2], [1.0])
        nlp.add(block, x[1:], [c])
        return nlp

    first = build(4.0)
    cold = first.solve()
    second = build(4.2)
    second.adopt(first)
    warm = second.solve(cold, mu=1e-6)
    assert warm.converged
    assert warm.iterations < cold.iterations
    # parameters are the second program's own, though the functions are the first one's
    assert warm.x[0] == pytest.approx(1 / np.sqrt(5.2), abs=1e-6)


def test_programs_of_different_structure_are_not_adopted() -> None:
    block = product_block()
    a, b = BlockNlp(), BlockNlp()
    for nlp, order in ((a, [0, 1]), (b, [1, 0])):
        x = nlp.variables(np.ones(2), 0.1, 9.0)
        nlp.minimise(0)
        nlp.add(block, x[order], [1.0])
    a.build()
    with pytest.raises(ValueError, match="the two programs differ in structure"):
        b.adopt(a)


def test_a_copy_of_the_wrong_size_is_refused() -> None:
    nlp = BlockNlp()
    x = nlp.variables(np.ones(3), 0.0, 1.0)
    with pytest.raises(ValueError, match=r"block product: z \(1, 3\), p \(1, 1\); wanted \(n, 2\), \(n, 1\)"):
        nlp.add(product_block(), x, [1.0])
    with pytest.raises(ValueError, match=r"block product: z \(1, 2\), p \(1, 0\); wanted \(n, 2\), \(n, 1\)"):
        nlp.add(product_block(), x[:2])


def test_what_has_no_answer_is_not_called_converged() -> None:
    """xy >= 1 with both at most 0.5."""
    nlp = BlockNlp()
    x = nlp.variables([0.4, 0.4], 0.0, 0.5)
    nlp.minimise(0)
    nlp.add(product_block(), x, [1.0])
    assert not nlp.solve().converged


def test_many_copies_at_once_are_as_many_one_by_one() -> None:
    """And none at all is no copy."""
    rng, curvy = np.random.default_rng(2), express(3, 2, curvy_rows).block("curvy")
    where, p = np.array([[0, 1, 2], [5, 2, 0], [6, 3, 2]]), rng.normal(size=(3, 2))
    once, singly = BlockNlp(), BlockNlp()
    for nlp in (once, singly):
        nlp.variables(np.ones(7), -9.0, 9.0)
        nlp.add(curvy, np.zeros((0, 3)), np.zeros((0, 2)))
        assert nlp.empty
    once.add(curvy, where, p)
    for row, parameters in zip(where, p, strict=True):
        singly.add(curvy, row, parameters)
    for nlp in (once, singly):
        nlp.minimise(0)
    np.testing.assert_array_equal(once.solve(most=5).x, singly.solve(most=5).x)
