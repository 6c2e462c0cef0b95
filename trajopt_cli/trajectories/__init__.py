"""Candidate motions of the legs, and their check against every limit."""
