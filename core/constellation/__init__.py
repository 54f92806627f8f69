"""Constellation localization: landmarks as stars (docs/method.md)."""
