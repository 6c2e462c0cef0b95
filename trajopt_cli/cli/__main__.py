"""`python -m trajopt_cli.cli` is `trajopt`."""

from trajopt_cli.cli import main

main()
