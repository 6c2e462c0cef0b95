"""The iiwa job: what a Cartesian task is, its equilibrium sequence, and the joints that follow it."""
