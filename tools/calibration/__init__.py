"""Commands that set what the solvers are told (docs/calibration.md)."""
