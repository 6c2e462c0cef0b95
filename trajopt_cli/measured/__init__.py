"""What a controller recorded: reading it, finding its motions, and the limits that they show."""
