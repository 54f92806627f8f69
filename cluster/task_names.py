"""Names of the workers' tasks, in addition to those of ``core.database.tasks``."""

SEGMENT, BURN = "segment", "burn"
"""Segment a block of a photo's tiles; rasterize a strip of polygons."""

IMAGES, EVALUATE, ASSESS, CORRELATE = "images", "evaluate", "assess", "correlate"
"""Localize an image; run a trial of an evaluation; localize a simulated image; correlate it with the map."""
