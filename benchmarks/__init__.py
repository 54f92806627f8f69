"""Benchmarks of SemRef: scenarios as data; runners for accuracy, flights, time and memory; results as JSON."""
