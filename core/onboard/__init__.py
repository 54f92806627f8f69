"""Localize on an aircraft: the onboard file, the command ``semref``, and its outputs."""
