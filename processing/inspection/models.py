"""The models that are at hand: those of the user's folder, and the one that ships."""

from __future__ import annotations

import os
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, Callable

from qgis.core import QgsApplication, QgsSettings

if TYPE_CHECKING:
    from ...core.segmentation.model_card import ModelCard

SHIPPED = Path(__file__).resolve().parents[2] / "models"

MOST_LISTED = 200
"""Models of a folder that are listed: reading them takes time, and nobody chooses from more."""

_SETTING = "semref/models_folder"


def models_folder() -> Path:
    """Where the user keeps models; one of the profile's unless another was chosen. It may not be there."""
    chosen = QgsSettings().value(_SETTING, "", type=str)
    return Path(chosen) if chosen else Path(QgsApplication.qgisSettingsDirPath()) / "semref" / "models"


def new_model_file(name: str) -> str:
    """A file of the user's folder of models, which is made, that does not exist yet; ``name`` without suffix."""
    folder = models_folder()
    folder.mkdir(parents=True, exist_ok=True)
    numbered = (f"{name}_{number}" if number > 1 else name for number in count(1))
    return str(next(folder / f"{one}.onnx" for one in numbered if not (folder / f"{one}.onnx").exists()))


def choose_models_folder(path: str) -> None:
    """Keeps where the user's models are; nothing for the profile's."""
    QgsSettings().setValue(_SETTING, path)


def listed_models(folder: Path) -> list[ModelCard]:
    """The cards of the models in a folder and in those just below it, by name, then of the one that ships."""
    from ...core.segmentation.model_card import read_card

    return [read_card(str(path)) for path in model_files(folder)]


def base_model(chosen: str, here: set[str], class_names: Callable[[], set[str]]) -> str:
    """A model that “Train model” can go on from: the chosen one, else the folder's only one that fits; empty for none.

    Args:
        chosen: Path of the dock's model; may be empty.
        here: Names of the ground: a model of it has seen what is set aside to tell how good the new one is.
        class_names: Gives the classes that it has to know, in small letters; asked where there is a model.
    """
    from ...core.segmentation.model_card import read_card

    files = [chosen, *(str(path) for path in model_files(models_folder()))]
    own = [path for path in dict.fromkeys(files) if path and Path(path).parent != SHIPPED]
    cards = [card for card in map(read_card, own) if card.can_be_base]
    cards = [card for card in cards if not here & {ground.place for ground in card.trained_on}]
    wanted = class_names() if cards else set()
    fitting = [card.file for card in cards if wanted and wanted <= {name.casefold() for name in card.classes}]
    return chosen if chosen in fitting else fitting[0] if len(fitting) == 1 else ""


def resolve_model(path: str) -> str:
    """A model's path; for one that ships with another installation of the plugin, the path in this one.

    A project keeps where its model lay: in another profile, or on another machine, the plugin lies elsewhere.
    """
    model = Path(path)
    here = SHIPPED / model.name
    is_shipped = model.parts[-4:] == here.parts[-4:] and not os.path.isfile(path)
    return str(here) if is_shipped and here.is_file() else path


def model_files(folder: Path) -> list[Path]:
    """The models in a folder and in those just below it, by name, then the one that ships."""
    # Not Path.is_dir, which raises where the folder may not be looked at.
    own = sorted({*folder.glob("*.onnx"), *folder.glob("*/*.onnx")}) if os.path.isdir(folder) else []
    found = (*own[:MOST_LISTED], *sorted(SHIPPED.glob("*.onnx")))
    # Each file once: a folder may be a link to the one that it lies in. The shortest path is it.
    by_file = {os.path.realpath(path): path for path in sorted(found, key=lambda path: len(path.parts), reverse=True)}
    return [path for path in found if by_file[os.path.realpath(path)] is path]
