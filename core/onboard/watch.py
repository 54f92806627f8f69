"""``semref watch``: the images of a folder as they arrive, and the record of each.

Nothing in the folder ends the watching: what can't be looked at is left out, and a folder that is gone is waited for.
"""

from __future__ import annotations

import logging
import os
import time
from collections.abc import Iterator
from contextlib import ExitStack, closing
from datetime import datetime, timezone
from typing import TYPE_CHECKING, Any, Callable

from ..errors import ParameterError, reason_of
from ..labels.image_files import is_image_name
from ..localizer.record import gga_sentence
from .log import json_line, log_event
from .sinks import open_sink

if TYPE_CHECKING:
    from .mavlink import MavlinkSink

LOOK_EVERY_S = 0.2
"""How often a folder is looked into; an image is taken when it has not changed from one look to the next."""

State = tuple[int, int]
"""(time of change in ns, bytes) of an image."""


def watch(  # noqa: PLR0913 - each sink is a place of its own
    folder: str,
    once: bool,
    find: Callable[[str], dict[str, Any]],
    fixes: str | None,
    gga: str | None,
    mavlink: MavlinkSink | None = None,
    after: tuple[int, str] | None = None,
) -> tuple[set[str], int]:
    """Localizes a folder's images as they come, without end unless ``once``.

    Args:
        folder: That images are written into.
        once: End when the images that are there are done.
        find: Path → record of an image.
        fixes: Where a JSON line for each image goes, see ``sinks.opened``.
        gga: Where a GGA sentence for each image goes.
        mavlink: An autopilot that is told; closed at the end.
        after: (time of change in ns, name) of an image: those that lie in the folder already, up to it, are done.

    Returns:
        The statuses that images had, and how many lines could not be sent.

    Raises:
        ParameterError: A sink can't be opened, or with ``once`` the folder can't be looked into.
    """
    statuses = set()
    with ExitStack() as stack:
        fix_sink, gga_sink = (stack.enter_context(closing(open_sink(where))) for where in (fixes, gga))
        if mavlink is not None:
            stack.enter_context(closing(mavlink))
        for path in arriving_images(folder, once, after):
            found = find(path)
            # The autopilot first: it flies by it.
            if mavlink is not None:
                mavlink.send_found(found)
            fix_sink.send(json_line(found) + "\n")
            gga_sink.send(_gga(found) + "\r\n")
            statuses.add(found["status"])
    return statuses, fix_sink.lost + gga_sink.lost + (0 if mavlink is None else mavlink.lost)


def _gga(found: dict[str, Any]) -> str:
    taken = datetime.fromisoformat(found["time"]) if found["time"] else datetime.now(timezone.utc)
    return gga_sentence(taken, found.get("longitude"), found.get("latitude"), found.get("inliers") or 0)


def arriving_images(folder: str, once: bool, after: tuple[int, str] | None = None) -> Iterator[str]:
    """Images of a folder, each when it is complete, in order of time and name; one that is written anew comes again.

    With ``after`` those that lie there at the first look, up to this time and name, are left out.

    A folder that can't be looked into is told in the log, once, and waited for; with ``once`` it is an error.
    """
    before: dict[str, State] = {}
    done: dict[str, State] = {}
    gone = False
    while True:
        try:
            now = _images_in(folder)
        except OSError as error:
            if once:
                raise ParameterError(
                    "The folder {folder} can't be looked into ({reason}); start again when it can.",
                    folder=folder,
                    reason=reason_of(error),
                ) from None
            if not gone:
                log_event(logging.ERROR, "folder_gone", folder=folder, reason=reason_of(error))
            gone, before = True, {}
            time.sleep(LOOK_EVERY_S)
            continue
        if gone:
            log_event(logging.ERROR, "folder_back", folder=folder)
            gone = False
        if after is not None:
            done = {path: state for path, state in now.items() if (state[0], os.path.basename(path)) <= after}
            after = None
        # What was removed is forgotten: a watch of weeks must not grow.
        done = {path: state for path, state in done.items() if path in now}
        complete = [path for path, state in now.items() if done.get(path) != state]
        if not once:
            complete = [path for path in complete if before.get(path) == now[path] and now[path][1] > 0]
        for path in sorted(complete, key=lambda path: (now[path][0], path)):
            done[path] = now[path]
            yield path
        if once:
            return
        before = now
        time.sleep(LOOK_EVERY_S)


def _images_in(folder: str) -> dict[str, State]:
    """The state of each image by path; what is no regular file is left out.

    Raises:
        OSError: The folder can't be looked into.
    """
    found = {}
    with os.scandir(folder) as entries:
        for entry in entries:
            if not is_image_name(entry.name):
                continue
            try:
                state = entry.stat() if entry.is_file() else None
            except OSError as error:
                # Removed between being listed and being looked at, a link to itself, no right to look.
                log_event(logging.DEBUG, "left_out", path=entry.path, reason=reason_of(error))
                continue
            if state is not None:
                found[entry.path] = (state.st_mtime_ns, state.st_size)
    return found
