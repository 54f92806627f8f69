"""Widgets and layouts that all parts of the dock share."""
