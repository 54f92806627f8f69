"""Send SemRef's code to the workers, which need only Python and the packages, and always run the same version.

Code in this file is pickled by value, because the scheduler unpickles it without SemRef. Functions therefore import
what they need, and use nothing else of this package.
"""

from __future__ import annotations

from distributed.diagnostics.plugin import WorkerPlugin


class Code(WorkerPlugin):
    """Makes SemRef's rooms importable in a worker, under a name with the hash of their content."""

    def __init__(self, package: str, archive: bytes) -> None:
        """Store the code to send; ``archive``: a zip file with one folder of that name."""
        self.name = package
        self.archive = archive

    def setup(self, worker: object) -> None:
        """Install the package in a worker. Dask calls this in each worker, also in later ones."""
        import os
        import sys

        path = os.path.join(worker.local_directory, f"{self.name}.zip")  # type: ignore[attr-defined]
        with open(path, "wb") as file:
            file.write(self.archive)
        sys.path.insert(0, path)


def call(package: str, task: str, path: str, shared: tuple, arguments: tuple) -> tuple:
    """Call ``tasks.do`` of the installed package."""
    import importlib

    return importlib.import_module(f"{package}.cluster.tasks").do(task, path, shared, arguments)


def share(values: tuple) -> tuple:
    """Return arguments that many tasks share. Because this is a task, Dask sends them to each worker once."""
    return values


for _function in (call, share):
    # Only functions of the main program are pickled by value.
    _function.__module__ = "__main__"
