"""What is wrong with work on a cluster."""

SENTENCES = {
    "cluster.lacks_package": (
        "{python} has no {package}; install what cluster/requirements.txt names and GDAL there, or use another Python."
    ),
    "cluster.unfit_numpy": (
        "GDAL of {python} was made for another numpy than the {version} that is there; install the one that it was "
        "made for, which docs/guide/cluster.md tells how to."
    ),
    "cluster.no_scheduler": (
        "There is no scheduler at {address} ({reason}); start one, or have processes started on this machine: "
        "--local 4, in QGIS local:4."
    ),
    "cluster.other_server": (
        "What answers at {address} is no scheduler of Dask, or one of another version; give the address that the "
        "scheduler prints, not its dashboard's."
    ),
    "cluster.not_started": "Workers can't be started here ({reason}).",
    "cluster.ended": "The process that does the work ended ({reason}); start it again.",
    "cluster.connection_lost": "The scheduler can't be reached any more ({reason}); see its log and start again.",
    "cluster.workers_died": (
        "{count} workers died over one piece of the work; give workers more memory, or see their logs for the reason."
    ),
    "cluster.worker_failed": "A worker could not do its part ({reason}).",
    "cluster.map_changed": "{path} was changed while it was read; start again when it stays as it is.",
    "cluster.not_a_number": "{option} is “{text}”; give numbers separated by “;”.",
    "cluster.no_method": "“{name}” is no method; give some of {known}, separated by “;”.",
    "cluster.no_range": "{option} is “{text}”; give the smallest and the largest value, such as 0,20.",
    "cluster.no_extent": "--extent is “{text}”; give left,bottom,right,top in map units.",
    "cluster.stride_above_size": "The stride {stride:g} is larger than the window size {size:g}; choose a smaller one.",
    "cluster.output_is_input": "The result would replace {path}; choose another name.",
    "cluster.photo_not_in_meters": (
        "{path} is in {crs}, which does not measure in meters; warp it to a projected CRS in meters."
    ),
}
