"""Training a segmentation network in a Python of its own that has torch; QGIS only starts it (docs/training.md)."""
