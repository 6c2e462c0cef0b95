"""Families of cells and programs: many optimisations, what they answer together, and the page that shows it."""
