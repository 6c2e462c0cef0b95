"""From a program and its cell to answers and files: composes the engines, no mathematics of its own."""
