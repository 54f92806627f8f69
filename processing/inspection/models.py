"""Available models: those in the user's folder, and the one in the plugin."""

from __future__ import annotations

import os
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, Callable

from qgis.core import QgsApplication, QgsSettings

from ..base.shipped_models import PHOTO_MODEL, SHIPPED

if TYPE_CHECKING:
    from ...core.segmentation.model_card import ModelCard


MOST_LISTED = 200
"""Largest number of listed models of a folder, because reading them takes time."""

_SETTING = "semref/models_folder"


def models_folder() -> Path:
    """Return the user's folder of models, by default in the profile. It may not exist."""
    chosen = QgsSettings().value(_SETTING, "", type=str)
    return Path(chosen) if chosen else Path(QgsApplication.qgisSettingsDirPath()) / "semref" / "models"


def new_model_file(name: str) -> str:
    """Return a new file name in the user's folder of models, which is made; ``name`` without suffix."""
    folder = models_folder()
    folder.mkdir(parents=True, exist_ok=True)
    numbered = (f"{name}_{number}" if number > 1 else name for number in count(1))
    return str(next(folder / f"{one}.onnx" for one in numbered if not (folder / f"{one}.onnx").exists()))


def choose_models_folder(path: str) -> None:
    """Store the user's folder of models; empty for the profile's."""
    QgsSettings().setValue(_SETTING, path)


def listed_models(folder: Path) -> list[ModelCard]:
    """Return the cards of the models in a folder and its subfolders, by name, then of the plugin's."""
    from ...core.segmentation.model_card import read_card

    return [read_card(str(path)) for path in model_files(folder)]


def base_model(chosen: str, here: set[str], class_names: Callable[[], set[str]]) -> str:
    """Return a base model for “Train model”: the selected one, the folder's only one that fits, or the plugin's.

    Empty if none fits.

    Args:
        chosen: Path of the dock's model; may be empty.
        here: Names of the ground: its models have been trained on the ground that is set aside to test the new one.
        class_names: Returns the classes that it must have, in small letters; called only if there is a model.
    """
    from ...core.segmentation.model_card import read_card

    files = [chosen, *(str(path) for path in model_files(models_folder()))]
    own = [path for path in dict.fromkeys(files) if path and Path(path).parent != SHIPPED]
    own += [str(PHOTO_MODEL)] if PHOTO_MODEL.is_file() else []
    cards = [card for card in map(read_card, own) if card.can_be_base]
    cards = [card for card in cards if not here & {ground.place for ground in card.trained_on}]
    wanted = class_names() if cards else set()
    fitting = [card.file for card in cards if wanted and wanted <= {name.casefold() for name in card.classes}]
    if chosen in fitting:
        return chosen
    users = [file for file in fitting if file != str(PHOTO_MODEL)]
    return users[0] if len(users) == 1 else next((file for file in fitting if file not in users), "")


def resolve_model(path: str) -> str:
    """Return a model's path; for the model of another installation of the plugin, the path in this one.

    A project stores the path of its model, but in another profile or computer the plugin has another path.
    """
    model = Path(path)
    here = SHIPPED / model.name
    is_shipped = model.parts[-4:] == here.parts[-4:] and not os.path.isfile(path)
    return str(here) if is_shipped and here.is_file() else path


def model_files(folder: Path) -> list[Path]:
    """Return the models in a folder and its subfolders, by name, then the plugin's."""
    # Not Path.is_dir, which raises without permission.
    own = sorted({*folder.glob("*.onnx"), *folder.glob("*/*.onnx")}) if os.path.isdir(folder) else []
    found = (*own[:MOST_LISTED], *sorted(SHIPPED.glob("*.onnx")))
    # List each file once, with its shortest path: a folder may contain a link to itself.
    by_file = {os.path.realpath(path): path for path in sorted(found, key=lambda path: len(path.parts), reverse=True)}
    return [path for path in found if by_file[os.path.realpath(path)] is path]
