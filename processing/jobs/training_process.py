"""The training process: a Python with torch beside QGIS that reports its progress as lines of JSON."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import closing

from qgis.core import QgsProcessingFeedback
from qgis.PyQt.QtCore import QProcess

from ...core.errors import TrainingError
from ..base.event_process import PROGRAM, EventProcess, failure, python_environment
from ..translation import tr

_QGIS_OWN = ("PYTHONHOME", "PYTHONPATH", "PYTHONSTARTUP")
"""Variables that lead QGIS's own Python, and would mislead another one."""


def require_training(python: str, feedback: QgsProcessingFeedback) -> dict:
    """Start a Python and return what it reports (torch, device). Raises TrainingError if it cannot train."""
    answer: dict = {}
    for event in training_events(python, [], feedback):
        answer = event if event["event"] == "ready" else answer
    if not answer:
        raise TrainingError(
            "{python} is not a Python with torch. Select another Python of a training environment.", python=python
        )
    return answer


def training_events(python: str, arguments: list[str], feedback: QgsProcessingFeedback) -> Iterator[dict]:
    """Run the training and yield its events; a cancel ends it and all its processes at once.

    Raises:
        TrainingError: It cannot be started, reports an error, or ends without a message although it has ``arguments``.
    """
    process = QProcess()
    environment = python_environment()
    for name in _QGIS_OWN:
        environment.remove(name)
    process.setProcessEnvironment(environment)
    process.start(python, [str(PROGRAM), "training.command", *arguments])
    if not process.waitForStarted():
        raise TrainingError(
            "{python} cannot be started ({reason}). Select another Python of a training environment.",
            python=python,
            reason=process.errorString(),
        )
    reports = EventProcess(process)
    try:
        with closing(reports.read(feedback)) as events:
            for event in events:
                _require_no_failure(event, feedback)
                yield event
    finally:
        reports.end()
    if process.exitStatus() == QProcess.ExitStatus.CrashExit or process.exitCode() != 0:
        reason = reports.reason or process.errorString()
        if arguments:
            raise ended_silently(python, reason)
        feedback.pushDebugInfo(reason)


def ended_silently(python: str, reason: object) -> TrainingError:
    """Return the error of a training that wrote neither a result nor a message."""
    return TrainingError(
        "The training ended without a message ({reason}). Check whether the memory is full, or select another Python "
        "than {python}.",
        python=python,
        reason=reason,
    )


def _require_no_failure(event: dict, feedback: QgsProcessingFeedback) -> None:
    if event["event"] == "failed":
        raise TrainingError(failure(event))
    if event["event"] == "broke":
        feedback.pushDebugInfo(event["text"])
        raise TrainingError(
            "An error stopped the training: {reason}. Please report it with the messages of the log.",
            reason=event["reason"].rstrip("."),
        )


def run_training(python: str, arguments: list[str], feedback: QgsProcessingFeedback, first: float, last: float) -> None:
    """Run a training and show its events, with progress from ``first`` to ``last`` %. Raises as ``training_events``."""
    resumed_at = 0.0
    with closing(training_events(python, arguments, feedback)) as events:
        for event in events:
            if event["event"] == "resumed":
                # The share of an earlier run does not affect the remaining time of this one.
                resumed_at = min(max(event["share"], 0.0), 0.99)
            if event["event"] in ("resumed", "step", "epoch", "exporting"):
                share = (event["share"] - resumed_at) / (1 - resumed_at)
                feedback.setProgress(first + (last - first) * share)
            _show(event, feedback)


def _show(event: dict, feedback: QgsProcessingFeedback) -> None:
    kind = event["event"]
    if kind == "begun":
        text = tr(
            "Training {weights} weights on {device}: {training} tiles for training, {validation} tiles for validation"
        )
        known = {key: event[key] for key in ("device", "training", "validation")}
        feedback.pushInfo(text.format(weights=f"{event['weights']:,}", **known))
    elif kind == "resumed":
        feedback.pushInfo(tr("Continuing after epoch {epoch} of a canceled run.").format(epoch=event["epoch"]))
    elif kind == "step":
        text = tr("Epoch {epoch}, loss {loss:.3f}")
        feedback.setProgressText(text.format(epoch=event["epoch"], loss=event["loss"]))
    elif kind == "epoch":
        classes = ((key[4:], value) for key, value in event.items() if key.startswith("iou_"))
        shown = ", ".join(f"{name} {100 * value:.0f} %" for name, value in classes if isinstance(value, float))
        known = {"epoch": event["epoch"], "loss": event["training_loss"], "iou": event["mean_iou"]}
        text = tr("Epoch {epoch}: loss {loss:.3f}, mean IoU {iou:.1%} ({classes})")
        if not shown:
            text = tr("Epoch {epoch}, loss {loss:.3f}")
        feedback.pushInfo(text.format(classes=shown, **known))
    elif kind == "exporting":
        feedback.setProgressText(tr("Writing and checking the model"))
