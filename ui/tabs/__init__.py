"""The tabs of the dock: Localize, Inspect, Correct."""
