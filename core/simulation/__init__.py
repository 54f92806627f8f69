"""Simulated images: cut from a label map with known truth, and spoilt on purpose."""
