"""The command that QGIS starts: executes the training of a job file and reports events as lines of JSON."""

from __future__ import annotations

import importlib.util
import json
import sys
import time
import traceback
from pathlib import Path

from ..core.errors import SemRefError, TrainingError
from ..core.sentences import english
from .job import CHECKPOINT_JOB, read_job

NEEDED = ("torch", "torchvision", "segmentation_models_pytorch", "timm", "onnx", "onnxruntime", "cv2", "numpy")
"""Modules that training needs."""


def report(event: str, **values: object) -> None:
    """Print an event as a line of JSON."""
    print(json.dumps({"event": event, **values}), flush=True)


def main(arguments: list[str]) -> int:
    """Execute the training of ``JOB.json``, or export the checkpoint of ``checkpoint JOB.json``; without an argument,
    check this Python. Return the exit status."""
    began = time.monotonic()
    try:
        require_packages()
        if not arguments:
            import torch

            device = torch.cuda.get_device_name() if torch.cuda.is_available() else "CPU"
            report("ready", torch=torch.__version__, device=device)
            return 0
        if arguments[0] == CHECKPOINT_JOB:
            from . import checkpoint

            checkpoint.run(Path(arguments[1]), report)
            return 0
        from .train import run

        run(read_job(Path(arguments[0])), report, began)
    except SemRefError as error:
        sentence = error.sentence
        report(
            "failed",
            template=sentence.template,
            values={k: _plain(v) for k, v in sentence.values},
            text=english(sentence),
        )
        return 1
    except Exception as error:  # QGIS reports it as a bug
        report("broke", text=traceback.format_exc(), reason=str(error).partition("\n")[0])
        return 2
    return 0


def require_packages() -> None:
    """Raise TrainingError for the first missing module."""
    lacking = [name for name in NEEDED if importlib.util.find_spec(name) is None]
    if lacking:
        raise TrainingError(
            "{python} lacks the Python package {package}. Choose another Python, or let SemRef make a training "
            "environment under Settings ▸ Options ▸ SemRef.",
            python=sys.executable,
            package=lacking[0],
        )


def _plain(value: object) -> object:
    """Return a value of a sentence for JSON."""
    if isinstance(value, tuple):
        return [_plain(part) for part in value]
    return value if isinstance(value, (int, float)) else str(value)
