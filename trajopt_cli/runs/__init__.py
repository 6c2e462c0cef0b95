"""Results folders: one format, written whole or not at all, records checked when they are read back."""

RUN, SUMMARY, REPORT = "run.json", "summary.json", "report.html"
"""In every folder: what made it and what it holds; what came out, in numbers. Where there is one: the page that shows
it."""
EXPORTS = frozenset(("joint.csv", "ros2.yaml", "joint.mcap", "joint.parquet", "fri.csv", "stream.egm", "cell.glb"))
"""What `trajopt export` may add to a folder: no part of the run, gone with it."""
