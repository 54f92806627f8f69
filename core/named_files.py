"""Names of files inside other files: SemRef follows them only inside folders that the user chose."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable

_NO_LOCAL_PATH = re.compile(r"//|/vsi|<|\{|[a-z][\w+.-]+:", re.IGNORECASE)


def is_elsewhere(path: str) -> bool:
    r"""Return whether a path is not that of a local file.

    Examples are UNC paths, URLs, and paths that GDAL opens as a virtual file, a connection or a description.

    >>> [is_elsewhere(path) for path in (r"\\host\share\a.tif", "/vsicurl/http://host/a.tif", r"C:\maps\a.tif")]
    [True, True, False]
    """
    return _NO_LOCAL_PATH.match(path.strip().replace("\\", "/")) is not None


def named_file(name: str, chosen: Iterable[str]) -> str:
    """Return the path of a file that another file names; empty if the user did not choose it.

    Args:
        name: The name in the other file, absolute or relative to a chosen folder.
        chosen: Files and folders; a folder includes everything in it. Nothing outside them is accessed.
    """
    is_local = "\0" not in name and (os.path.isabs(name) or not is_elsewhere(name))
    for one in chosen if is_local else ():
        whole = os.path.abspath(one)
        path = os.path.normpath(os.path.join(whole, name))
        # Names are compared first, so that links of a file on another computer are not even resolved.
        if _is_in(path, whole) and _is_in(os.path.realpath(path), os.path.realpath(whole)):
            return path
    return ""


def _is_in(path: str, whole: str) -> bool:
    path, whole = os.path.normcase(path), os.path.normcase(whole)
    return path == whole or path.startswith(os.path.join(whole, ""))
