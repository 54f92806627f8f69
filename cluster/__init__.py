"""Tasks on many processes or machines, by Dask: a process beside QGIS and workers, all free of QGIS."""
