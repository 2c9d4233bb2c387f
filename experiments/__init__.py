"""Measurements and comparisons that anyone can run again, from a checkout: ``python -m experiments NAME``."""
