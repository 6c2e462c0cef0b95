"""Legal motions in files of few digits: how many are judged legal, how many too coarse, and how many refused.

    python benchmarks/bench_coarse_files.py --motions 80

Random legal motions, the seeds 0 to N - 1, are written on a bare grid every 4, 10 and 20 ms in four formats, with the
speeds and without. None may be refused: a file is legal, or too coarse for a check, and then the judge says how finely
it must be printed. Prints a table and the finest steps that were asked for; exit code 1 if a legal motion was refused.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections import Counter
from pathlib import Path

TESTS = Path(__file__).parents[1] / "tests"
sys.path[:0] = [str(TESTS.parent), str(TESTS), str(TESTS / "judge")]  # run from a checkout without installing

from legal_motion import Case  # noqa: E402
from legal_random import random_case, written  # noqa: E402

from trajopt_cli.errors import InputError  # noqa: E402
from trajopt_cli.joint_csv import read_csv_text  # noqa: E402
from trajopt_cli.judge.verify import verify  # noqa: E402

FORMATS = ("%.9g", "%.6g", "%.5g", "%.4f")
STEPS = (0.004, 0.01, 0.02)


def judged(case: Case, spell: str, step: float, speeds: bool) -> tuple[str, str]:
    """ "legal", "too coarse" with the resolution needed, or "refused" with what for."""
    text = written(case.rows(step=step, grid_only=True), spell, speeds)
    try:
        trajectory, resolution = read_csv_text(text, "a.csv")
    except InputError as no:  # two times that are printed alike
        return ("too coarse", "times: more digits") if "print more digits" in str(no) else ("refused", str(no))
    report = verify(case.program, case.plant, trajectory, resolution, advice=False)
    failed = [one for one in report.findings if not one.passed]
    if not failed:
        return "legal", ""
    if report.too_coarse:
        found = re.findall(r"print (.*) \(SI\)", failed[0].message)
        return "too coarse", found[0] if found else failed[0].message
    return "refused", ", ".join(sorted({one.check for one in failed}))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--motions", type=int, default=80)
    parser.add_argument("--formats", nargs="*", default=FORMATS)
    options = parser.parse_args()
    cases = [random_case(seed) for seed in range(options.motions)]
    print(f"{'format':8}{'rows every':>11}  {'speeds':8}{'legal':>6}{'too coarse':>12}{'refused':>9}  asked for")
    refused = 0
    for spell in options.formats:
        for step in STEPS:
            for speeds in (False, True):
                found = [judged(case, spell, step, speeds) for case in cases]
                count, asked = Counter(word for word, _ in found), Counter(why for _, why in found if why)
                refused += count["refused"]
                most = "; ".join(f"{why} ({n})" for why, n in asked.most_common(3))
                print(
                    f"{spell:8}{step * 1e3:8.0f} ms  {'yes' if speeds else 'no':8}{count['legal']:6}"
                    f"{count['too coarse']:12}{count['refused']:9}  {most}", flush=True,
                )  # fmt: skip
    sys.exit(refused > 0)


if __name__ == "__main__":
    main()
