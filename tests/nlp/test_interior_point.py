"""The interior point against optima known in closed form, and against IPOPT on programs nobody chose."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.nlp.interior_point import Bounds, InteriorPoint, NlpResult

INF = float("inf")


class Written:
    """A program as casadi differentiates it in one piece."""

    def __init__(self, x: ca.MX, f: ca.MX, g: ca.MX):
        lam = ca.MX.sym("lam", g.numel())
        self.x, self.f, self.g = x, f, g
        jacobian, hessian = ca.jacobian(g, x), ca.triu(ca.hessian(f + ca.dot(lam, g), x)[0])
        self.jacobian_at, self.hessian_at = places(jacobian), places(hessian)
        self._f = ca.Function("f", [x], [f, ca.gradient(f, x)])
        self._g = ca.Function("g", [x], [g, ca.densify(jacobian.nz[:])])
        self._h = ca.Function("h", [x, lam], [ca.densify(hessian.nz[:])])

    def cost(self, x: Array) -> float:
        return float(self._f(x)[0])

    def gradient(self, x: Array) -> Array:
        return self._f(x)[1].full().ravel()

    def constraints(self, x: Array) -> Array:
        return self._g(x)[0].full().ravel()

    def jacobian(self, x: Array) -> Array:
        return self._g(x)[1].full().ravel()

    def hessian(self, x: Array, lam: Array) -> Array:
        return self._h(x, lam).full().ravel()


def places(of: ca.MX) -> tuple[IndexArray, IndexArray]:
    rows, cols = of.sparsity().get_triplet()
    return np.array(rows, dtype=np.intp), np.array(cols, dtype=np.intp)


def solved(
    program: Written,
    bounds: Bounds,
    start: Array | NlpResult,
    mu: float = 0.1,
    most: int = 200,
    tolerance: float = 1e-9,
) -> NlpResult:
    free, equations = bounds.lower < bounds.upper, bounds.g_lower == bounds.g_upper
    solver = InteriorPoint(program.jacobian_at, program.hessian_at, free, equations)
    return solver.solve(program, bounds, start, mu, 1e-9, most)


def box(n: int, low: float, high: float, g_lower: list[float], g_upper: list[float]) -> Bounds:
    return Bounds(np.full(n, low), np.full(n, high), np.array(g_lower), np.array(g_upper))


def hock_schittkowski_71() -> tuple[Written, Bounds, Array]:
    x = ca.MX.sym("x", 4)
    f = x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2]
    program = Written(x, f, ca.vertcat(x[0] * x[1] * x[2] * x[3], ca.sumsqr(x)))
    return program, box(4, 1.0, 5.0, [25.0, 40.0], [INF, 40.0]), np.array([1.0, 5.0, 5.0, 1.0])


def test_a_textbook_program_ends_at_its_published_optimum() -> None:
    program, bounds, start = hock_schittkowski_71()
    found = solved(program, bounds, start)
    assert found.converged
    np.testing.assert_allclose(found.x, [1.0, 4.742999, 3.821151, 1.379408], atol=1e-5)
    assert program.cost(found.x) == pytest.approx(17.0140173, abs=1e-6)
    assert found.off < 1e-9


def test_at_the_end_the_multipliers_balance_the_slopes() -> None:
    program, bounds, start = hock_schittkowski_71()
    found = solved(program, bounds, start)
    J = np.zeros((2, 4))
    J[program.jacobian_at] = program.jacobian(found.x)
    np.testing.assert_allclose(program.gradient(found.x) + J.T @ found.lam_g + found.lam_x, 0, atol=1e-6)
    assert found.lam_x[0] < -0.5  # x_0 stands at its lower bound
    assert found.lam_g[0] < 0  # and the first row at its own


def test_where_the_cost_is_saddle_shaped_it_goes_downhill() -> None:
    """min x y on a disc: -1/2 at (1, -1)/sqrt 2 or its opposite; the saddle at 0 is no answer."""
    x = ca.MX.sym("x", 2)
    program = Written(x, x[0] * x[1], ca.sumsqr(x))
    found = solved(program, box(2, -9.0, 9.0, [-INF], [1.0]), np.array([0.1, 0.05]))
    assert found.converged
    assert program.cost(found.x) == pytest.approx(-0.5, abs=1e-7)


def test_fixed_variables_keep_their_values() -> None:
    """min x + y with x y >= 4 and y fixed at 8: x = 1/2."""
    x = ca.MX.sym("x", 2)
    program = Written(x, x[0] + x[1], x[0] * x[1])
    bounds = Bounds(np.array([0.01, 8.0]), np.array([100.0, 8.0]), np.array([4.0]), np.array([INF]))
    found = solved(program, bounds, np.array([5.0, 1.0]))
    np.testing.assert_allclose(found.x, [0.5, 8.0], atol=1e-7)


def test_equations_that_say_the_same_twice_are_no_obstacle() -> None:
    x = ca.MX.sym("x", 2)
    program = Written(x, ca.sumsqr(x), ca.vertcat(x[0] + x[1], 2 * x[0] + 2 * x[1]))
    found = solved(program, box(2, -9.0, 9.0, [2.0, 4.0], [2.0, 4.0]), np.zeros(2))
    assert found.converged
    np.testing.assert_allclose(found.x, [1.0, 1.0], atol=1e-6)


def test_what_cannot_be_is_not_called_solved() -> None:
    x = ca.MX.sym("x", 1)
    found = solved(Written(x, x[0], x[0] ** 2), box(1, -9.0, 9.0, [-2.0], [-1.0]), np.ones(1))
    assert not found.converged
    assert found.off > 0.9


def test_a_point_without_a_value_is_left() -> None:
    """min -x with log(2 - x) >= -3: a full step from the start leads beyond 2, where there is no logarithm."""
    x = ca.MX.sym("x", 1)
    found = solved(Written(x, -x[0], ca.log(2 - x[0])), box(1, -1e3, 1e3, [-3.0], [INF]), np.zeros(1))
    assert found.converged
    np.testing.assert_allclose(found.x, [2 - np.exp(-3)], atol=1e-7)


def test_a_warm_start_after_a_small_change_takes_few_steps() -> None:
    program, bounds, start = hock_schittkowski_71()
    cold = solved(program, bounds, start)
    changed = Bounds(bounds.lower, bounds.upper, bounds.g_lower * 1.001, bounds.g_upper * 1.001)
    warm, again = solved(program, changed, cold, mu=1e-8), solved(program, changed, start)
    assert warm.converged
    np.testing.assert_allclose(warm.x, again.x, atol=1e-6)
    assert warm.iterations <= again.iterations // 2


def test_it_ends_when_it_is_told_to_and_after_so_many_steps() -> None:
    program, bounds, start = hock_schittkowski_71()
    assert solved(program, bounds, start, most=2).iterations == 2
    solver = InteriorPoint(program.jacobian_at, program.hessian_at, np.ones(4, bool), np.array([False, True]))
    told = solver.solve(program, bounds, start, 0.1, 1e-9, 200, lambda: True)
    assert (told.converged, told.iterations) == (False, 0)


class Numb(Written):
    """No number anywhere but where it is looked at for the first so many times."""

    looks = 0

    def jacobian(self, x: Array) -> Array:
        self.looks -= 1
        return super().jacobian(x)

    def constraints(self, x: Array) -> Array:
        return super().constraints(x) * (1.0 if self.looks > 0 else np.nan)


def test_an_answer_all_but_sharp_counts_where_no_step_leads_on() -> None:
    written, bounds, start = hock_schittkowski_71()
    best = solved(written, bounds, start)
    said: dict[int, tuple[bool, str]] = {}
    for looks in (best.iterations // 2, best.iterations):
        program = Numb(written.x, written.f, written.g)
        program.looks = looks
        found = solved(program, bounds, start)
        said[looks] = found.converged, found.status
        if found.converged:
            np.testing.assert_allclose(found.x, best.x, atol=1e-5)
    assert [*said.values()] == [(False, "no step is better"), (True, "nearly solved")]


def test_bounds_of_another_structure_are_refused() -> None:
    program, bounds, start = hock_schittkowski_71()
    solver = InteriorPoint(program.jacobian_at, program.hessian_at, np.ones(4, bool), np.array([False, True]))
    with pytest.raises(ValueError, match="fix other variables"):
        solver.solve(program, Bounds(bounds.lower, bounds.lower, bounds.g_lower, bounds.g_upper), start, 0.1, 1e-9, 9)


@pytest.mark.parametrize("seed", range(8))
def test_random_programs_end_as_with_ipopt(seed: int) -> None:
    """Smooth random costs and rows in stages; where IPOPT finds an optimum, so does the interior point, as good."""
    rng = np.random.default_rng(seed)
    n = 12
    x = ca.MX.sym("x", n)
    f = 4 * ca.sumsqr(x - ca.DM(rng.normal(size=n))) + ca.dot(ca.DM(rng.normal(size=n)), ca.sin(x))
    rows = []
    for k in range(n - 2):
        a, b, c = rng.normal(size=3)
        rows.append(a * x[k] * x[k + 1] + b * ca.sin(x[k + 2]) + c * x[k])
    for k in range(0, n - 2, 3):
        rows.append(x[k] + x[k + 1] ** 2 - x[k + 2])
    g = ca.vertcat(*rows)
    equal = len(range(0, n - 2, 3))
    g_lower = [-0.5] * (n - 2) + [0.2] * equal
    g_upper = [0.7] * (n - 2) + [0.2] * equal
    bounds, start = box(n, -2.0, 2.0, g_lower, g_upper), np.zeros(n)
    program = Written(x, f, g)
    options = {"ipopt.print_level": 0, "ipopt.sb": "yes", "print_time": False, "ipopt.tol": 1e-10}
    ipopt = ca.nlpsol("s", "ipopt", {"x": x, "f": f, "g": g}, options)
    theirs = ipopt(x0=start, lbx=-2.0, ubx=2.0, lbg=g_lower, ubg=g_upper)
    assert ipopt.stats()["success"]
    ours = solved(program, bounds, start)
    assert ours.converged
    assert program.cost(ours.x) <= float(theirs["f"]) + 1e-6
    assert (
        np.max(np.maximum(np.array(g_lower) - program.constraints(ours.x), program.constraints(ours.x) - g_upper))
        < 1e-8
    )
