"""Worlds for the compliant controller to run into: an ideal arm against springs, and MuJoCo's physics."""
