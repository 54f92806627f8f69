"""Predict where a database will localize and where it will not, before a flight."""
