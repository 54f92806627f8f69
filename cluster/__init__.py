"""The same work on many processes or machines, by Dask, in a Python with GDAL and without QGIS."""

# ``python -m cluster`` imports this as a package of its own first; __main__.py then loads it again, as a room.
if "." in __name__:
    from ..core.sentences import add
    from .sentences import SENTENCES

    add(SENTENCES)
