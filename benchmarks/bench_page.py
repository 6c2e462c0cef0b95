"""How large a report page is, and how long a browser takes to its first picture and for a step of the clock.

python benchmarks/bench_page.py FOLDER|FILE.html...

Every page is opened three times in a browser without a window and without a graphics card; the best counts.
"""

from __future__ import annotations

import shutil
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "page" / "browser"))

from window import FLAGS

# From the navigation's start to the first frame in which the page is there, the 3-D view in it; then 20 steps.
FIRST = """const done = arguments[0];
requestAnimationFrame(() => requestAnimationFrame(() => done(performance.now())));"""
STEPS = """const done = arguments[0]; if (!TrajoptPage.data.clock) return done(0); let k = 0;
const end = TrajoptPage.clock.duration; const start = performance.now();
const step = () => { if (k === 20) return done((performance.now() - start) / 20);
  TrajoptPage.clock.seek((end * ++k) / 20); requestAnimationFrame(step); }; step();"""
PAINT = "const e = performance.getEntriesByName('first-contentful-paint')[0]; return e ? e.startTime : null;"


def main() -> None:
    from selenium.webdriver import Chrome, ChromeOptions
    from selenium.webdriver.chrome.service import Service

    pages = [path / "report.html" if path.is_dir() else path for path in map(Path, sys.argv[1:])]
    if not pages:
        sys.exit(__doc__)
    driver = shutil.which("chromedriver")
    if driver is None:
        sys.exit("no chromedriver here")
    with tempfile.TemporaryDirectory() as profile:
        options = ChromeOptions()
        for flag in (*FLAGS, f"--user-data-dir={profile}", "--window-size=1280,900"):
            options.add_argument(flag)
        chrome = Chrome(options=options, service=Service(executable_path=driver))
        try:
            for page in pages:
                runs = []
                for _ in range(3):
                    chrome.get("data:,")
                    chrome.get(page.resolve().as_uri())
                    whole = chrome.execute_async_script(FIRST)
                    runs.append((chrome.execute_script(PAINT) or whole, whole, chrome.execute_async_script(STEPS)))
                paint, whole, step = (min(values) for values in zip(*runs, strict=True))
                size = page.stat().st_size / 1e6
                print(
                    f"{page}: {size:.2f} MB, first paint {paint:.0f} ms, all drawn {whole:.0f} ms, a step {step:.1f} ms"
                )
        finally:
            chrome.quit()


if __name__ == "__main__":
    main()
