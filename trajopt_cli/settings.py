"""Every number of the optimiser that somebody chose: its unit, why it has that value, and what was measured of it.

A number is measured where an experiment is known that compared values or showed what goes wrong without it, as told by
a commit or by the notes on the optimiser's prototype; else it says that it was not. Rounding of doubles (1e-9 and less
around a comparison) stays where it is used.
"""

from __future__ import annotations

# ---- reach: may the program be done at all
REACH_GRID = 193  # rail positions on a stroke at least; 12.5 mm on one of 2.4 m. Not measured.
REACH_APART = 0.0125  # m between two of them at most. Not measured.
LINE_NODES = 13  # points on a line held against the inverse kinematics. Not measured.
FEWEST_NODES = 3  # of them on a short line. Not measured.
LONG_LINE = 0.05  # m, from which a line has all of them. Not measured.
LONG_TURN = 0.5  # rad, the same. Not measured.
REACH_CHUNK = 16_384  # poses that the inverse kinematics is asked for at once: 6 MB. Not measured.
ELBOW = 0.999  # largest |sin q3|: the last 0.2 mm of reach, where every derivative used grows without bound. Measured:
# the prototype's event problem needs such a wall (it had |cos| <= 0.9999 of the elbow); this value was not compared.
WRIST = 1e-3  # least |sin q5| on lines, dwells and waypoints with a free rail. Measured: the prototype saw acceleration
# seventeen times too high beside the wrist singularity; this value was not compared.
STRETCHED = 1 - 1e-6  # |sin q3| up to which an arm given by its joints has not met its other branch: 0.08 degrees. Not
# measured.
LEAVING = 1e-7  # rad between joints given at a singularity and those with which a line leaves it. Measured: with 1e-6
# too much the rows of a plan pass acceleration limits at the start.
NEAREST = 16  # halvings of a line's first interval that look for where it has left a singularity. Not measured.

# ---- search: dynamic programming that picks the basin
SEARCH_COARSE = 33  # rail positions on a stroke at least, all branches and turns, rail at rest. Measured: 1 to 2 s in
# the prototype; 13 of its 14 other starts ended in the same optimum.
SEARCH_APART = 0.075  # m between two of them at most: as far on 2.4 m. Measured: 33 on 40 m connect nothing.
MOST_TURNS = 16  # whole turns of a branch that are all looked at. Measured: ABB's arms have 12 at most, six axes of
# +-360 degrees 64, whose states on a rail fill half a gigabyte for every joint move; of so many only
SEARCH_TURNS = 6  # those nearest to joints that are given. Measured on six programs of UR arms on a rail: 4, 8 and 16
# find the same chains, in 0.2, 0.3 and 1 s, on one 64 do, in 12 s; 2 miss one by 9 %.
SEARCH_LEGS = 96  # legs that are searched at once; longer programs in windows. Not measured.
SEARCH_AHEAD = 12  # of them that are searched again with what comes behind them. Measured on 200 moves of a pallet: the
# same chains within 0.0002 % as with 24, in 0.9 of the time.
SEARCH_FINE = 25  # rail positions around the best chain. Not measured (the prototype had 121 over the whole stroke).
SEARCH_WINDOW = 0.1  # m beside the best chain at least that the fine search looks at. Not measured.
PASSING = (-0.5, 0.0, 0.5)  # shares of the rail's top velocity tried at a waypoint. Not measured (the prototype had 5).
NEAR_BEST = 1.04  # labels within this of the best cycle stay in the fine search. Not measured; the search alone was
# 0.6 to 11.4 % (median 3.2 %) above the optimum in the prototype.
NEAR_SPAN = 3.5  # s of a cycle at most of which that share is taken: what is far away does not matter. Measured: with 7
# the same chains on 50 programs but for one of 200 moves on a fixed rail, 0.004 % shorter, in 1.2 times the time.
WIDEST = 1.0  # m from an arm's axis to its flange at most; farther ones only miss that a slow joint move is long. Not
# measured.
LOOKED_AT = 20  # states of two waypoints each of which the slowest axes make a leg's table; others are asked where that
# matters. Measured on 50 moves of a pallet: 0.70 s of search; those slowest in half of them 0.90 s, all axes 1.1 s.
WAY_NODES = 6  # places on a joint move whose distances add up to the tool's way. Not measured.
SHIFT = 0.45  # m that the rail may move on a line beyond what it can at top velocity in the tool's time. Not measured.
CURVED = 0.6  # share of a line's top velocity at which its curvature is charged against acceleration. Not measured.
LEAST_ROOM = 0.15  # share of each acceleration limit that is always left for that. Not measured.
SAME_STATE = 1e-6  # rad or m between two tables' joints for one and the same state of tied waypoints. Not measured.
WIDER = (
    1.05,
    1.25,
    2.0,
    float("inf"),
)  # times the untied cost beyond which states of tied waypoints are left out, tried in
# turn. Not measured.
CANDIDATES = 40  # states of a tied waypoint that are tried by coordinate descent. Not measured.
LINE_CHUNK = 100_000  # joints of a line at once: 0.8 MB. Not measured.
SEARCH_CHUNK = 25_000  # numbers per work array: 0.2 MB, which the heap keeps. Measured on 10 stations with free axes:
# 0.51 s for 0.70 s with whole tables.

# ---- course: a run's parts between two stops
END_CURVE = 0.7  # how much closer together a leg's nodes are beside its stops. Measured on hinge_line: 20 nodes in the
# search for rail positions gave a plan of 12.452 s evenly spaced, of 12.412 s with a curve of 0.6; 40 evenly spaced
# 12.413 s.
CORNER_PART = 4  # intervals of each part of a corner's half. Not measured.
ZONE_SAMPLES = 33  # places on half a joint move where the tool's distance from its end is looked at. Not measured.
SPHERE_SAMPLES = 17  # places in a corner of all axes that are held against its zone. Not measured.
SPHERE = 1 + 1e-6  # times the zone's radius that they may be away. Not measured.
SHRINK = 0.8  # a corner of all axes that leaves its zone is made smaller by this. Not measured.
SHRINKS = 12  # times at most. Not measured.

# ---- pace: how fast a course is driven
TOOL_DIRECTIONS = 8  # of the tool's acceleration on a half circle; the polygon passes the limit by 2 % at its corners,
# which the dense check takes back where it is used. Measured: with directions along the way and across it among them
# bench_irb140 took 9.528 s for 9.472 s, as both ends of an interval then hold the whole limit; 16 gave 9.472 s, too.
STEEP = 1.25  # times by which the greatest rate may differ between two nodes before they are put closer. Not measured.
LED = 0.02  # rad, m by which axes may be elsewhere at the next node than their slopes lead. Not measured.
LOST = 0.2  # rad, m by which they may be with the nodes as close as they get. Not measured.
RESOLVED = 8  # halvings at most. Not measured.
LOOK = 1e-3  # s between two looks at a motion at most. Not measured.
NEAR_LOOK = 2e-4  # s between two looks in a short interval, which has fewer than DENSE then. Not measured.
BRIEF = 12  # looks at an interval at least. Measured: on 1,000 points of z1 at v100, 8, 12, 20 and 40 gave one and the
# same motion.
NODES_AT_ONCE = 20_000  # of the courses driven at once: 50 MB. Not measured.
COURSE_LOOKS = 5  # looks at an interval of a course besides both ends; the middle is one. Measured on hinge_cell,
# corners, bench_irb140, 50 moves of a pallet, 100 points of z1 and a random program: 2, 3, 4, 6 and 12 gave the same
# motions, and 40 looks found no limit passed.
CHECKED = 50_000  # looks of the legs checked at once: 50 MB. Not measured.
SAMPLED = 2048  # places whose kinematics are asked for at once. Measured: 512 to 8192 take the same time within 15 %.
ROWS_AT_ONCE = 8192  # rows of a trajectory held against the limits at once: 10 MB. Not measured.
ALONG_LOOKS = 9  # times as many where the tool's acceleration along its path is limited: in a corner it rises and falls
# within an interval. Measured on an arc, a corner of 20 mm and a line at 0.8 m/s2: without, 0.803 m/s2 were missed.
CORNER_LOOKS = 4  # times as many in a corner, where the tool's speed rises and falls within an interval. Measured
# on 110 random programs with corners: without, 0.01 and 0.05 % of a cap were missed in two of them.
MOST_LOOKS = 1000  # within one interval. Not measured.
LEAST_FELT = 0.5  # of a share is left at least in one round. Not measured; shares tightened from what they allow, not
# from what is used, left a line of 3 mm at v100 under 20 m/s2 alone without a law after 25 rounds, else 3 suffice.
HALVINGS = 50  # of a rate at which a leg lasts long enough. Not measured.
MOST_LEFT = 0.9  # of what is left to wait is waited for in a round. Measured on four legs in corners that wait for 1 s
# each: all at once 1.006 s, so 1.000 s.
NEARLY = 1e-3  # of a leg's time is left to wait: all of it is waited for then. Not measured.
WAITED = 1 + 1e-5  # of a least time, at which a leg between corners aims. Not measured.
PACE_ROUNDS = 25  # of checking and tightening. Not measured.

# ---- incumbent: a legal motion before any nonlinear program
RUN_NODES = 96  # intervals of a leg in a run with corners, of one shorter than LONG_LINE as many fewer. Measured on 300
# points of z5 at v1000: 7.1927 s with a quarter of the nodes that 7.1923 s took.
ALONE_NODES = (
    288  # intervals of a leg between two stops. Measured on 50 random programs of stops: with 96 a plain peer on
)
# 400 points was faster on 14 of them, by 0.02 % at most.
PAIR_NODES = 20  # intervals of a leg that is timed to compare rail positions. Measured with END_CURVE.
SHORT_NODES = 6  # the same of a line of LONG_LINE passed at both ends, one at least on shorter ones. Not measured.
FLIPPED = 1.0  # rad, m by which axes in the middle of such a line may be elsewhere than at its ends. Not measured.
PAIRS_AT_ONCE = 1500  # pairs of rail positions timed at once: 60 MB. Not measured.
RUSH = 4.0  # times the rail's way at top speed in a short line's time that its ends may be apart. Not measured.
REFINE_OFFSETS = (-2.0, -1.0, 0.0, 1.0, 2.0)  # steps beside a rail position that are tried. Not measured.
REFINE_APART = (
    1  # step by which both ends of a leg are shifted otherwise at most, two where two to either side are tried.
)
# Measured on ten programs: 0.002 % faster on average than with all pairs, the slowest 0.0006 % slower.
REFINE_NARROW = 5e-3  # m, steps below which only the nearest of them are. Measured on 100 moves of a pallet: always all
# of them gave 36.896 s in 2.3 s, never the farther ones 36.902 s in 1.45 s.
REFINE_STEP = 0.03  # m, the first step: the search's grid. Not measured.
REFINE_LAST = 2e-4  # m, the last. Measured: 4e-4 gave one of 30 random programs 0.06 % more time.
POLISH = (
    2500  # legs of runs with corners that are timed in all while the rail is shifted at their points. Not measured.
)
POLISH_STEP = 0.06  # m, the first. Not measured.
POLISH_LAST = 2e-3  # m, the last. Not measured.
LEAST_POLISH = 1e-5  # s that a shift must save. Not measured.
CARRY = 0.05  # m of short lines over which the rail goes in proportion to the tool's way. Measured on 400 points of z1:
# 5.642 s in 9.9 s of processor time; a rail position for every point 6.681 s in 42.7 s.
CALM = 1e-3  # s per metre of it and squared slope of the rail that is charged there. Not measured.
CARRY_LOOKS = 6  # of the lines between two such positions that are timed at most. Not measured.
CARRY_LAST = 2e-3  # m, the last step there. Not measured.
REFINE_GAIN = 1e-6  # share of the time that a step must gain to be tried again. Measured: on 1,000 points of z1 along a
# rail chains of one time drifted to and fro for 30 rounds.
SLACK = 1 + 1e-4  # times its least time that a wait must have, for limits are not used to the last hair. Not measured.
LATE = 1e3  # times what a leg would pass its programmed time by, added to the chain's. Not measured.
REFINE_ROUNDS = 40  # at most. Not measured.

MOST_MARKS = (
    6  # stops and fly-bys beside joint moves that a part of a run may span where stopping is tried. Not measured.
)
ROOMS = (1.0, 0.99, 0.97, 0.93)  # shares of the axes' ranges that are tried in turn. Not measured.
HOPELESS = (
    1.5  # times its programmed time that a leg takes at least where narrower ranges are not tried any more. Measured:
)
# 33 moves with six times of 0.05 s for 0.2 s and more took 114 s of processor to be refused, 32 s with it.
WORTH_TRYING = 1.005  # times what it takes at least that a joint move must take before axes of their own are tried. Not
# measured.
WINDOW = 24  # legs of the nonlinear program at most. Measured on 26 legs of a random cell: one solve 9.863 s in 18 s of
# processor time, windows of 14 legs 9.897 s in 45 s, of 9 legs 9.874 s in 71 s; so one solve as long as it converges.
OVERLAP = 12  # legs of the windows over the others' borders, about. Measured on 100 moves of a pallet: 8 gave 34.824 s,
# 12 34.818 s, as many as the others have 34.820 s.
FEW_LEGS = 48  # of a problem of whose windows the best of all starts is taken, on grids that are doubled once more.
# Measured on nine random programs: the first start that gained was up to 5 % slower than another; on 100 moves of a
# pallet the coarser grids cost 0.13 % of the cycle and save 30 to 40 % of the solver's time. In longer ones the best
# of two first answers: on 50, 100 and 200 moves of a pallet 0.4, 0 and 0 % less for 20, 8 and 4 % more time.
SWEEPS = 6  # of windows over one another's borders at most. Not measured.
SWEEP_GAIN = (
    1e-2  # share that the windows over a window's borders must have saved before it is solved again. Measured on 200
)
# moves of a pallet: 2e-3 gave 70.6157 s with 28 windows, 5e-3 70.6158 s with 19; with smaller windows over borders 5e-3
# and 1e-2 gave the same 70.6846 s with 21 and 17.
LEAST_GAIN = 1e-6  # s that a nonlinear program must save to be worth another motion. Not measured.

# ---- transcription: the nonlinear program
FIRST = 6  # intervals of a path on the first grid, doubled from solve to solve. Measured: direct starts on 16 or 20
# intervals failed sometimes, nested grids from 6 did not.
FIRST_JOINT = 12  # intervals there of a joint move that is known to meet a cap. Measured on nine programs: put on a
# grid after the first solve, four were up to 0.03 % slower and one 0.02 % faster, in a fifth more time.
LAST = (
    48  # intervals of a path on the last grid of a long program. Measured on hinge_cell with twice as many intervals of
)
# joint moves: 48 give 6.5009 s, 96 6.5000 s.
SHORT = 16  # legs of a program with finer grids. Measured: 17 and 19 legs took 1.4 and 1.5 times the solver's time for
# 0.07 and 0.04 % of the cycle.
FINE = 96  # intervals of a path on its last grid. Measured as LAST.
FINE_JOINT = 48  # and of a joint move there. Measured as LAST: 24 give 6.5005 s.
TOLD = 24  # intervals of a path on which it is told which of several starts leads farthest. Not measured.
GRID_JOINT = 24  # intervals of a joint move once a tool cap or a range binds. Not measured.
FREE_ZONES = 12  # intervals at which run-up, middle and run-out of a path may shift; kept on finer grids, which saves
# iterations. Not measured.
LEAST_ZONE = 0.01  # share of a leg that each of them lasts at least. Not measured.
MOST_ZONES = 0.6  # and at most. Measured: with 0.9 a line's wrist turned over within one interval of 12.
RATE_LOOKS = 401  # at a motion for which a grid is made, besides its breaks. Not measured.
RAMPS = 0.45  # share of a path's changes that its first zone and its last have each. Not measured.
LEAST_RATE = 1e-9  # of a share's rate by scaled time. Not measured.
LEAST_TIME = 1e-3  # s of a leg without a way, so that scaled time stays defined. Not measured.
GLIDE = 0.01  # s; in a shorter wait the rail goes on as it comes. Measured: one of 1e-6 s had rows off by 1e10.
LEAST_DRAFT = 2e-3  # s of such a leg in the first draft. Not measured.
DAMPING = 1e-7  # s per squared scaled acceleration, where many motions take the same time. Measured: 4e-7 cost 0.3 ms
# of hinge_cell, 1e-8, with 1e-7 for dwells, let hinge_line's solves fail.
DAMPED_AS_MUCH = 1.25  # s of a joint move on a grid up to which it has DAMPING; a slower one has more in proportion.
# Measured on joint moves of 48 and 112 s: without no answer in 150 iterations, with it one in 26 to
# 125 that is 0.05 to 0.1 % slower.
DAMPING_DWELL = 4e-6  # the same while the tool rests. Measured: with less a long dwell's rail chatters between the
# nodes; with it and PUSHED, hinge_line's stream plan came to 11.819 s in 33 s, from 12.437 s in 220 s (54fd039).
SHARPEST = 1e6  # of the bound of a share's second derivative, where the tool's caps ask for more than SHARE_CURVE. Not
# measured.
SHARE_RATE = 50.0  # bound of a share's or rail's first derivative by scaled time. Not measured.
SHARE_CURVE = 500.0  # of the second. Not measured.
DAMPING_JERK = 1e-5  # s per second of a leg and squared share of a jerk limit, in each interval. Measured on two joint
# moves: without it 150 iterations were not always enough; 2e-6, 1e-5 and 3e-5 gave 0.928, 0.928 and 0.929 s.
TYPICAL_JERK = 100.0  # of a share by scaled time, for that. Not measured.
SHARE_JERK = 5e4  # of the third, where jerk is limited. Not measured.
JOINT_JERK = 1e5  # the same of a joint. Not measured.
JOINT_RATE = 100.0  # bound of a joint's first derivative on a grid. Not measured.
JOINT_CURVE = 1000.0  # of the second. Not measured.

# ---- clearances: distances in the nonlinear program
NEAR = 0.1  # m beyond the distance wanted within which a pair of bodies has a row at a node. Measured on two programs
# among boxes: 0.05 and 0.2 gave the same cycles, 0.2 in 1.3 times the time on one.
FAR = 0.3  # m instead, on a leg whose first answer went deep into something. Not measured.
SHALLOW = 0.03  # m that an answer may be inside a body and still find the way out. Measured on eight windows beside a
# box, with first answers 44 to 125 mm deep: without it two had no clean answer; five with answers 5 to 24 mm deep ended
# the same with 0.01, in 1.2 to 1.6 times the time.
ARRIVES = 1e-6  # rad or m by which a profile may miss its end: rounding. Not measured.
PAIRS = 4  # of bodies, the nearest ones, that have rows at a node. Measured on three: 2 gave the same cycle twice and
# 5.402 s for 5.415 s, in 0.85 of the time; more bodies may be near.
HAIR = 2e-4  # m that the rows keep beyond the distance wanted: what they are off by and the judge looks past. Measured
# on two: 5e-5 gave 5.412 s for 5.415 s and the same, 1e-3 5.590 s and 0.02 % more.
CLEAR_LOOKS = 3  # at the distances within an interval at least. Not measured.
CLEAR_MOST = 1000  # of them within an interval: a wait may last for a day. Not measured.
CLEAR_LOOK = 0.01  # s between two of them at most. Not measured.
MORE_ROOM = 1.2  # times what bodies come nearer between two nodes that the nodes keep from then on. Not measured.

# ---- solver
MOST_ITERATIONS = 200  # a start that converges needs 25 to 60. Measured: 500 let some cells converge that fail with
# 100, while another then tightens its limits without end; with 150 one plan, solved again, stayed on a coarser
# grid and 0.5 % slower.
SHARP = 1e-8  # tolerance of the last grids. Not measured.
ROUGH = 1e-4  # tolerance of the grids before. Not measured.
BARRIER_FIRST = 1e-2  # first barrier parameter from the search's estimates. Not measured.
BARRIER_DOUBT = 1e-1  # where that fails. Not measured.
BARRIER_REFINED = (
    1e-5  # from the same motion on a coarser grid or with another structure. Measured on five programs: 1e-4
)
# and 1e-5 end within 0.05 % of each other, 1e-3 fails on one and ends 5 % above on another.
BARRIER_ROUGH = 1e-4  # from the first grid's answer on the second. Measured on nine programs: 1e-5 took 14 % more
# iterations in all, 1e-3 19 %.
BARRIER_WARM = 1e-8  # from the same program with tightened limits, with its multipliers. Measured on two programs:
# 13 to 17 iterations, 23 to 25 with 1e-7, 24 to 38 with 1e-5.
BARRIER_AGAIN = (
    1e-6  # from the same program with another limit, with its multipliers. Measured on hinge_cell, limits of
)
# axes 10 % higher: 31 to 53 iterations, from 1e-5 44 to 65, from 1e-8 22 to 90; from its motion alone 34 to 56.
BARRIER_COLD = 1e-3  # where that warm start fails. Not measured.
WARM_PUSH = 1e-7  # how far a warm start is pushed off its bounds. Not measured.
SLOWED = 1.002  # times as long as it must be a motion is made for another grid to begin with. Not measured.
MOST_SLOWED = 3.0  # times; what passes limits by more is no motion to begin with. Not measured.
FIRST_PUSH = 1e-2  # the same of a start without multipliers. Not measured.
BARRIER_ERROR = 10.0  # times the barrier parameter that may be off before it falls. Measured: 30 takes up to 3 of 26
# iterations less on one program and fails on another.
BARRIER_FACTOR = 0.2  # times that it falls at least. Not measured.
BARRIER_POWER = 1.2  # or to this power of itself, whichever falls less. Measured: on fine grids 1.5 took
# 95 iterations where 1.2 takes 52.
LEAST_TAU = 0.99  # share of the way to a bound that a step may go. Not measured.
FEASIBLE = 1e-10  # by which a row may be off in the end. Not measured.
FEASIBLE_ROUGH = 1e-7  # the same on a grid that is refined afterwards. Not measured.
ALMOST = 1e-6  # error of a point that is the answer where the steps behind it fail. Not measured.
ALMOST_FEASIBLE = 1e-8  # by which a row may be off there. Not measured.
MENDINGS = 20  # steps in a row that only mend rows, at most. Not measured.
MENDED = 0.3  # share of what rows were off that may be left of it then. Not measured.
BACKTRACKS = 30  # halvings of a step. Not measured.
FIRST_SHIFT = 1e-4  # first multiple of the identity where the program is not convex. Not measured.
MOST_SHIFT = 1e40  # largest. Not measured.
EQUATION_EPS = 1e-9  # regularisation of equations that depend on each other. Not measured.
REFINEMENTS = 1  # of each solution of a linear system. Measured on 25 moves of a pallet: 2 take 449 iterations, 1 447.

# ---- jerk limits
START_JERK = 1.0 - 1e-3  # share of a jerk limit that a grid starts with: rows near each other tell jerk to some 1e-4.
# Not measured.
SAFE_JERK = 1.0 - 5e-4  # what a clean motion may use of it. Not measured.
SMOOTH_NODES = 48  # intervals of a course whose derivatives say where a profile is begun. Not measured.
SMOOTH_STEP = 0.6  # by which its constants are scaled at first, one after the other. Not measured.
SMOOTH_LAST = 0.9  # and at last. Not measured.
JERK_ROOM = 1.1  # times what a straight way takes at least that a wait must have. Not measured.

# ---- effort: gentle motions
GAUSS = 4  # places of the quadrature of an effort between two breaks; exact for polynomials of the seventh degree. Not
# measured.
EASE_NODES = 96  # intervals of a leg on which the law of least effort is looked for. Not measured.
EASE_ROUNDS = 2  # of giving time and finding laws. Not measured.

# ---- exchange: the dense check and the back-off
START = 1.0 - 5e-5  # share of every limit a path's grid starts with: rounding and Hermite rows need a hair of room.
# Measured: a blanket 1 % costs 0.36 % of cycle time; small values were not compared.
EXACT = 1.0 - 1e-8  # the same for joints that move by polynomials on the grid: exact between nodes. Not measured.
SAFE = 1.0 - 3e-5  # what a clean motion may use of a limit: Hermite between written rows is not quite the motion.
# Not measured.
DENSE = 40  # samples per interval besides both ends. Measured: 20 sufficed in the prototype, where 24 of 29 random
# cells passed a limit between nodes, at 0.006 to 0.03 % of cycle time; 40 was not compared.
ROUNDS = 12  # of checking and tightening. Measured: one cell's excess falls by 6 % a round only, and 40
# rounds finish cells that 12 give up.
BEYOND = 1e-4  # tightened this much further than the excess, so that one round is enough more often. Not measured.
UNREACHED = 2.0  # ratio of a sample that no joints reach: the rail left the arm's reach between nodes. Not measured.
AMPLE = 1.5  # times the excess taken off a dwell's push. Measured: hinge_cell's stream plan needs four solves instead
# of five (6f06e06).
PUSHED = 1e-3  # share of its acceleration from which the rail drives the arm. Measured as DAMPING_DWELL.
LEAST_PUSH = 0.1  # share that one round leaves of a push at least. Not measured.
RANGE_ROUNDING = (
    1e-9  # of half an axis' range by which it may be passed: rounding. Measured: by 2e-16 a stop at the end of a
)
# range was no answer in any round.
LEAST_LEFT = 0.5  # share that one round leaves of any other limit at least. Measured: where an arm left its reach
# between two nodes, a thousandth of its acceleration was left and no solve converged.
OVER = 1e-6  # share by which a closed-form joint move may pass a cap before it goes on a grid. Not measured.

# ---- rows of the written file
HARDLY = 1 + 5e-5  # times as long as found, where rows pass a limit: first. Measured: 1.3e-6 beside a singularity.
SLOWER = (
    1.0,
    1.001,
    1.01,
    1.1,
    1.5,
    3.0,
)  # times as long as the first legal motion, where rows of a faster one are not
# legal. Not measured.
ROW_EVERY = 1e-3  # s, the grid: what a machine that follows a stream takes. Not measured.
LONG_MOTION = 60.0  # s; a motion that takes longer has rows as many times farther apart. Not measured.
ROWS_WIDEST = 20  # ROW_EVERY: the judge wants rows every 20 ms. Not measured: given by that.
LONGEST_MOTION = 3600.0  # s on one motion in which something moves. Measured: 38 s of processor, 0.9 GB for that long
ROW_APART = 1e-5  # s; no two rows are nearer, or differences of rounded rows say nothing. Not measured.
SAME_TIME = 1e-9  # s; boundaries nearer than this are one row. Not measured.
SWITCHES_APART = 1.1e-5  # s between an axis' switches that are not one: ROW_APART and a little. Not measured.
SAME_SWITCH = 1e-10  # s; switches nearer than this are one. Not measured.
LONGER = 4e-6  # s that a joint move is lengthened per attempt to keep its switches apart. Not measured.
ATTEMPTS = 245  # of them: less than a millisecond in all. Not measured.
GENTLER = (1.0, 0.9998, 0.9995, 0.999, 0.998, 0.995, 0.99, 0.97, 0.9, 0.8, 0.65, 0.5, 0.3, 0.1, 0.03, 0.01, 1e-3, 1e-4)
# shares of its top acceleration that an axis with time to spare tries in turn. Not measured.
RESIDUAL = 1e-14  # rad or m: rounding of a position in a row. Not measured.
DENSER = 6  # times that rows are put between rows where the cubic passes a limit. Not measured.

# ---- what limits a motion
AT_LIMIT = 0.99  # share of a limit that counts as standing at it. Not measured.
BINDING_SAMPLES = 400  # per motion of 0.4 s and more, one per LOOK of shorter ones. Not measured.
FEWEST_SAMPLES = 40  # of a motion at least. Not measured.
STILL_TOOL = 1e-9  # m/s: of a tool as slow nothing is along its path. Not measured.
STILL_NODE = 1e-3  # m/s of a tool at a node of a joint move, as above but smoothly. Not measured.
STILL = 1e-9  # rad or m: no way to go. Not measured.

# ---- lower bound
BOUND_RAIL = 2.5e-3  # m, rail interval of the enclosures. Not measured.
BOUND_LEVELS = 6  # of refinement. Not measured.
BOUND_COARSE = 32  # rail intervals per cell at the first level, halved per level down to one. Not measured.
BOUND_SPEEDS = 4  # velocity ranges from -V to V at the first level, doubled per level. Not measured.
BOUND_AIM = 0.95  # of the incumbent: where cells are many, finer levels only try to prove this much. Not measured.
BOUND_HOPS = 64  # between places of which all cells are looked at together; longer programs in windows. Not measured.
BOUND_WINDOW = (
    12  # of them in a window, and a few more up to a stop. Measured on 100 moves of a pallet: 32 gave 33.96 s
)
# in 4.0 s, 12 gave 33.94 s in 2.2 s, 6 gave 33.58 s in 1.7 s.
BOUND_LIKELY = 8  # cells behind each that are looked at first where only the least time is asked for. Not measured.
MOST_PAIRS = 1_500_000  # of cells per leg; a finer level is not begun beyond. Not measured.
WINDOW_PAIRS = 100_000  # of cells per leg in a window; a finer level is not begun beyond. Measured on 100 moves of a
# pallet with free axes: 300,000 gave 30.81 s for 30.55 s in five times the time.
FEW_PAIRS = 300_000  # of cells per leg; below, the next level aims at the incumbent itself. Not measured.
BOUND_CHUNK = 50_000  # pairs at once: 0.4 MB an array. Measured on hinge_cell: 400,000 take twice as long.
BOUND_ORDER = (0, 2, 1)  # of the first three joints, after the rail: settles most pairs soonest. Not measured.

# ---- again: a plan solved again with a change
SMALL = 0.1  # share of a change by which first order is told. Not measured.
LATER = 1e-3  # share by which a plan solved again may take longer before it begins on its own fine grid. Measured on
# one small cell with eight rails: 2e-4 as a rule, 5e-3 in another optimum.
JUMPED = 0.3  # share by which first order may be off before it is told from half of that. Not measured.
FELT = 0.95  # share of a limit from which a run is timed again when it changes. Not measured.
AT_END = 0.998  # share of the rail's half stroke from which it stands at an end. Not measured.
PROJECTIONS = 6  # steps towards the share of a way that a tool has reached. Not measured.
SHIFTS = (
    0.0,
    2e-3,
    -2e-3,
    5e-3,
    -5e-3,
    0.01,
    -0.01,
    0.02,
    -0.02,
    0.05,
    -0.05,
)  # m of rail that are tried in turn where a
# place was moved out of the arm's reach. Not measured.

# ---- surroundings: clear of obstacles and of itself
CLEAR_MARGIN = 1e-4  # m that the planner stays farther away than wanted: CLEAR_STEP and rounding. Not measured.
CLEAR_STEP = 1e-4  # m: what moves no farther to either side of a place is looked at there alone. Not measured.
CLEAR_AT_ONCE = 4096  # places that are looked at at once: 6 MB. Not measured.
CLEAR_EVERY = 5e-3  # s between two places of a motion that is looked at: at 40 rad/s2 and 0.5 m it leaves the straight
# way between them by 0.06 mm. Not measured.

# ---- ways: points by which joint moves lead around what is in their way
WAY_TRIES = 300  # places near the straight way, and as many anywhere, that a way by one point or two may have. Not
# measured.
WAY_LOOKS = 48  # straight ways that are looked at together. Not measured.
WAY_TREE = 36  # times that a tree grows before no way counts as found. Not measured.
WAY_POCKET = 12  # of them after which a tree with fewer places than that is in a pocket. Not measured.
WAY_STEP = 0.25  # s at top speed: the short ones of a tree's branches. Not measured.
WAY_PULLS = 12  # times that each point of a way is moved to where it is quicker. Not measured.
WAY_TURN = 0.3  # rad, m by which a point is moved at first. Not measured.

# ---- avoid: ways that touch something, in the search
AVOID_LOOKS = 64  # pairs of states of a leg that are looked at together, the best ones first. Not measured.
AVOID_ROUNDS = 60  # times that the best chain is looked at and, where it is not clear, searched again. Not measured.
AVOID_WORSE = 1.3  # times the best chain's cost beyond which pairs are not looked at beforehand. Not measured.
AVOID_PLANS = 5  # times that a way around is looked for in one motion, between different states. Not measured.
AVOID_FAILS = 5  # of them in a whole program that may find none. Not measured.
AVOID_WAYS = 8  # ways found that are tried between other states. Not measured.
AVOID_APART = 0.05  # s that a straight way that is not clear costs until a way around is known. Not measured.
TUNE_STEPS = (0.8, 0.5, 0.5, 0.3, 0.3, 0.15, 0.15)  # rad, m by which added points are moved, in turn. Not measured.
TUNE_TRIES = 16  # places each is tried at. Not measured.
TUNE_FIRST = 80  # the same in the first turn. Not measured.
AVOID_ALIKE = 0.5  # s more between states of the same branches as some between which none was found. Not measured.
ZONES = (
    0.2,
    0.1,
    0.05,
    0.02,
    0.01,
    None,
)  # m: radii of fly-bys at added points, tried in turn; None for a stop. Not measured.
LEAST_STRETCH = 0.02  # least singular value of the arm's Jacobian at an added point: twice what a target is refused at,
# so that a point that is moved a little stays one. Not measured.

# ---- orders of stations
EXACT_STATIONS = 12  # of which the best order is found for certain; of more it is looked for. Measured: 11 stations of
# 150 states take 1.7 s.
STATION_STATES = 400  # of a station at most, where its rail positions can be taken farther apart. Not measured.
