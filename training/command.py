"""The command that QGIS starts: trains as a job's file says, with a line of JSON on its output for whatever happens."""

from __future__ import annotations

import importlib.util
import json
import sys
import time
import traceback
from pathlib import Path

from ..core.errors import SemRefError, TrainingError
from ..core.sentences import english
from .job import read_job

NEEDED = ("torch", "torchvision", "segmentation_models_pytorch", "timm", "onnx", "onnxruntime", "cv2", "numpy")
"""Modules that training needs beside Python's own."""


def tell(event: str, **values: object) -> None:
    """One line of JSON."""
    print(json.dumps({"event": event, **values}), flush=True)


def main(arguments: list[str]) -> int:
    """``JOB.json``: trains. Without: tells whether this Python could. Returns the exit status."""
    began = time.monotonic()
    try:
        require_packages()
        if not arguments:
            import torch

            device = torch.cuda.get_device_name() if torch.cuda.is_available() else "CPU"
            tell("ready", torch=torch.__version__, device=device)
            return 0
        from .train import run

        run(read_job(Path(arguments[0])), tell, began)
    except SemRefError as error:
        sentence = error.sentence
        tell(
            "failed",
            template=sentence.template,
            values={k: _plain(v) for k, v in sentence.values},
            text=english(sentence),
        )
        return 1
    except Exception as error:  # told to QGIS, which reports it as a bug
        tell("broke", text=traceback.format_exc(), reason=str(error).partition("\n")[0])
        return 2
    return 0


def require_packages() -> None:
    """Raises TrainingError for the first that is missing."""
    lacking = [name for name in NEEDED if importlib.util.find_spec(name) is None]
    if lacking:
        raise TrainingError(
            "{python} lacks the Python package {package}; choose another Python, or have SemRef make one for training "
            "under Settings ▸ Options ▸ SemRef.",
            python=sys.executable,
            package=lacking[0],
        )


def _plain(value: object) -> object:
    """A sentence's value as JSON has it."""
    if isinstance(value, tuple):
        return [_plain(part) for part in value]
    return value if isinstance(value, (int, float)) else str(value)
