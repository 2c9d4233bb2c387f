"""Exercises of each notebook: a module with the name of the notebook, and in it ``EXERCISES``."""
