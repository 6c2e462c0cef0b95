"""photograph.py PAGE.html PICTURE.png: a report page 1.6 s into its cycles, the first screen."""

import sys
import tempfile
from pathlib import Path

from matplotlib import image
from selenium.webdriver import Chrome, ChromeOptions
from selenium.webdriver.chrome.service import Service
from window import FLAGS, Window

page, picture = map(Path, sys.argv[1:])
with tempfile.TemporaryDirectory() as folder:
    options = ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for flag in (*FLAGS, f"--user-data-dir={folder}", "--hide-scrollbars"):
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    chrome = Chrome(options=options, service=Service(executable_path="/usr/bin/chromedriver"))
    try:
        window = Window(chrome)
        window.open(page.resolve(), 1000, 1180)
        window.run("TrajoptPage.clock.seek(1.6)")
        window.settle()
        chrome.save_screenshot(str(picture))
    finally:
        chrome.quit()
shown = image.imread(picture)
image.imsave(picture, shown[:1040])
