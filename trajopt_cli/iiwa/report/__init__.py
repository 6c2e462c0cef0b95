"""Pictures of compliant runs: forces, following, dosing, stability, space."""
