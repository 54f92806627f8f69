"""What is sent to the workers as it stands: SemRef's own code, so that they need a Python with the packages and nothing
of SemRef, and always run what the one who asks runs.

All here is pickled whole – the scheduler, too, takes it apart and has nothing of SemRef – so it imports what it needs
itself and names nothing else of this package.
"""

from __future__ import annotations

from distributed.diagnostics.plugin import WorkerPlugin


class Code(WorkerPlugin):
    """Makes SemRef's rooms importable in a worker, under a name that tells their content."""

    def __init__(self, package: str, archive: bytes) -> None:
        """Keeps what is sent.

        Args:
            archive: A zip whose one folder has that name.
        """
        self.name = package
        self.archive = archive

    def setup(self, worker: object) -> None:
        """Called in each worker, also in those that come later."""
        import os
        import sys

        path = os.path.join(worker.local_directory, f"{self.name}.zip")  # type: ignore[attr-defined]
        with open(path, "wb") as file:
            file.write(self.archive)
        sys.path.insert(0, path)


def call(package: str, task: str, path: str, shared: tuple, arguments: tuple) -> tuple:
    """``tasks.do`` of the code that was sent."""
    import importlib

    return importlib.import_module(f"{package}.cluster.tasks").do(task, path, shared, arguments)


def held(values: tuple) -> tuple:
    """Arguments that many tasks share: sent to a worker once, and made again where a worker died with them."""
    return values


for _function in (call, held):
    # Functions are pickled by their names but for those of the main program.
    _function.__module__ = "__main__"
