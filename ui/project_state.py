"""What the dock keeps in the project: read when one is opened, written when it is saved."""

from __future__ import annotations

from dataclasses import dataclass, field

from qgis.core import QgsProject, QgsSettings

from ..core.named_files import is_elsewhere, named_file
from ..processing.inspection.models import at_hand

SCOPE = "SemRef"
DATABASE_SETTING, MODEL_SETTING = "semref/dock/database", "semref/dock/model"

Prior = tuple[float, float, float, float, str]
"""x, y of the middle, x, y of the edge, and the authid of their CRS."""

_LISTED_IMAGES = 1000
"""A project is no place for the names of more."""

_METHODS = 4
"""METHOD has so many options."""

_FARTHEST = 1e9
"""Map units from the origin."""


@dataclass(frozen=True)
class DockState:
    """What a project keeps.

    Attributes:
        database: Path, perhaps empty, as are ``model`` and ``results``.
        model: Of the network for photos.
        method: METHOD of semref:localizeimages.
        images: Files and folders.
        opacity: Of the labels, percent.
        results: The GeoPackage that holds them.
        prior: The circle to search; None for the whole database.
        is_flight: The images are of one flight.
    """

    database: str = ""
    model: str = ""
    method: int = 0
    images: list[str] = field(default_factory=list)
    opacity: int = 60
    results: str = ""
    prior: Prior | None = None
    is_flight: bool = False


def write_state(project: QgsProject, state: DockState) -> None:
    """Paths are kept as the project keeps those of its layers: relative to its file, unless it says otherwise."""
    project.writeEntry(SCOPE, "/database", project.writePath(state.database))
    project.writeEntry(SCOPE, "/model", project.writePath(state.model))
    project.writeEntry(SCOPE, "/results", project.writePath(state.results))
    project.writeEntry(SCOPE, "/images", [project.writePath(path) for path in state.images[:_LISTED_IMAGES]])
    project.writeEntry(SCOPE, "/method", state.method)
    project.writeEntry(SCOPE, "/opacity", state.opacity)
    project.writeEntry(SCOPE, "/flight", state.is_flight)
    project.writeEntry(SCOPE, "/prior", [] if state.prior is None else [str(value) for value in state.prior])


def read_state(project: QgsProject) -> DockState | None:
    """None of a project that was never saved with the dock."""
    database, known = project.readEntry(SCOPE, "/database")
    if not known:
        return None

    def path_of(key: str) -> str:
        return _local(project, project.readEntry(SCOPE, key)[0])

    method = project.readNumEntry(SCOPE, "/method")[0]
    return DockState(
        _local(project, database),
        at_hand(path_of("/model")),
        method if 0 <= method < _METHODS else 0,
        [path for path in (_local(project, one) for one in project.readListEntry(SCOPE, "/images")[0]) if path],
        min(max(project.readNumEntry(SCOPE, "/opacity", 60)[0], 0), 100),
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
        # Another version's, or somebody's own.
        return None
    if not all(abs(number) < _FARTHEST for number in (x, y, edge_x, edge_y)):
        return None
    return x, y, edge_x, edge_y, authid


def remembered_database() -> str:
    """The path chosen last, in any session; empty where none ever was."""
    return QgsSettings().value(DATABASE_SETTING, "", type=str)
