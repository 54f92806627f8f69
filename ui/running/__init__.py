"""Algorithms and file reading in the background."""
