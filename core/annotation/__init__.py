"""Annotations checked and repaired."""
