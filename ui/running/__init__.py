"""Algorithms and reading in the background."""
