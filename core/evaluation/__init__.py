"""Measure how well a database localizes, by trials with known ground truth."""
