"""Flight logs as people have them, each read into one ``Telemetry``."""
