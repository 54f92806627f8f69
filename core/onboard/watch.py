"""``semref watch``: localize the images of a folder as they arrive, and send a record of each.

Problems of the folder do not end the watching: unreadable files are skipped, and a missing folder is waited for.
"""

from __future__ import annotations

import logging
import os
import time
from collections.abc import Iterator
from contextlib import ExitStack, closing
from datetime import datetime, timezone
from typing import Any, Callable

from ..errors import ParameterError, reason_of
from ..labels.image_files import is_image_name
from ..localization import Status
from .log import json_line, log_event
from .nmea import gga_sentence
from .sinks import Sink, open_sink

LOOK_EVERY_S = 0.2
"""Seconds between looks into the folder. An image is localized if it did not change between two looks."""

State = tuple[int, int]
"""(time of change in ns, bytes) of an image."""


def watch(  # noqa: PLR0913 - each sink is a place of its own
    folder: str,
    once: bool,
    find: Callable[[str], dict[str, Any]],
    fixes: str,
    gga: str | None,
    mavlink: Sink | None = None,
    after: tuple[int, str] | None = None,
) -> tuple[set[str], int]:
    """Localize a folder's images as they arrive; without ``once`` this never ends.

    Args:
        folder: Where images are written.
        once: End after the images that are in the folder.
        find: Path → record of an image.
        fixes: Output of JSON lines, one for each image, see ``sinks.open_sink``.
        gga: Output of GGA sentences, one for each image; None for none.
        mavlink: Output to an autopilot; closed at the end.
        after: (time of change in ns, name) of an image: those in the folder up to it are done.

    Returns:
        The statuses of the images, and the number of lines that could not be sent.

    Raises:
        ParameterError: An output can't be opened, or with ``once`` the folder can't be read.
    """
    statuses = set()
    with ExitStack() as stack:
        # The autopilot first, because it navigates by the position.
        outputs: list[tuple[Sink, Callable[[dict[str, Any]], Any]]] = [] if mavlink is None else [(mavlink, dict)]
        outputs.append((open_sink(fixes), lambda found: json_line(found) + "\n"))
        if gga is not None:
            outputs.append((open_sink(gga), lambda found: _gga(found) + "\r\n"))
        for sink, _ in outputs:
            stack.enter_context(closing(sink))
        for path in arriving_images(folder, once, after):
            found = find(path)
            for sink, form in outputs:
                sink.send(form(found))
            statuses.add(found["status"])
    return statuses, sum(sink.lost for sink, _ in outputs)


def _gga(found: dict[str, Any]) -> str:
    taken = datetime.fromisoformat(found["time"]) if found["time"] else datetime.now(timezone.utc)
    if found["status"] != Status.FIX:
        # Likely positions are for people only.
        return gga_sentence(taken)
    return gga_sentence(taken, found.get("longitude"), found.get("latitude"), found.get("inliers") or 0)


def arriving_images(folder: str, once: bool, after: tuple[int, str] | None = None) -> Iterator[str]:
    """Yield images of a folder, each when it is complete, in order of time and name; a rewritten one comes again.

    With ``after``, images up to this time and name are left out of the first look.

    A folder that can't be read is logged once and waited for; with ``once`` it is an error.
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
                    "The folder {folder} can't be read: {reason}. Start again when it can be read.",
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
        # Removed images are dropped: the memory of a watch must not grow for weeks.
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
    """Return the state of each image by path; only regular files count.

    Raises:
        OSError: The folder can't be read.
    """
    found = {}
    with os.scandir(folder) as entries:
        for entry in entries:
            if not is_image_name(entry.name):
                continue
            try:
                state = entry.stat() if entry.is_file() else None
            except OSError as error:
                # The file was removed in the meantime, links to itself, or may not be read.
                log_event(logging.DEBUG, "left_out", path=entry.path, reason=reason_of(error))
                continue
            if state is not None:
                found[entry.path] = (state.st_mtime_ns, state.st_size)
    return found
