"""Run tasks on several processes or machines with Dask. No process here needs QGIS."""
