"""What planning asks of a robot: a new kind of arm is one class that answers it, a robot of a known kind two files."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.limits import JointLimits
from trajopt_cli.motion import ConfData
from trajopt_cli.robot.differential import Differential
from trajopt_cli.robot.enclosure import Enclosure
from trajopt_cli.robot.layout import AxisLayout

if TYPE_CHECKING:
    from trajopt_cli.robot.symbolic import Expressions


class Robot(Protocol):
    """An arm of m joints, on a rail or not: n axes in all. Frames: W world, B the arm's base, F flange, T tool centre
    point. A branch is a number 0..b-1; rail positions do not matter without a rail."""

    # ---- axes
    @property
    def name(self) -> str:
        """Its name in robots/."""

    @property
    def axis_names(self) -> tuple[str, ...]:
        """Names (n,), as in files and messages."""

    @property
    def layout(self) -> AxisLayout:
        """Which of them are the rail's and the arm's."""

    @property
    def linkage(self) -> float:
        """Not 0 for a parallel linkage, which does not fold the upper arm past the lower one."""

    @property
    def closed_form(self) -> bool:
        """Whether its branches have closed forms; without, no nonlinear program improves plans."""

    @property
    def turns(self) -> Array:
        """Whole turns (t, m) [rad] of the joints with which a configuration is tried, none first."""

    @property
    def middles(self) -> Array:
        """Joints (m,) [rad]: branches come within half a turn of them."""

    # ---- where things are
    @property
    def X_WB0(self) -> Array:
        """The arm's base (4, 4) with the rail at 0."""

    @property
    def rail_axis_W(self) -> Array | None:
        """Unit direction (3,) of rail travel in the world, None without a rail."""

    def forward(self, q: Array) -> Array:
        """Flange poses X_WF (..., 4, 4) of axes (..., n)."""

    def jacobian(self, q: Array, X_FT: Array | None = None) -> Array:
        """Geometric Jacobian (..., 6, n) at the tool centre point in world axes, linear rows first."""

    def differential(self, q: Array, X_FT: Array | None = None) -> Differential:
        """That and how the tool centre point's velocity and acceleration follow from those of the axes."""

    def rail_within(self, X_WF: Array) -> Array:
        """Rail positions (k, 2) outside which the arm is too short for flange poses (k, 4, 4), whatever its joints;
        both abreast of a pose that is out of reach everywhere."""

    # ---- joints of a pose
    def branches(self, X_WF: Array, rail: Array | None) -> Array:
        """Joints (k, b, m) of all branches for flange poses (k, 4, 4) at rail positions (k,); NaN where there is none.
        Joint limits are not applied."""

    def branch(self, X_WF: Array, rail: Array | None, cfx: IndexArray | int) -> Array:
        """Those (k, m) of one branch each, with the numbers cfx (k,), or of the same one."""

    def walls(self, arm: Array) -> tuple[Array, Array]:
        """How near joints (..., m) are to where branches meet: (...) of the reach, 1 when the arm is stretched or
        folded; (...) of the wrist, 0 when it is singular."""

    def solutions(self, X_WF: Array, rail: float | None, limits: JointLimits) -> list[tuple[int, Array]]:
        """Every (branch, joints (m,)) within limits for one pose (4, 4), turns included."""

    def why_unreachable(self, X_WF: Array, rail: float | None, limits: JointLimits) -> str:
        """Why there are none, in one clause. Raises ValueError where there are some."""

    def enclose(self, X_WF: Array, rail: Array, limits: JointLimits, twist: Array | None = None) -> Enclosure:
        """The first three joints and their rates over the intervals between rail positions (k + 1,); twist (6,): of the
        flange on its way through the pose, world axes."""

    # ---- configurations as RAPID names them
    def confdata_rows(self, arm: Array) -> Array:
        """RAPID confdata of joints (n, 6) as numbers (n, 4); (n, 0) for a robot without a rule for it."""

    def confdata(self, arm: Array) -> ConfData:
        """Of joints (m,)."""

    def branch_of(self, arm: Array) -> int:
        """The number of the branch that joints (m,) are on."""

    def admits(self, conf: ConfData, arm: Array) -> BoolArray:
        """Whether a target with this confdata may be reached with joints (..., m)."""

    # ---- the same as CasADi expressions
    @property
    def expressions(self) -> Expressions:
        """Forward kinematics, and the inverse on one branch."""
