"""Points of exported programs taught anew: python benchmarks/bench_touch_up.py [--seeds 0:100]

Random programs get random rail positions by the export, then every robtarget and work object is shifted by random
millimetres in the program as given and as exported: all poses must move alike. Prints what does not, and how many.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "tests"), str(ROOT / "tests" / "exporters")]

from small_cells import plant_with_rail  # noqa: E402
from touch_up import touch_up  # noqa: E402


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", default="0:100", help="first and behind the last")
    first, _, last = parser.parse_args().seeds.partition(":")
    plant, wrong = plant_with_rail(), 0
    for seed in range(int(first), int(last)):
        if found := touch_up(seed, plant):
            wrong += 1
            print(f"{seed}: {found[0]}")
    print(f"{int(last) - int(first)} programs, {wrong} whose poses do not move alike")
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
