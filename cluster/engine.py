"""Run tasks with Dask on local or remote workers, and repeat the tasks of workers that died."""

from __future__ import annotations

import asyncio
import concurrent.futures
import contextlib
import hashlib
import io
import logging
import os
import shutil
import socket
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
from distributed import Client, LocalCluster
from distributed.comm import connect as connect_directly
from distributed.comm.addressing import parse_address, parse_host_port
from distributed.scheduler import KilledWorker
from distributed.security import Security

from ..core import errors
from ..core.errors import SemRefError, reason_of
from ..core.sentences import Sentence
from . import code_upload

ROOT = Path(__file__).resolve().parents[1]
SENT_ROOMS = ("core", "storage", "cluster")

_TASKS_A_THREAD = 3
"""Tasks per thread at the scheduler: one runs, one waits, and the result of one is fetched."""

_CHECK_EVERY_S = 1.0
_REPEATS = 3
"""How often a task is repeated after its worker died; Dask's default."""

_NO_PAGES = {"distributed.scheduler.http.routes": [], "distributed.worker.http.routes": []}
"""Disables the web pages that Dask serves from each scheduler and worker."""

_LEFT_OPEN: list[contextlib.ExitStack] = []
"""Contexts that are not closed when the user cancels, because closing waits for workers."""


@contextlib.contextmanager
def connect(scheduler: str | None, local: int | None, report: Callable[[str], None]) -> Iterator[Client]:
    """Connect to workers and install SemRef's code on them.

    Any program that can connect to a scheduler or worker can run code there. Local ones therefore listen on this
    machine only and require the certificate of this run. No dashboard is started.

    Args:
        scheduler: Address of a scheduler; None to start local workers.

    Raises:
        SemRefError: There is no scheduler, or workers can't be started.
    """
    warnings.filterwarnings("ignore", module="distributed")
    logging.getLogger("distributed").setLevel(logging.CRITICAL)
    settings = {"distributed.scheduler.allowed-failures": _REPEATS, "distributed.worker.daemon": True}
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
                report(f"Dashboard: {client.dashboard_link}")
        _wait_for_workers(client, report)
        client.register_plugin(_code())
        try:
            yield client
        except KeyboardInterrupt:
            # Workers end with this process, which service.py ends at once.
            _LEFT_OPEN.append(stack.pop_all())
            shutil.rmtree(folder, ignore_errors=True)
            raise


def _local(count: int) -> LocalCluster:
    # Hides a warning of Python's resource tracker after a canceled run.
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


def _wait_for_workers(client: Client, report: Callable[[str], None]) -> None:
    """Wait for the first worker; in the queue of a cluster this may take hours."""
    if not client.scheduler_info().get("workers"):
        report("Waiting for workers")
    while not client.scheduler_info().get("workers"):
        time.sleep(_CHECK_EVERY_S)


@lru_cache(1)
def _code() -> code_upload.Code:
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
    """A ``core.database.tasks.Runner`` that executes tasks on workers."""

    def __init__(self, client: Client, path: str) -> None:
        """Store what all tasks need.

        Args:
            client: Result of ``connect``.
            path: Path of the label map on the workers.
        """
        self._client = client
        self._path = path
        self._package = _code().name
        self._threads, self._checked = 1, -_CHECK_EVERY_S

    def __call__(self, task: str, calls: Iterable[tuple], shared: tuple = ()) -> Iterator[Any]:
        """Yield results in the order of the calls; early results wait on the workers.

        Raises:
            SemRefError: A task failed, or workers died while executing it.
        """
        waiting, ahead = iter(calls), deque[Any]()
        try:
            kept = self._client.submit(code_upload.share, shared, pure=False)
            while True:
                more = max(self._room() - len(ahead), 0)  # the number of workers may have decreased
                ahead += (self._start(task, kept, call) for call in islice(waiting, more))
                if not ahead:
                    return
                future = ahead.popleft()
                result = _result_of(future)
                future.release()
                yield result
        except (OSError, asyncio.CancelledError, concurrent.futures.CancelledError) as error:
            raise _lost(error) from None

    def _start(self, task: str, kept: Any, arguments: tuple) -> Any:
        return self._client.submit(code_upload.call, self._package, task, self._path, kept, arguments, pure=False)

    def _room(self) -> int:
        """Return how many tasks to submit at a time; the number of workers may change."""
        if time.monotonic() > self._checked + _CHECK_EVERY_S:
            self._threads = max(sum(self._client.nthreads().values()), 1)
            self._checked = time.monotonic()
        return _TASKS_A_THREAD * self._threads


def _lost(error: BaseException) -> SemRefError:
    return SemRefError(
        "The connection to the scheduler was lost ({reason}). See the log of the scheduler, then start again.",
        reason=reason_of(error),
    )


def _result_of(future: Any) -> Any:
    """Return the result of a task. Raises SemRefError."""
    try:
        state, result = future.result()
    except KilledWorker:
        raise SemRefError(
            "{count} workers stopped while executing the same task. Give workers more memory, or see their logs for "
            "the reason.",
            count=_REPEATS + 1,
        ) from None
    except (OSError, concurrent.futures.CancelledError):
        raise
    except Exception as error:
        raise SemRefError("A worker could not execute its task ({reason}).", reason=reason_of(error)) from None
    if state == "failed":
        kind, template, values = result
        raise getattr(errors, kind)(Sentence(template, **dict(values)))
    return result


CONNECTED_WITHIN_S = 15

_REFUSED_FOR_S = 3.0
"""How long to retry while a scheduler, or a tunnel to it, starts and refuses connections."""

_ASKED_AGAIN_AFTER_S = 0.2


def require_scheduler(address: str) -> None:
    """Raise SemRefError if no scheduler answers at an address."""
    try:
        _require_listening(address)
        asyncio.run(_greet(address))
    except asyncio.TimeoutError:
        reason = f"no answer within {CONNECTED_WITHIN_S} s"
        raise no_scheduler(address, reason) from None
    except (OSError, ValueError) as error:
        raise no_scheduler(address, reason_of(error)) from None
    except (MemoryError, RuntimeError, TypeError, KeyError, AttributeError):
        # Answers of other programs are misread as message sizes and types.
        raise SemRefError(
            "The program at {address} is not a Dask scheduler, or has another version. Enter the address that the "
            "scheduler prints, not the address of its dashboard.",
            address=address,
        ) from None


def no_scheduler(address: str, reason: str) -> SemRefError:
    return SemRefError(
        "There is no scheduler at {address} ({reason}); start one, or have processes started on this machine: local:4.",
        address=address,
        reason=reason,
    )


def _require_listening(address: str) -> None:
    scheme, place = parse_address(address)
    if scheme not in ("tcp", "tls"):
        return
    until = time.monotonic() + _REFUSED_FOR_S
    while True:
        try:
            with contextlib.closing(socket.create_connection(parse_host_port(place), CONNECTED_WITHIN_S)):
                return
        except ConnectionRefusedError:
            if time.monotonic() > until:
                raise
        time.sleep(_ASKED_AGAIN_AFTER_S)


async def _greet(address: str) -> None:
    """Connect as the client will, and close."""
    given = Security().get_connection_args("client")
    comm = await asyncio.wait_for(connect_directly(address, timeout=CONNECTED_WITHIN_S, **given), CONNECTED_WITHIN_S)
    await comm.close()
