"""Dask: workers here or elsewhere, SemRef's code on them, and tasks in any order, those of dead workers once more."""

from __future__ import annotations

import asyncio
import concurrent.futures
import contextlib
import hashlib
import io
import logging
import os
import shutil
import tempfile
import time
import warnings
import zipfile
from collections import deque
from collections.abc import Iterable, Iterator
from functools import lru_cache
from itertools import islice
from pathlib import Path
from typing import Any, Callable

import cloudpickle
import dask
from distributed import Client, LocalCluster, as_completed
from distributed.scheduler import KilledWorker
from distributed.security import Security

from ..core import errors
from ..core.errors import SemRefError, reason_of
from ..core.sentences import Sentence
from . import code_upload
from .connection import CONNECTED_WITHIN_S, no_scheduler, require_scheduler

ROOT = Path(__file__).resolve().parents[1]
SENT_ROOMS = ("core", "storage", "cluster")

_TASKS_A_THREAD = 3
"""Given to the scheduler at a time: one that is done, one that waits, one whose result is fetched."""

_LOOKED_EVERY_S = 1.0
_DIED_AT_MOST = 3
"""Workers that may die over one task before it is given up: Dask's own number."""

_NO_PAGES = {"distributed.scheduler.http.routes": [], "distributed.worker.http.routes": []}
"""Dask starts a server of web pages with each scheduler and worker in any case."""

_LEFT_OPEN: list[contextlib.ExitStack] = []
"""What is not closed when the user interrupts: closing waits for workers."""

_Tell = Callable[[str], None]


@contextlib.contextmanager
def connected(scheduler: str | None, local: int | None, tell: _Tell) -> Iterator[Client]:
    """A client of workers that have SemRef's code.

    Who reaches a scheduler or a worker runs code there. Those that are started here therefore listen on this machine
    alone, to those who have the certificate of this run; no dashboard is started.

    Args:
        scheduler: Its address; None to start workers here.
        local: How many to start here.
        tell: Takes lines for the user.

    Raises:
        SemRefError: There is no scheduler, or workers can't be started.
    """
    warnings.filterwarnings("ignore", module="distributed")
    logging.getLogger("distributed").setLevel(logging.CRITICAL)
    settings = {"distributed.scheduler.allowed-failures": _DIED_AT_MOST, "distributed.worker.daemon": True}
    with dask.config.set(settings), contextlib.ExitStack() as stack:
        folder = ""
        if scheduler is None:
            folder = tempfile.mkdtemp(prefix="semref-")
            stack.callback(shutil.rmtree, folder, ignore_errors=True)
            stack.enter_context(dask.config.set({**_NO_PAGES, "temporary-directory": folder}))
            cluster = stack.enter_context(_local(local or 1))
            client = stack.enter_context(Client(cluster))
        else:
            client = stack.enter_context(_remote(scheduler))
            if client.dashboard_link:
                tell(f"Dashboard: {client.dashboard_link}")
        _wait_for_workers(client, tell)
        client.register_plugin(_code())
        try:
            yield client
        except KeyboardInterrupt:
            # Who asked waits no longer: workers end with the process, which __main__.py ends at once.
            _LEFT_OPEN.append(stack.pop_all())
            shutil.rmtree(folder, ignore_errors=True)
            raise


def _local(count: int) -> LocalCluster:
    # Python's tracker clears up what an interrupted process left, and would say so to the user.
    others = filter(None, [os.environ.get("PYTHONWARNINGS")])
    os.environ["PYTHONWARNINGS"] = ",".join([*others, "ignore::UserWarning:multiprocessing.resource_tracker"])
    try:
        return LocalCluster(
            n_workers=count,
            threads_per_worker=1,
            memory_limit="auto",
            host="127.0.0.1",
            security=Security.temporary(),
            dashboard_address="127.0.0.1:0",
            scheduler_kwargs={"dashboard": False},
            silence_logs=logging.CRITICAL,
        )
    except (ImportError, OSError, ValueError, RuntimeError) as error:
        raise SemRefError("Workers can't be started here ({reason}).", reason=reason_of(error)) from None


def _remote(address: str) -> Client:
    require_scheduler(address)
    try:
        return Client(address, timeout=CONNECTED_WITHIN_S)
    except (OSError, ValueError) as error:
        raise no_scheduler(address, reason_of(error)) from None


def _wait_for_workers(client: Client, tell: _Tell) -> None:
    """Until there is one: queues of clusters may take hours."""
    told = False
    while not client.scheduler_info().get("workers"):
        if not told:
            tell("Waiting for workers")
            told = True
        time.sleep(_LOOKED_EVERY_S)


@lru_cache(1)
def _code() -> code_upload.Code:
    """SemRef's rooms that workers need, as a plugin of theirs."""
    files = {"__init__.py": b""}
    for room in SENT_ROOMS:
        for path in sorted((ROOT / room).rglob("*.py")):
            files[path.relative_to(ROOT).as_posix()] = path.read_bytes()
    digest = hashlib.sha256(b"".join(name.encode() + content for name, content in files.items())).hexdigest()
    package, archive = f"semref_{digest[:16]}", io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as written:
        for name, content in files.items():
            written.writestr(f"{package}/{name}", content)
    cloudpickle.register_pickle_by_value(code_upload)
    return code_upload.Code(package, archive.getvalue())


class DaskRunner:
    """Has the tasks of a build done by workers, see ``core.database.tasks.Runner``."""

    def __init__(self, client: Client, path: str) -> None:
        """Keeps what all tasks need.

        Args:
            client: As ``connected`` gives it.
            path: The label map, as workers see it.
        """
        self._client = client
        self._path = path
        self._package = _code().name
        self._threads, self._looked = 1, -_LOOKED_EVERY_S

    def __call__(self, task: str, calls: Iterable[tuple], shared: tuple = ()) -> Iterator[tuple[int, Any]]:
        """Yields the number of a call and what it gave, as they are done.

        Raises:
            SemRefError: A task says so, or workers died over it.
        """
        numbers: dict[str, int] = {}
        waiting, finished = enumerate(calls), as_completed()
        try:
            kept = self._client.submit(code_upload.held, shared, pure=False)
            self._submit(task, waiting, kept, numbers, finished)
            for future in finished:
                number = numbers.pop(future.key)
                result = _taken(future)
                future.release()
                self._submit(task, waiting, kept, numbers, finished)
                yield number, result
        except (OSError, asyncio.CancelledError, concurrent.futures.CancelledError) as error:
            raise _lost(error) from None

    def in_order(self, task: str, calls: Iterable[tuple], shared: tuple = ()) -> Iterator[Any]:
        """Yields what calls gave, in their order; what is done before its turn waits with the workers.

        Raises:
            SemRefError: As for ``__call__``.
        """
        waiting, ahead = iter(calls), deque[Any]()
        try:
            kept = self._client.submit(code_upload.held, shared, pure=False)
            while True:
                more = max(self._room() - len(ahead), 0)  # Workers may have gone since.
                ahead += (self._given(task, kept, call) for call in islice(waiting, more))
                if not ahead:
                    return
                future = ahead.popleft()
                result = _taken(future)
                future.release()
                yield result
        except (OSError, asyncio.CancelledError, concurrent.futures.CancelledError) as error:
            raise _lost(error) from None

    def _given(self, task: str, kept: Any, arguments: tuple) -> Any:
        return self._client.submit(code_upload.call, self._package, task, self._path, kept, arguments, pure=False)

    def _submit(self, task: str, waiting: Iterator, kept: Any, numbers: dict[str, int], finished: as_completed) -> None:
        """Fills up what the scheduler has to give out."""
        while len(numbers) < self._room():
            found = next(waiting, None)
            if found is None:
                return
            number, arguments = found
            future = self._given(task, kept, arguments)
            numbers[future.key] = number
            finished.add(future)

    def _room(self) -> int:
        """How many tasks are given out at a time; workers come and go."""
        if time.monotonic() > self._looked + _LOOKED_EVERY_S:
            self._threads = max(sum(self._client.nthreads().values()), 1)
            self._looked = time.monotonic()
        return _TASKS_A_THREAD * self._threads


def _lost(error: BaseException) -> SemRefError:
    return SemRefError(
        "The scheduler can't be reached any more ({reason}); see its log and start again.", reason=reason_of(error)
    )


def _taken(future: Any) -> Any:
    """What a task gave; raises SemRefError."""
    try:
        state, result = future.result()
    except KilledWorker:
        raise SemRefError(
            "{count} workers died over one piece of the work; give workers more memory, or see their logs for the "
            "reason.",
            count=_DIED_AT_MOST + 1,
        ) from None
    except (OSError, concurrent.futures.CancelledError):
        raise
    except Exception as error:
        raise SemRefError("A worker could not do its part ({reason}).", reason=reason_of(error)) from None
    if state == "failed":
        kind, template, values = result
        raise getattr(errors, kind)(Sentence(template, **dict(values)))
    return result
