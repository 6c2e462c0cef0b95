"""The nonlinear program of a plan, its assembly and its solution."""
