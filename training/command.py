"""The command that QGIS starts: executes the training of a job file and reports events as lines of JSON."""

from __future__ import annotations

import importlib.util
import sys
import time
from pathlib import Path

from ..core.errors import TrainingError
from ..core.events import report, reporting_errors
from .job import CHECKPOINT_JOB, read_job

NEEDED = ("torch", "torchvision", "segmentation_models_pytorch", "timm", "onnx", "onnxruntime", "cv2", "numpy")
"""Modules that training needs."""


def main(arguments: list[str]) -> int:
    """Execute the training of ``JOB.json``, or export the checkpoint of ``checkpoint JOB.json``; without an argument,
    check this Python. Return the exit status."""
    began = time.monotonic()
    return reporting_errors(lambda: _execute(arguments, began))


def _execute(arguments: list[str], began: float) -> None:
    require_packages()
    if not arguments:
        import torch

        device = torch.cuda.get_device_name() if torch.cuda.is_available() else "CPU"
        report("ready", torch=torch.__version__, device=device)
    elif arguments[0] == CHECKPOINT_JOB:
        from . import checkpoint

        checkpoint.run(Path(arguments[1]), report)
    else:
        from .train import run

        run(read_job(Path(arguments[0])), report, began)


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
