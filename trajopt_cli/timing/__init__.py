"""The shortest time along paths, by TOPP-RA of our own, and between points, by Ruckig or as a double integrator."""
