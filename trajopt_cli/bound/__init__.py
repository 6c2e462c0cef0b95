"""Lower bounds on the cycle time."""
