"""Plans as files other machines read: joint CSV and RAPID."""

from trajopt_cli.door import open_door

open_door(__name__, "trajopt_cli.export.files:export")
