"""Names of files inside other files: followed only inside folders that the user chose."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable

_NO_LOCAL_PATH = re.compile(r"//|/vsi|<|\{|[a-z][\w+.-]+:", re.IGNORECASE)


def is_elsewhere(path: str) -> bool:
    r"""Return whether a path is not that of a local file.

    Such are UNC paths, URLs, and what GDAL opens as a virtual file, a connection or a description.

    >>> [is_elsewhere(path) for path in (r"\\host\share\a.tif", "/vsicurl/http://host/a.tif", r"C:\maps\a.tif")]
    [True, True, False]
    """
    return _NO_LOCAL_PATH.match(path.strip().replace("\\", "/")) is not None


def named_file(name: str, chosen: Iterable[str]) -> str:
    """Return the path of a file that another file names; empty where the user did not choose it.

    Args:
        name: As the file has it, absolute or from a chosen folder on.
        chosen: Files and folders; of a folder everything in it is chosen. Nothing outside them is looked at.
    """
    is_local = "\0" not in name and (os.path.isabs(name) or not is_elsewhere(name))
    for one in chosen if is_local else ():
        whole = os.path.abspath(one)
        path = os.path.normpath(os.path.join(whole, name))
        # The names alone come first: a file on another computer is not even asked for its links.
        if _is_in(path, whole) and _is_in(os.path.realpath(path), os.path.realpath(whole)):
            return path
    return ""


def _is_in(path: str, whole: str) -> bool:
    path, whole = os.path.normcase(path), os.path.normcase(whole)
    return path == whole or path.startswith(os.path.join(whole, ""))
