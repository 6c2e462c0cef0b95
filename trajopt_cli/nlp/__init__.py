"""The nonlinear program of a plan, its assembly and its solution."""

from trajopt_cli.nlp.casadi_export import CasadiProgram, as_casadi

__all__ = ["CasadiProgram", "as_casadi"]
