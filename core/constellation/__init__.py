"""Constellation localization: landmarks as stars (docs/explanation/method.md)."""
