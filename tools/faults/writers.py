"""Each writer tried without faults: what its older and its new outputs are, and when it can be hit."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Container, Iterator
from pathlib import Path
from typing import Any

from . import cases, children
from .cases import VARIANTS, Writer
from .content import State, state

_NEVER_REPLACED = {
    "localizeimages": ("LABELS",),
    "localizeflight": ("LABELS",),
    "exporttrainingtiles": ("OUTPUT",),
    "georeferenceimages": ("OUTPUT",),
}
"""Folders that are not written over older ones."""


def runner(provider: Any) -> Callable[..., Any]:
    """``run(algorithm, parameters, feedback=None)``, as Processing runs it; raises QgsProcessingException."""
    from qgis.core import QgsProcessingContext, QgsProcessingException, QgsProcessingFeedback

    algorithms = {algorithm.name(): algorithm for algorithm in provider.algorithms()}

    def run(name: str, parameters: dict[str, Any], feedback: Any = None) -> dict[str, Any]:
        context, algorithm = QgsProcessingContext(), algorithms[name].create()
        possible, reason = algorithm.checkParameterValues(parameters, context)
        if not possible:
            raise QgsProcessingException(reason)
        feedback = feedback or QgsProcessingFeedback(False)
        results, succeeded = algorithm.run(parameters, context, feedback, {}, False)
        if not succeeded:
            raise QgsProcessingException(feedback.textLog())
        return results

    return run


def make_quick() -> None:
    """One thread: children share two cores, and threads don't survive a fork."""
    import cv2

    cv2.setNumThreads(1)


def lay_out(writer: Writer, folder: Path, with_older: bool = True) -> None:
    """Makes the folder of the outputs anew."""
    shutil.rmtree(folder, ignore_errors=True)
    if with_older or " in place" in writer.name:
        shutil.copytree(writer.before, folder)
    else:
        folder.mkdir(parents=True)


def tried_writers(
    provider: Any,
    folder: Path,
    wanted: list[str],
    failed: Callable[[str], None] | None = None,
    known: Container[str] = (),
) -> Iterator[Writer]:
    """Each writer with what it writes.

    Args:
        provider: Whose algorithms are meant.
        folder: An empty one to work in.
        wanted: Writers by name, all when empty.
        failed: Is told what is wrong with a writer that is left out.
        known: Writers that are left out.

    Raises:
        KeyError: A writer has no inputs in ``cases``.
        RuntimeError: Without ``failed``: a writer fails without any fault, or writes something else each time.
    """
    run, inputs = runner(provider), folder / "inputs"
    for variant in VARIANTS:
        cases.make_inputs(inputs / variant, run)
    for name, (algorithm, parameters) in cases.all_parameters(provider, inputs).items():
        if name not in known and (not wanted or name in wanted):
            is_model = "Model" in type(provider.algorithm(algorithm)).__name__
            try:
                writer = _tried(name, not is_model, folder, _run_of(run, algorithm, parameters))
            except RuntimeError as error:
                if failed is None:
                    raise
                failed(str(error))
            else:
                yield writer


def _run_of(run: Callable[..., Any], algorithm: str, parameters: Callable[..., dict[str, Any]]) -> Callable[..., Any]:
    def run_variant(variant: str, folder: Path, feedback: Any = None) -> None:
        run(algorithm, parameters(variant, folder), feedback)

    return run_variant


def _tried(name: str, is_one_run: bool, folder: Path, run: Callable[..., Any]) -> Writer:
    # As deep as each other: a set of databases tells paths from its folder on.
    before, out = folder / f"before {name}", folder / "out"
    before.mkdir()
    if " in place" in name:
        shutil.copy(folder / "inputs" / "old" / "area.gpkg", before / "area.gpkg")
    else:
        _require_done(name, children.run(lambda: run("old", before), before))
    second = state(before)
    for kept in _NEVER_REPLACED.get(name, ()):
        shutil.rmtree(before / kept)
    sound: list[State] = []
    for _ in range(2):
        shutil.rmtree(out, ignore_errors=True)
        shutil.copytree(before, out)
        ending = children.run(lambda: _steps_of(run, out), out)
        _require_done(name, ending)
        sound.append(state(out))
    old = state(before)
    if sound[0] != sound[1]:
        differing = [path for path in sound[0] if sound[0][path] != sound[1].get(path)]
        raise RuntimeError(f"{name} writes something else each time: {differing}")
    same = [path for path in old if old[path] == sound[0].get(path)]
    if old and len(same) == len(old):
        raise RuntimeError(f"{name}: older and new outputs are the same")
    sizes = [path.stat().st_size for path in out.rglob("*") if path.is_file()]
    # Seconds of the second time: the first loads modules.
    told = ending.told, ending.touches, ending.seconds[1], max(sizes), sum(sizes)
    return Writer(name, is_one_run, run, before, old, sound[0], sound[0] if " in place" in name else second, *told)


def _steps_of(run: Callable[..., Any], out: Path) -> int:
    from qgis.core import QgsProcessingFeedback

    feedback, count = QgsProcessingFeedback(False), [0]
    feedback.progressChanged.connect(lambda _: count.__setitem__(0, count[0] + 1))
    run("new", out, feedback)
    return count[0]


def _require_done(name: str, ending: children.Ending) -> None:
    if ending.how != "done":
        raise RuntimeError(f"{name} without a fault: {ending.how}: {ending.text}")
