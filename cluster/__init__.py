"""Tasks on many processes or machines, by Dask: a process beside QGIS and workers, all free of QGIS."""

from ..core.sentences import add
from .sentences import SENTENCES

add(SENTENCES)
