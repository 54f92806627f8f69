"""Tasks that workers know beside those of ``core.database.tasks``."""

SEGMENT, BURN = "segment", "burn"
"""A block of a photo's tiles; a strip of polygons."""

IMAGES, EVALUATE, ASSESS, CORRELATE = "images", "evaluate", "assess", "correlate"
"""Pieces of a job: an image to localize, a trial of an evaluation, a simulated image, map correlation of one."""
