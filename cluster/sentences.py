"""What is wrong with work on a cluster."""

SENTENCES = {
    "cluster.no_scheduler": (
        "There is no scheduler at {address} ({reason}); start one, or have processes started on this machine: local:4."
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
}
