"""Readers of flight logs; each returns a ``Telemetry``."""
