"""Marks on the map canvas, and map tools."""
