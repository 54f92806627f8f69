"""``localize``: images in an onboard file by many workers; the records of ``python -m core localize``, in its order."""

from __future__ import annotations

from argparse import Namespace
from typing import Any

from ..core.labels.image_files import image_files
from ..core.onboard.command_line import exit_code, localize_options, told
from .engine import DaskRunner, connected
from .inputs import Teller
from .tasks import LOCALIZE


def localize(options: Namespace, others: list[str], teller: Teller) -> int:
    """Localizes the images that the command line names; gives the exit code.

    Args:
        options: Of the command line, where the workers are.
        others: The rest of it, as ``python -m core localize`` takes it.
        teller: Takes what is being done.

    Raises:
        SemRefError: Anything that the user can mend.
    """
    asked = localize_options(others)
    paths = image_files(asked.images)
    waiting: dict[int, dict[str, Any]] = {}
    statuses, written = set(), 0
    with connected(options.scheduler, options.local, options.worker_memory, teller.say) as client:
        runner = DaskRunner(client, "")
        calls = ((path,) for path in paths)
        for done, (number, record) in enumerate(runner(LOCALIZE, calls, tuple(others)), start=1):
            waiting[number] = record
            statuses.add(record["status"])
            while written in waiting:
                print(told(waiting.pop(written), asked), flush=True)
                written += 1
            teller.step("Localizing images", done / len(paths))
    return exit_code(statuses)
