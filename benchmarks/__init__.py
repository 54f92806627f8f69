"""Benchmarks of SemRef: scenarios as data, one runner for accuracy, one for time and memory, results as JSON."""
