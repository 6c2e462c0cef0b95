"""Results folders: one format, written whole or not at all, records checked when they are read back."""

RUN, SUMMARY, REPORT = "run.json", "summary.json", "report.html"
"""In every folder: what made it and what it holds; what came out, in numbers. Where there is one: the page that shows
it."""
