"""Results folders: one format, written whole or not at all, records checked when they are read back."""

RUN, SUMMARY = "run.json", "summary.json"
"""In every folder: what made it and what it holds; what came out, in numbers."""
