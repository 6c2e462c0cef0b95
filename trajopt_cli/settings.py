"""Every number of the optimiser that somebody chose, as one frozen value that is passed with the plant.

A comment says the unit, why a number has its value, and what was measured. Properties are derived from fields. Rounding
of doubles (1e-9 and less around a comparison), constants that a cited algorithm publishes, bounds on iterations that no
case reaches and numbers that one module alone reads and nobody varies stand where they are used.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Settings:
    """Chosen numbers by topic, in SI units. Tests replace some, with `dataclasses.replace`, on the plant."""

    batch: int = 8192  # rows of a work array at once: some 10 MB. Measured for kinematics: 512 to 8192 take the same
    # time within 15 %.

    # reach: may the program be done at all
    reach_spacing: float = 0.0125  # m between two of them at most. Not measured.
    line_samples: int = 13  # points on a line held against the inverse kinematics. Not measured.
    long_line: float = 0.05  # m, from which a line has all of them. Not measured.
    elbow: float = 0.999  # largest |sin q3|: the last 0.2 mm of reach, where every derivative used grows without bound.
    # Measured: the prototype's event problem needs such a wall (it had |cos| <= 0.9999 of the elbow); this value was
    # not compared.
    wrist: float = 0.001  # least |sin q5| on lines, dwells and waypoints with a free rail. Measured: the prototype saw
    # acceleration seventeen times too high beside the wrist singularity; this value was not compared.

    # search: dynamic programming that picks the basin
    coarse_grid: int = 33  # rail positions on a stroke at least, all branches and turns, rail at rest. Measured: 1 to 2
    # s in the prototype; 13 of its 14 other starts ended in the same optimum.
    coarse_spacing: float = 0.075  # m between two of them at most: as far on 2.4 m. Measured: 33 on 40 m connect
    # nothing.
    most_turns: int = 16  # whole turns of a branch that are all looked at. Measured: ABB's arms have 12 at most, six
    # axes of +-360 degrees 64, whose states on a rail fill half a gigabyte for every joint move; of so many only
    searched_turns: int = 6  # those nearest to joints that are given. Measured on six programs of UR arms on a rail: 4,
    # 8 and 16 find the same routes, in 0.2, 0.3 and 1 s, on one 64 do, in 12 s; 2 miss one by 9 %.
    searched_legs: int = 96  # legs that are searched at once; longer programs in windows. Not measured.
    overlapping_legs: int = 12  # of them that are searched again with what comes behind them. Measured on 200 moves of
    # a pallet: the same routes within 0.0002 % as with 24, in 0.9 of the time.
    fine_grid: int = 25  # rail positions around the best route. Not measured (the prototype had 121 over the whole
    # stroke).
    near_best: float = 1.04  # labels within this of the best cycle stay in the fine search. Not measured; the search
    # alone was 0.6 to 11.4 % (median 3.2 %) above the optimum in the prototype.
    near_span: float = 3.5  # s of a cycle at most of which that share is taken: what is far away does not matter.
    # Measured: with 7 the same routes on 50 programs but for one of 200 moves on a fixed rail, 0.004 % shorter, in 1.2
    # times the time.
    slowest_states: int = 20  # states of two waypoints each of which the slowest axes make a leg's table; others are
    # asked where that matters. Measured on 50 moves of a pallet: 0.70 s of search; those slowest in half of them 0.90
    # s, all axes 1.1 s.

    # path: a run's parts between two stops
    end_spacing: float = 0.7  # how much closer together a leg's nodes are beside its stops. Measured on hinge_line: 20
    # nodes in the search for rail positions gave a plan of 12.452 s evenly spaced, of 12.412 s with a curve of 0.6; 40
    # evenly spaced 12.413 s.
    corner_nodes: int = 4  # intervals of each part of a corner's half. Not measured.

    # pace: how fast a path is driven
    sample_step: float = 0.001  # s between two looks at a motion at most. Not measured.
    least_samples: int = 12  # looks at an interval at least. Measured: on 1,000 points of z1 at v100, 8, 12, 20 and 40
    # gave one and the same motion.
    path_interval_samples: int = 5  # looks at an interval of a path besides both ends; the middle is one. Measured on
    # hinge_cell, corners, bench_irb140, 50 moves of a pallet, 100 points of z1 and a random program: 2, 3, 4, 6 and 12
    # gave the same motions, and 40 looks found no limit passed.
    corner_samples: int = 4  # times as many in a corner, where the tool's speed rises and falls within an interval.
    # Measured on 110 random programs with corners: without, 0.01 and 0.05 % of a cap were missed in two of them.
    along_path_samples: int = 9  # times as many where the tool's acceleration along its path is limited: in a corner it
    # rises and falls within an interval. Measured on an arc, a corner of 20 mm and a line at 0.8 m/s2: without, 0.803
    # m/s2 were missed.
    most_samples: int = 1000  # within one interval. Not measured.

    # initial plan: a legal motion before any nonlinear program
    run_nodes: int = 96  # intervals of a leg in a run with corners, of one shorter than long_line as many fewer.
    # Measured on 300 points of z5 at v1000: 7.1927 s with a quarter of the nodes that 7.1923 s took.
    pair_nodes: int = 20  # intervals of a leg that is timed to compare rail positions. Measured on ten random programs
    # (benchmarks/bench_routes.py): 32 gave RAPID plans 0.02 % faster on average, 0.1 % at most, in 1.1 times the time.
    refine_step: float = 0.03  # m, the first step: the search's grid. Not measured.
    refine_last: float = 0.0002  # m, the last. Measured: 4e-4 gave one of 30 random programs 0.06 % more time.
    polished_legs: int = 3500  # legs of runs with corners that are timed while the rail is shifted at their points.
    # Measured with 2500, 5000 and 8000: 2500 gave bench_peers 3011 0.12 % more time, bench_corners 4016 and 4013 0.19
    # and 0.11 % from one start; 8000 gave 4016 0.03 % less than 5000. This value was not compared.
    carry_length: float = 0.05  # m of short lines over which the rail goes in proportion to the tool's way. Measured on
    # 400 points of z1: 5.642 s in 9.9 s of processor time; a rail position for every point 6.681 s in 42.7 s.
    range_shares: tuple[float, ...] = (1.0, 0.99, 0.97, 0.93)  # shares of the axes' ranges that are tried in turn. Not
    # measured.
    hopeless: float = 1.5  # times its programmed time that a leg takes at least where narrower ranges are not tried any
    # more. Measured: 33 moves with six times of 0.05 s for 0.2 s and more took 114 s of processor to be refused, 32 s
    # with it.
    window_legs: int = 24  # legs of the nonlinear program at most. Measured on 26 legs of a random cell: one solve
    # 9.863 s in 18 s of processor time, windows of 14 legs 9.897 s in 45 s, of 9 legs 9.874 s in 71 s; so one solve as
    # long as it converges.
    window_overlap: int = 12  # legs of the windows over the others' borders, about. Measured on 100 moves of a pallet:
    # 8 gave 34.824 s, 12 34.818 s, as many as the others have 34.820 s.
    few_legs: int = 48  # of a problem of whose windows the best of all starts is taken, on grids that are doubled once
    # more. Measured on nine random programs: the first start that gained was up to 5 % slower than another; on 100
    # moves of a pallet the coarser grids cost 0.13 % of the cycle and save 30 to 40 % of the solver's time. In longer
    # ones the best of two first answers: on 50, 100 and 200 moves of a pallet 0.4, 0 and 0 % less for 20, 8 and 4 %
    # more time.
    sweep_gain: float = 0.01  # share that the windows over a window's borders must have saved before it is solved
    # again. Measured on 200 moves of a pallet: 2e-3 gave 70.6157 s with 28 windows, 5e-3 70.6158 s with 19; with
    # smaller windows over borders 5e-3 and 1e-2 gave the same 70.6846 s with 21 and 17.
    least_gain: float = 1e-06  # s that a nonlinear program must save to be worth another motion. Not measured.

    # transcription: the nonlinear program
    first_grid: int = 6  # intervals of a path on the first grid, doubled from solve to solve. Measured: direct starts
    # on 16 or 20 intervals failed sometimes, nested grids from 6 did not.
    short_program: int = 16  # legs of a program with finer grids. Measured: 17 and 19 legs took 1.4 and 1.5 times the
    # solver's time for 0.07 and 0.04 % of the cycle.
    damping: float = 1e-07  # s per squared scaled acceleration, where many motions take the same time. Measured: 4e-7
    # cost 0.3 ms of hinge_cell, 1e-8, with 1e-7 for dwells, let hinge_line's solves fail.
    damping_jerk: float = 1e-05  # s per second of a leg and squared share of a jerk limit, in each interval. Measured
    # on two joint moves: without it 150 iterations were not always enough; 2e-6, 1e-5 and 3e-5 gave 0.928, 0.928 and
    # 0.929 s.

    # clearances: distances in the nonlinear program
    near: float = 0.1  # m beyond the distance wanted within which a pair of bodies has a row at a node. Measured on two
    # programs among boxes: 0.05 and 0.2 gave the same cycles, 0.2 in 1.3 times the time on one.
    body_pairs: int = 4  # of bodies, the nearest ones, that have rows at a node. Measured on three: 2 gave the same
    # cycle twice and 5.402 s for 5.415 s, in 0.85 of the time; more bodies may be near.
    clearance_margin_nlp: float = 0.0002  # m that the rows keep beyond the distance wanted: what they are off by and
    # the judge looks past. Measured on two: 5e-5 gave 5.412 s for 5.415 s and the same, 1e-3 5.590 s and 0.02 % more.

    # solver
    most_iterations: int = 200  # a start that converges needs 25 to 60. Measured: 500 let some cells converge that fail
    # with 100, while another then tightens its limits without end; with 150 one plan, solved again, stayed on a coarser
    # grid and 0.5 % slower.
    tolerance: float = 1e-08  # tolerance of the last grids. Not measured.
    barrier_first: float = 0.01  # first barrier parameter from the search's estimates. Not measured.
    barrier_refined: float = 1e-05  # from the same motion on a coarser grid or with another structure. Measured on five
    # programs: 1e-4 and 1e-5 end within 0.05 % of each other, 1e-3 fails on one and ends 5 % above on another.
    barrier_rough: float = 0.0001  # from the first grid's answer on the second. Measured on nine programs: 1e-5 took 14
    # % more iterations in all, 1e-3 19 %.
    barrier_warm: float = 1e-08  # from the same program with tightened limits, with its multipliers. Measured on two
    # programs: 13 to 17 iterations, 23 to 25 with 1e-7, 24 to 38 with 1e-5.
    barrier_again: float = 1e-06  # from the same program with another limit, with its multipliers. Measured on
    # hinge_cell, limits of axes 10 % higher: 31 to 53 iterations, from 1e-5 44 to 65, from 1e-8 22 to 90; from its
    # motion alone 34 to 56. And with tightened limits where corners are passed: arcs 13 s of processor, as from 1e-5,
    # from 1e-8 45 s with one part not converged; corners, p1z and a random program the same in the same time.

    # jerk limits
    start_jerk: float = 1.0 - 0.001  # share of a jerk limit that a grid starts with: rows near each other tell jerk to
    # some 1e-4. Not measured.

    # effort: gentle motions
    effort_rounds: int = 2  # of giving time and finding laws. Not measured.

    # exchange: the dense check and the back-off
    start: float = 1.0 - 5e-05  # share of every limit a path's grid starts with: rounding and Hermite rows need a hair
    # of room. Measured: a blanket 1 % costs 0.36 % of cycle time; small values were not compared.
    safe: float = 1.0 - 3e-05  # what a clean motion may use of a limit: Hermite between written rows is not quite the
    # motion. Not measured.
    dense_samples: int = 40  # samples per interval besides both ends. Measured: 20 sufficed in the prototype, where 24
    # of 29 random cells passed a limit between nodes, at 0.006 to 0.03 % of cycle time; 40 was not compared.
    rounds: int = 12  # of checking and tightening. Measured: one cell's excess falls by 6 % a round only, and 40 rounds
    # finish cells that 12 give up.
    beyond: float = 0.0001  # tightened this much further than the excess, so that one round is enough more often. Not
    # measured.
    least_left: float = 0.5  # share that one round leaves of any other limit at least. Measured: where an arm left its
    # reach between two nodes, a thousandth of its acceleration was left and no solve converged.

    # rows of the written file
    row_step: float = 0.001  # s, the grid: what a machine that follows a stream takes. Not measured.
    long_rest: float = 60.0  # s from which a rest has its first and its last row alone: readers of a file expect even
    # rows. Measured: a wait of 59 s is 59,000 rows, 5 MB.
    longest_motion: float = 3600.0  # s on one motion in which something moves. Measured: 38 s of processor, 0.9 GB for
    # that long
    least_row_step: float = 1e-05  # s; no two rows are nearer, or differences of rounded rows say nothing. Not
    # measured.

    # what limits a motion
    at_limit: float = 0.99  # share of a limit that counts as standing at it. Not measured.

    # lower bound
    bound_rail: float = 0.0025  # m, rail interval of the enclosures. Not measured.
    bound_levels: int = 6  # of refinement. Not measured.
    bound_aim: float = 0.95  # of the incumbent: where cells are many, finer levels only try to prove this much. Not
    # measured.
    bound_legs: int = 64  # between places of which all cells are looked at together; longer programs in windows. Not
    # measured.
    bound_window: int = 12  # of them in a window, and a few more up to a stop. Measured on 100 moves of a pallet: 32
    # gave 33.96 s in 4.0 s, 12 gave 33.94 s in 2.2 s, 6 gave 33.58 s in 1.7 s.
    bound_pairs: int = 100000  # of cells per leg in a window; a finer level is not begun beyond. Measured on 100 moves
    # of a pallet with free axes: 300,000 gave 30.81 s for 30.55 s in five times the time.

    # sensitivity: a plan solved again with a change
    small_change: float = 0.1  # share of a change by which first order is told. Not measured.
    active: float = 0.95  # share of a limit from which a run is timed again when it changes. Not measured.

    # collision: clear of obstacles and of itself
    clearance_margin: float = 0.0001  # m that the planner stays farther away than wanted, for what lies between looks,
    # and for rounding. Not measured.

    # via points: points by which joint moves lead around what is in their way
    detour_tries: int = 300  # places near the straight way, and as many anywhere, that a way by one point or two may
    # have. Not measured.
    detour_tree: int = 36  # times that a tree grows before no way counts as found. Not measured.

    # detours: paths that touch something, in the search
    detours_per_motion: int = 5  # times that a way around is looked for in one motion, between different states. Not
    # measured.
    detour_zones: tuple[float | None, ...] = (0.2, 0.1, 0.05, 0.02, 0.01, None)  # m: radii of fly-bys at added points,
    # tried in turn; None for a stop. Not measured.
    least_singular_value: float = 0.02  # least singular value of the arm's Jacobian at an added point: twice what a
    # target is refused at, so that a point that is moved a little stays one. Not measured.

    # orders of stations
    exact_stations: int = 12  # of which the best order is found for certain; of more it is looked for. Measured: 11
    # stations of 150 states take 1.7 s.
    station_states: int = 400  # of a station at most, where its rail positions can be taken farther apart. Not
    # measured.

    @property
    def long_turn(self) -> float:
        """Rad, the same."""
        return 10 * self.long_line

    @property
    def worth(self) -> float:
        """Share of such a span by which other routes may be estimated to take longer to be timed as well, and by which
        they may take longer after a few rounds of refinement. Measured on 19 programs, most of bench_peers.py: of all
        routes up to 3 % longer by estimate the four that won were at 0.1 to 0.5 % of their cycles, 9 to 34 ms;
        benchmarks/bench_routes.py tries other numbers."""
        return (self.near_best - 1) / 4

    @property
    def tie_candidates(self) -> int:
        """States of a tied waypoint that are tried by coordinate descent."""
        return 2 * self.slowest_states

    @property
    def zone_samples(self) -> int:
        """Places on half a joint move where the tool's distance from its end is looked at."""
        return 8 * self.corner_nodes + 1

    @property
    def sphere_samples(self) -> int:
        """Places in a corner of all axes that are held against its zone."""
        return 4 * self.corner_nodes + 1

    @property
    def closed_form_excess(self) -> float:
        """Share by which a closed-form joint move may pass a cap before it goes on a grid."""
        return 100 * self.tolerance

    @property
    def least_zone(self) -> float:
        """Share of a leg that each free zone of its grid lasts at least."""
        return 0.12 / self.free_zones

    @property
    def short_nodes(self) -> int:
        """The same of a line of long_line passed at both ends, one at least on shorter ones."""
        return self.run_nodes // 16

    @property
    def polish_step(self) -> float:
        """M, the first."""
        return 2 * self.refine_step

    @property
    def polish_last(self) -> float:
        """M, the last."""
        return 10 * self.refine_last

    @property
    def carry_last(self) -> float:
        """M, the last step there."""
        return self.polish_last

    @property
    def refine_gain(self) -> float:
        """Share of the time that a step must gain to be tried again."""
        return self.least_gain

    @property
    def first_joint_grid(self) -> int:
        """Intervals there of a joint move that is known to meet a cap."""
        return 2 * self.first_grid

    @property
    def last_grid(self) -> int:
        """Intervals of a path on the last grid of a long program."""
        return 8 * self.first_grid

    @property
    def fine_path_grid(self) -> int:
        """Intervals of a path on its last grid."""
        return 16 * self.first_grid

    @property
    def fine_joint_grid(self) -> int:
        """And of a joint move there."""
        return 8 * self.first_grid

    @property
    def ranking_grid(self) -> int:
        """Intervals of a path on which it is told which of several starts leads farthest."""
        return 4 * self.first_grid

    @property
    def joint_grid(self) -> int:
        """Intervals of a joint move once a tool cap or a range binds."""
        return 4 * self.first_grid

    @property
    def free_zones(self) -> int:
        """Intervals at which run-up, middle and run-out of a path may shift; kept on finer grids, which saves
        iterations."""
        return 2 * self.first_grid

    @property
    def least_start_time(self) -> float:
        """S of such a leg in the first iterate."""
        return 2 * self.row_step

    @property
    def rough_tolerance(self) -> float:
        """Tolerance of the grids before."""
        return 1e4 * self.tolerance

    @property
    def barrier_doubt(self) -> float:
        """Where that fails."""
        return 10 * self.barrier_first

    @property
    def barrier_cold(self) -> float:
        """Where that warm start fails."""
        return self.barrier_first / 10

    @property
    def safe_jerk(self) -> float:
        """What a clean motion may use of it."""
        return (1 + self.start_jerk) / 2

    @property
    def exact(self) -> float:
        """The same for joints that move by polynomials on the grid: exact between nodes."""
        return 1 - self.tolerance

    @property
    def switches_apart(self) -> float:
        """S between an axis' switches that are not one: least_row_step and a little."""
        return 1.1 * self.least_row_step

    @property
    def bound_coarse(self) -> int:
        """Rail intervals per cell at the first level, halved per level down to one."""
        return 1 << (self.bound_levels - 1)


DEFAULT = Settings()
"""What a plant has that is given no other."""
