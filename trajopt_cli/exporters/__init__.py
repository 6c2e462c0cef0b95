"""Plans as files other machines read: joint CSV and RAPID."""
