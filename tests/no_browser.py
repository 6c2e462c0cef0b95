"""What is said where the report page cannot be tested."""

MISSING = "no browser here: install chromium and its chromedriver (Debian: chromium, chromium-driver)"
