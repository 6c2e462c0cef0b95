"""The search over rail positions and arm configurations."""
