"""trajopt: the fastest legal motion for the robot program a cell already runs."""

__version__ = "0.1.0"
