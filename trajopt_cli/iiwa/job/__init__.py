"""The compliant job from a task file to results folders: one file per command, composing the floors below."""
