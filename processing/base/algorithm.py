"""Base of all algorithms: groups, help, errors, cancel, and the check for Python packages."""

from __future__ import annotations

import contextlib
import errno
import re
import sys
from collections import deque
from collections.abc import Iterable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor, wait
from html import escape
from itertools import islice
from pathlib import Path
from traceback import clear_frames
from types import FrameType, MappingProxyType
from typing import Any, Callable, ClassVar, TypeVar, Union

from qgis.core import (
    QgsApplication,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeedback,
    QgsProcessingOutputDefinition,
    QgsProcessingOutputFile,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFileDestination,
)
from qgis.PyQt.QtCore import QCoreApplication, QTimer
from qgis.PyQt.QtGui import QIcon

from ...core.errors import ParameterError, SemRefError
from ...core.steps import Steps, advance
from ..layers.layer_metadata import Note, note_of_run
from ..messages.sentences import worded
from ..packages.components import NEEDED, Package, require
from ..threads import worker_threads
from ..translation import tr
from ..version import algorithm_help_url, plugin_version
from . import parameters as keys
from .destinations import is_batch, require_outputs_apart, require_rows_apart
from .outputs import Outputs
from .values import Values

Declared = Union[QgsProcessingParameterDefinition, QgsProcessingOutputDefinition]
Result = TypeVar("Result")
Item = TypeVar("Item")

ICON_PATH = Path(__file__).resolve().parents[2] / "resources" / "icon.svg"

ANNOTATION, REFERENCE_DATABASE, LOCALIZATION = "annotation", "referencedatabase", "localization"

REPORTS_AS_FILES = "reports_as_files"
"""Configuration of an algorithm whose reports are shown by its caller, not by QGIS's Results Viewer."""

CANCEL_EVERY_S = 0.2
"""Seconds between checks for a cancel during work that cannot be interrupted."""

AT_ONCE = 4
"""Images that are processed at a time: a network labels the next ones while one is localized. More are not faster."""

CHECK_EVERY = 256
"""Features between two checks for a cancel."""


class Canceled(Exception):
    """The user canceled; nothing was written."""

    def message(self) -> str:
        return tr("Canceled. Nothing was written.")


class WithIcon:
    """What has the icon of SemRef in the toolbox."""

    def icon(self) -> QIcon:
        return QIcon(str(ICON_PATH))

    def svgIconPath(self) -> str:
        return str(ICON_PATH)


class SemRefAlgorithm(WithIcon, QgsProcessingAlgorithm):
    """Base of the algorithms. A subclass defines ID, TITLE, GROUP, TAGS, SUMMARY, parameters and work.

    It translates its title and summary, and the titles and helps of its parameters and outputs.
    """

    DATABASE, MODEL, LABELS, IMAGES = keys.DATABASE, keys.MODEL, keys.LABELS, keys.IMAGES
    INPUT, CLASS_FIELD, CLASS_TABLE = keys.INPUT, keys.CLASS_FIELD, keys.CLASS_TABLE
    EXTENT, MASK, RESOLUTION, PYTHON = keys.EXTENT, keys.MASK, keys.RESOLUTION, keys.PYTHON
    REFERENCE_CLASSES, VALIDATION_FRACTION = keys.REFERENCE_CLASSES, keys.VALIDATION_FRACTION
    REPORT, MINIMUM_AREA, OUTPUT = keys.REPORT, "MINIMUM_AREA", "OUTPUT"
    """Keys of parameters that several algorithms have."""

    ID = ""
    TITLE = ""
    GROUP = ""
    TAGS: tuple[str, ...] = ()
    SUMMARY = ""
    """One to three paragraphs of help; each parameter has its own help."""
    PACKAGES: tuple[Package, ...] = NEEDED
    """Required Python packages beside those of QGIS."""
    MAY_REPLACE: ClassVar[Mapping[str, str]] = MappingProxyType({})
    """Outputs that may replace the file of an input, by key: the input is read completely before."""

    _refusal: SemRefError | None = None
    _note = Note()
    _reports_as_files = False

    def parameters(self) -> tuple[Declared, ...]:
        """Return inputs, outputs and result numbers in the order of the dialog, in English."""
        raise NotImplementedError

    def check(self, values: Values) -> None:
        """Raises SemRefError for values that do not fit together, before any work."""

    def read_layers(self, values: Values) -> None:
        """Read what is needed from layers, in the main thread. Raises SemRefError."""

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, Any] | None:
        """Do the work and write ``outputs``. Raises Canceled, and SemRefError for what the user can correct.

        Returns:
            The result numbers, by key.
        """
        raise NotImplementedError

    # --- QgsProcessingAlgorithm ---

    def createInstance(self) -> SemRefAlgorithm:
        made = type(self)()
        made._reports_as_files = self._reports_as_files
        return made

    def initAlgorithm(self, config: dict[str, Any] | None = None) -> None:
        self._reports_as_files = self._reports_as_files or REPORTS_AS_FILES in (config or {})
        for declared in self.parameters():
            declared.setDescription(tr(declared.description()))
            if isinstance(declared, QgsProcessingParameterDefinition):
                declared.setHelp(tr(declared.help()))
            if isinstance(declared, QgsProcessingOutputDefinition):
                self.addOutput(declared)
            elif self._reports_as_files and _is_page(declared):
                self.addOutput(QgsProcessingOutputFile(declared.name(), declared.description()))
                self.addParameter(declared, False)
            else:
                self.addParameter(declared)

    def name(self) -> str:
        return self.ID

    def displayName(self) -> str:
        return tr(self.TITLE)

    def groupId(self) -> str:
        return self.GROUP

    def group(self) -> str:
        return group_title(self.GROUP)

    def tags(self) -> list[str]:
        return [*self.TAGS, "semref"]

    def shortDescription(self) -> str:
        return tr(self.SUMMARY).split("\n\n")[0]

    def shortHelpString(self) -> str:
        """Return the help of dialogs as HTML; for qgis_process, plain text without what it prints itself."""
        summary = tr(self.SUMMARY)
        if prints_help():
            return summary.partition("\n\n")[2] or summary
        paragraphs = "".join(f"<p>{escape(paragraph, False)}</p>" for paragraph in summary.split("\n\n"))
        entries = [(p.description(), escape(p.help(), False)) for p in self.parameterDefinitions() if p.help()]
        return paragraphs + "".join(f"<h3>{title}</h3><p>{text}</p>" for title, text in entries)

    def helpUrl(self) -> str:
        return algorithm_help_url(self.ID)

    def canExecute(self) -> tuple[bool, str]:
        try:
            require(self.PACKAGES)
        except SemRefError as error:
            return False, worded(error)
        return True, ""

    def checkParameterValues(self, parameters: dict[str, Any], context: QgsProcessingContext) -> tuple[bool, str]:
        try:
            self._checked(parameters, context)
        except SemRefError as error:
            return False, worded(error)
        return True, ""

    def prepareAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> bool:
        self._refusal = None
        try:
            # QGIS's batches and models do not call checkParameterValues.
            values = self._checked(parameters, context)
            require_rows_apart(self, parameters, context, self.MAY_REPLACE, feedback)
            self.read_layers(values)
            self._note = note_of_run(self, parameters, context, plugin_version())
        except SemRefError as error:
            # Raised by processAlgorithm: QGIS does not pass errors of prepareAlgorithm to Python callers.
            self._refusal = error
        return True

    def _checked(self, parameters: dict[str, Any], context: QgsProcessingContext) -> Values:
        """Return the values of a run. Raises SemRefError for values that cannot be used."""
        values = Values(self, parameters, context)
        require(self.PACKAGES)
        values.require_texts()
        # Before QGIS opens the layers to check them.
        for definition in self.parameterDefinitions():
            if definition.type() == "raster":
                values.require_pictures(definition.name())
        for definition in self.parameterDefinitions():
            if values.has(definition.name()):
                _READ.get(definition.type(), lambda *_: None)(values, definition.name())
        possible, reason = super().checkParameterValues(parameters, context)
        if not possible:
            raise ParameterError("{reason}", reason=self._with_title(reason, parameters))
        require_outputs_apart(self, parameters, context, self.MAY_REPLACE)
        self.check(values)
        return values

    def _with_title(self, reason: str, parameters: dict[str, Any]) -> str:
        """Return a reason of QGIS with the title of the parameter that it names by its key, and with its value."""
        for definition in self.parameterDefinitions():
            key, title = rf"(?<!\S){definition.name()}(?=[:\s]|$)", f"“{definition.description()}”"
            reason, count = re.subn(key, lambda _, title=title: title, reason, count=1)
            if count:
                given = parameters.get(definition.name())
                is_short = isinstance(given, (str, int, float)) and given != ""
                return f"{reason}: {given}" if is_short and str(given) not in reason else reason
        return reason

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        try:
            return self._run(parameters, context, feedback)
        except (SemRefError, Canceled, OSError, QgsProcessingException) as error:
            message = _sentence(error)
            clear_frames(error.__traceback__)
        # QGIS never frees an exception from here, nor the variables of its frames: layers that outlive QGIS crash it.
        del self, parameters, context, feedback
        caller = sys._getframe().f_back
        if caller is not None and caller.f_code.co_filename.endswith(_BATCH):
            _clear_when_ended(caller)
        del caller
        raise QgsProcessingException(message)

    def _run(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        if self._refusal is not None:
            raise self._refusal
        values = Values(self, parameters, context)
        with Outputs(values, self._note) as outputs:
            numbers = self.work(values, outputs, feedback)
            outputs.commit()
        # A script that QGIS exports from a model reads each output of a step, also one that was not selected.
        nothing = dict.fromkeys(output.name() for output in self.destinationParameterDefinitions())
        return {**nothing, **outputs.results, **(numbers or {})}


_READ = {"number": Values.number, "distance": Values.number, "range": Values.range}
"""Readers of numbers by type of parameter: they refuse other values before any work."""


_BATCH = "BatchAlgorithmDialog.py"
"""A failed batch of QGIS 3.22 keeps its task in the frame of this file; QGIS does not close before the task ends."""


def _clear_when_ended(frame: FrameType) -> None:
    """Free the variables of a frame as soon as it has ended."""
    try:
        frame.clear()
    except RuntimeError:
        QTimer.singleShot(1000, lambda: _clear_when_ended(frame))


def _is_page(parameter: QgsProcessingParameterDefinition) -> bool:
    """Return whether QGIS shows the output in its Results Viewer; QGIS checks the file filter, too."""
    return isinstance(parameter, QgsProcessingParameterFileDestination) and "*.htm" in parameter.fileFilter()


def prints_help() -> bool:
    """Return whether help goes to a terminal: qgis_process prints the short description, HTML raw, and parameters."""
    return QgsApplication.platform() == "qgis_process"


def group_title(group: str) -> str:
    """Return the title of a group of algorithms in the user's language."""
    return {
        ANNOTATION: tr("Land cover"),
        REFERENCE_DATABASE: tr("Reference database"),
        LOCALIZATION: tr("Localization"),
    }[group]


_DISK_ERRORS = (errno.ENOSPC, errno.EDQUOT, errno.EROFS, errno.EACCES, errno.EPERM, errno.EFBIG, errno.ENAMETOOLONG)


def _sentence(error: SemRefError | Canceled | OSError | QgsProcessingException) -> str:
    """Return the text of an error in the user's language; raise it if it is a defect of the program."""
    if isinstance(error, SemRefError):
        return worded(error)
    if isinstance(error, Canceled):
        return error.message()
    if isinstance(error, QgsProcessingException):
        return str(error)
    if error.errno not in _DISK_ERRORS:
        raise error
    name = error.filename or tr("the output")
    if error.errno in (errno.ENOSPC, errno.EDQUOT, errno.EFBIG):
        return tr("The disk is full: {name} cannot be written. Free some space, or choose another folder.").format(
            name=name
        )
    return tr("You have no permission to write {name}. Choose another folder.").format(name=name)


def check_canceled(feedback: QgsProcessingFeedback) -> None:
    if feedback.isCanceled():
        raise Canceled


def each(items: Iterable[Item], feedback: QgsProcessingFeedback, total: int = 0, last: float = 100.0) -> Iterator[Item]:
    """Yield the items; check for a cancel at times and, of a ``total``, show progress up to ``last`` %."""
    for n, item in enumerate(items):
        if n % CHECK_EVERY == 0:
            check_canceled(feedback)
            if total > 0:
                feedback.setProgress(min(last * n / total, last))
        yield item


def cancelable(function: Callable[..., Result], *arguments: Any, feedback: QgsProcessingFeedback) -> Result:
    """Run a function in its own thread and return its result; a cancel takes effect at once."""
    pool = ThreadPoolExecutor(1)
    try:
        running, is_running = pool.submit(function, *arguments), True
        while is_running:
            is_running = bool(wait([running], timeout=CANCEL_EVERY_S).not_done)
            if is_batch(feedback):
                # Otherwise the window would not react to “Cancel”, and show messages of the function after later ones.
                QCoreApplication.processEvents()
            # A function that checks for the cancel itself ends early.
            check_canceled(feedback)
        return running.result()
    finally:
        pool.shutdown(wait=False)


def ahead(
    function: Callable[[Item], Result], items: Iterable[Item], feedback: QgsProcessingFeedback
) -> Iterator[Result]:
    """Yield a function's results for the items, in order; threads process the next items meanwhile.

    A cancel takes effect at once, as in ``cancelable``.
    """
    left, pool = iter(items), ThreadPoolExecutor(min(AT_ONCE, worker_threads()))
    begun = deque(pool.submit(function, item) for item in islice(left, AT_ONCE))
    try:
        while begun:
            result = cancelable(begun.popleft().result, feedback=feedback)
            begun.extend(pool.submit(function, item) for item in islice(left, 1))
            yield result
    finally:
        for future in begun:
            future.cancel()
        pool.shutdown(wait=False)


def interruptible(steps: Steps[Result], feedback: QgsProcessingFeedback) -> Steps[Result]:
    """Run each step in its own thread, so that a cancel takes effect during a long step."""
    while True:
        step, found = cancelable(advance, steps, feedback=feedback)
        if step is None:
            return found
        yield step


def follow(steps: Steps[Result], feedback: QgsProcessingFeedback, first: float = 0.0, last: float = 100.0) -> Result:
    """Run steps, show progress from first to last %, and return their result. Raises Canceled.

    The steps are always closed: their files and threads are released before anything is removed.
    """
    shown = None
    with contextlib.closing(steps):
        while True:
            step, found = advance(steps)
            if step is None:
                return found
            what, share = step
            check_canceled(feedback)
            if what != shown:
                feedback.setProgressText(tr(what))
                shown = what
            feedback.setProgress(first + (last - first) * share)
