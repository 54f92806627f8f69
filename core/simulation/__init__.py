"""Simulated images: cut from a label map with known truth, and spoiled on purpose."""
