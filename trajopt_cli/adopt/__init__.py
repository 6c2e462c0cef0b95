"""A URDF that somebody else wrote becomes a robot of this program: two files, clean and commented."""
