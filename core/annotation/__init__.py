"""Check and repair land-cover layers: polygons with classes."""
