"""Results folders: one format, one atomic writer, records checked when they are read back."""
