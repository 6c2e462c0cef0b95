"""Instructions by topic; table.py lists them all."""
