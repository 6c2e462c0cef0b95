"""The plans a saving is measured against, and the optimum: each is a freedom on a target."""
