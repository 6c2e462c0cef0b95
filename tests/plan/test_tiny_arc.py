"""A corner into an arc of a few tenths of a millimetre bends so fast that rows must stand very close."""

from __future__ import annotations

from pathlib import Path

from trajopt_cli.cell.loader import load_cell
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import TextFile
from trajopt_cli.plan import optimize
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.rapid.reader import run_program

BENCH = Path(__file__).parents[2] / "programs" / "bench_irb140.yaml"
PROGRAM = r"""MODULE Tiny
    CONST robtarget p:=[[450,-150,300],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveL p, v500, z10, tool0;
        MoveC Offs(p,0.1,0.1,0), Offs(p,0.2,0,0), v500, fine, tool0;
        MoveL Offs(p,0,100,0), v500, fine, tool0;
    ENDPROC
ENDMODULE
"""


def test_a_corner_into_a_tiny_arc_is_planned() -> None:
    cell = load_cell(BENCH)
    program, plant = run_program([TextFile("tiny.mod", PROGRAM, "utf-8")], cell.scenario), build_plant(cell)
    plan = optimize(program, plant, Target.RAPID, bounded=False)
    assert isinstance(plan, Plan), plan
    assert verify(program, plant, plan.trajectory, target=Target.RAPID, advice=False).legal
