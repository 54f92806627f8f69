"""Landmarks: from labels to areas and centers of gravity, for images and for maps of any size."""
