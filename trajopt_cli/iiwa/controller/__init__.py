"""The compliant (admittance) controller: its law, its forces and stability, and the whole loop against a world."""
