"""What of ``core`` an aircraft needs."""

AIRCRAFT_ROOMS = (
    "__init__.py",
    "__main__.py",
    "cache.py",
    "errors.py",
    "localization.py",
    "named_files.py",
    "pipeline.py",
    "values.py",
    "sentences",
    "geometry",
    "labels",
    "landmarks",
    "windows",
    "database",
    "constellation",
    "correlation",
    "localizer",
    "segmentation",
    "flight",
    "onboard",
)
"""The files and folders of ``core`` that ``python -m core`` runs from; none of them imports another one."""
