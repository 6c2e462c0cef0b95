"""The shortest time along paths and between points: faces of TOPP-RA and Ruckig, and TOPP-RA for many paths at once."""
