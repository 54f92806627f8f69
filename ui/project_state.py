"""State of the dock in the project file: read when a project is opened, written when it is saved."""

from __future__ import annotations

import os
from dataclasses import dataclass, field

from qgis.core import QgsProject, QgsSettings

from ..core.localization import Method
from ..core.named_files import is_elsewhere, named_file
from ..processing.inspection.models import resolve_model

SCOPE = "SemRef"
DATABASE_SETTING, MODEL_SETTING = "semref/dock/database", "semref/dock/model"

Prior = tuple[float, float, float, float, str]
"""Search circle: x, y of its center, x, y of a point on its edge, and the authid of their CRS."""

_LISTED_IMAGES = 1000
"""Limit that keeps project files small."""

_FARTHEST = 1e9
"""Largest coordinate that is accepted, in units of the CRS."""


@dataclass(frozen=True)
class DockState:
    """State of the dock that a project file stores.

    Attributes:
        database: Path; may be empty, as ``model`` and ``results``.
        model: Path of the model for photos.
        method: METHOD of semref:localizeimages.
        images: Files and folders.
        prior: Search circle; None for the whole database.
    """

    database: str = ""
    model: str = ""
    method: int = 0
    images: list[str] = field(default_factory=list)
    results: str = ""
    prior: Prior | None = None
    is_flight: bool = False


def write_state(project: QgsProject, state: DockState) -> None:
    """Write the state. Paths are relative or absolute, as the project is set up for its layers."""
    project.writeEntry(SCOPE, "/database", project.writePath(state.database))
    project.writeEntry(SCOPE, "/model", project.writePath(state.model))
    project.writeEntry(SCOPE, "/results", project.writePath(state.results))
    project.writeEntry(SCOPE, "/images", [project.writePath(path) for path in state.images[:_LISTED_IMAGES]])
    project.writeEntry(SCOPE, "/method", state.method)
    project.writeEntry(SCOPE, "/flight", state.is_flight)
    project.writeEntry(SCOPE, "/prior", [] if state.prior is None else [str(value) for value in state.prior])


def read_state(project: QgsProject) -> DockState | None:
    """Read the state; None for a project that was never saved with the dock."""
    database, known = project.readEntry(SCOPE, "/database")
    if not known:
        return None

    def path_of(key: str) -> str:
        return _local(project, project.readEntry(SCOPE, key)[0])

    method = project.readNumEntry(SCOPE, "/method")[0]
    return DockState(
        _local(project, database),
        resolve_model(path_of("/model")),
        method if 0 <= method < len(Method) else 0,
        [path for path in (_local(project, one) for one in project.readListEntry(SCOPE, "/images")[0]) if path],
        path_of("/results"),
        _prior_of(project.readListEntry(SCOPE, "/prior")[0]),
        project.readBoolEntry(SCOPE, "/flight", False)[0],
    )


def _local(project: QgsProject, written: str) -> str:
    """Return a path of the project; empty for one on another computer, unless the project is there as well."""
    path = project.readPath(written)
    return path if not is_elsewhere(path) or named_file(path, [project.absolutePath()]) else ""


def _prior_of(entries: list[str]) -> Prior | None:
    try:
        *numbers, authid = entries
        x, y, edge_x, edge_y = map(float, numbers)
    except ValueError:
        # Written by another version, or edited.
        return None
    if not all(abs(number) < _FARTHEST for number in (x, y, edge_x, edge_y)):
        return None
    return x, y, edge_x, edge_y, authid


def remembered_file(setting: str) -> str:
    """Return the file that the dock uses or used last in any session; empty if it does not exist.

    ``setting``: DATABASE_SETTING or MODEL_SETTING.
    """
    path = QgsSettings().value(setting, "", type=str)
    return path if os.path.isfile(path) else ""
