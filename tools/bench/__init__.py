"""Benchmarks: speed, memory and size of what SemRef makes, and the published method on real data."""
