"""What a program's motions touch, and joint moves around it: scenes, roadmaps, checks of edges and motions."""
