"""What every SemRef algorithm shares: groups, help, errors, cancel, the check for Python packages."""

from __future__ import annotations

import contextlib
import errno
from collections.abc import Generator, Mapping
from concurrent.futures import ThreadPoolExecutor, wait
from html import escape
from pathlib import Path
from types import MappingProxyType
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
from qgis.PyQt.QtGui import QIcon

from ...core.errors import SemRefError
from ...core.sentences import legible
from ..layers.layer_metadata import Note, note_of_run
from ..messages.sentences import worded
from ..packages.components import NEEDED, Package, require
from ..translation import tr
from ..version import algorithm_help_url, plugin_version
from .destinations import require_outputs_apart
from .outputs import Outputs
from .time_left import TimeLeftFeedback
from .values import Values

Declared = Union[QgsProcessingParameterDefinition, QgsProcessingOutputDefinition]
Result = TypeVar("Result")

ICON_PATH = Path(__file__).resolve().parents[2] / "resources" / "icon.svg"

ANNOTATION, REFERENCE_DATABASE, LOCALIZATION = "annotation", "referencedatabase", "localization"

REPORTS_AS_FILES = "reports_as_files"
"""Configuration of an algorithm whose reports are shown by whoever opens its dialog, not by QGIS's Results Viewer."""

CANCEL_EVERY_S = 0.2
"""How often a cancel is looked for during work that can't be interrupted."""


class Canceled(Exception):
    """The user canceled; nothing was written."""

    def message(self) -> str:
        """What the user is told, in their language."""
        return tr("Canceled; nothing was written.")


class SemRefAlgorithm(QgsProcessingAlgorithm):
    """Base of the algorithms. A subclass has ID, GROUP, TAGS and the methods title, summary, parameters, work."""

    ID = ""
    GROUP = ""
    TAGS: tuple[str, ...] = ()
    PACKAGES: tuple[Package, ...] = NEEDED
    """Python packages that it needs beside QGIS's own."""
    MAY_REPLACE: ClassVar[Mapping[str, str]] = MappingProxyType({})
    """Outputs that may be the file of an input, by key: it is read whole before, and replaced when all is done."""

    _refusal: SemRefError | None = None
    _note = Note()
    _reports_as_files = False

    def title(self) -> str:
        raise NotImplementedError

    def summary(self) -> str:
        """One or two paragraphs of help; the parameters bring their own."""
        raise NotImplementedError

    def parameters(self) -> tuple[Declared, ...]:
        """What it asks for, what it writes and the numbers that it tells, in the dialog's order."""
        raise NotImplementedError

    def check(self, values: Values) -> None:
        """Raises SemRefError for values that don't fit together; for what needs no work."""

    def read_layers(self, values: Values) -> None:
        """Takes what belongs to the main thread out of layers; raises SemRefError."""

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, Any] | None:
        """Does the work and writes ``outputs``; raises SemRefError for what the user can fix and Canceled.

        Returns:
            The numbers that it tells, by key.
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
        return self.title()

    def groupId(self) -> str:
        return self.GROUP

    def group(self) -> str:
        return group_title(self.GROUP)

    def tags(self) -> list[str]:
        return [*self.TAGS, "semref"]

    def icon(self) -> QIcon:
        return QIcon(str(ICON_PATH))

    def svgIconPath(self) -> str:
        return str(ICON_PATH)

    def shortDescription(self) -> str:
        return self.summary().split("\n\n")[0]

    def shortHelpString(self) -> str:
        """Return the help of dialogs as HTML; for qgis_process, plain text without what it prints itself."""
        summary = self.summary()
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
        values = Values(self, parameters, context)
        try:
            require(self.PACKAGES)
            values.require_texts()
            # First: QGIS opens layers to see whether they can be.
            for definition in self.parameterDefinitions():
                if definition.type() == "raster":
                    values.require_pictures(definition.name())
            possible, reason = super().checkParameterValues(parameters, context)
            if not possible:
                # QGIS repeats values as they are.
                return False, legible(reason)
            for definition in self.parameterDefinitions():
                if values.has(definition.name()):
                    _READ.get(definition.type(), lambda *_: None)(values, definition.name())
            require_outputs_apart(self, parameters, context, self.MAY_REPLACE)
            self.check(values)
        except SemRefError as error:
            return False, worded(error)
        return True, ""

    def prepareAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> bool:
        self._refusal = None
        try:
            require(self.PACKAGES)
            values = Values(self, parameters, context)
            values.require_texts()
            require_outputs_apart(self, parameters, context, self.MAY_REPLACE)
            self.read_layers(values)
            self._note = note_of_run(self, parameters, context, plugin_version())
        except SemRefError as error:
            # Raised by processAlgorithm: of what prepareAlgorithm raises QGIS tells Python callers nothing.
            self._refusal = error
        return True

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        try:
            if self._refusal is not None:
                raise self._refusal
            values = Values(self, parameters, context)
            with Outputs(values, self._note) as outputs:
                numbers = self.work(values, outputs, TimeLeftFeedback(feedback))
                outputs.commit()
            return {**outputs.results, **(numbers or {})}
        except SemRefError as error:
            raise QgsProcessingException(worded(error)) from error
        except Canceled as error:
            raise QgsProcessingException(error.message()) from error
        except OSError as error:
            if error.errno not in _DISK_ERRORS:
                raise
            raise QgsProcessingException(_disk_sentence(error)) from error


_READ = {"number": Values.number, "distance": Values.number, "range": Values.range}
"""Numbers by type of parameter: read before any work, and refused where they are none."""


def _is_page(parameter: QgsProcessingParameterDefinition) -> bool:
    """Whether it is an output that QGIS shows in its Results Viewer; QGIS goes by the filter as well."""
    return isinstance(parameter, QgsProcessingParameterFileDestination) and "*.htm" in parameter.fileFilter()


def prints_help() -> bool:
    """Return whether help goes to a terminal: qgis_process prints the short description, HTML raw, and parameters."""
    return QgsApplication.platform() == "qgis_process"


def group_title(group: str) -> str:
    """A group of algorithms in the user's language."""
    return {
        ANNOTATION: tr("Annotation"),
        REFERENCE_DATABASE: tr("Reference database"),
        LOCALIZATION: tr("Localization"),
    }[group]


_DISK_ERRORS = (errno.ENOSPC, errno.EDQUOT, errno.EROFS, errno.EACCES, errno.EPERM, errno.EFBIG, errno.ENAMETOOLONG)


def _disk_sentence(error: OSError) -> str:
    name = error.filename or tr("the output")
    if error.errno in (errno.ENOSPC, errno.EDQUOT, errno.EFBIG):
        return tr("The disk is full while writing {name}; free some space or choose another place.").format(name=name)
    return tr("{name} can’t be written; choose a place where you may write.").format(name=name)


def check_canceled(feedback: QgsProcessingFeedback) -> None:
    if feedback.isCanceled():
        raise Canceled


def cancelable(function: Callable[..., Result], *arguments: Any, feedback: QgsProcessingFeedback) -> Result:
    """The function's result; a cancel is heeded at once, while the function ends in its own thread."""
    pool = ThreadPoolExecutor(1)
    try:
        running = pool.submit(function, *arguments)
        while not wait([running], timeout=CANCEL_EVERY_S).done:
            check_canceled(feedback)
        # A function that looked for the cancel itself has ended early.
        check_canceled(feedback)
        return running.result()
    finally:
        pool.shutdown(wait=False)


def interruptible(
    steps: Generator[tuple[str, float], None, None], feedback: QgsProcessingFeedback
) -> Generator[tuple[str, float], None, None]:
    """The same steps, each in a thread of its own: a cancel is heeded in the midst of a long one."""
    while True:
        step = cancelable(next, steps, None, feedback=feedback)
        if step is None:
            return
        yield step


def follow(
    steps: Generator[tuple[str, float], None, None],
    feedback: QgsProcessingFeedback,
    first: float = 0.0,
    last: float = 100.0,
) -> None:
    """Runs steps of (what is being done, share done 0…1), showing progress from first to last %; raises Canceled.

    The steps are closed whatever happens: files and threads they hold are let go before anything is cleared away.
    """
    shown = None
    with contextlib.closing(steps):
        for what, share in steps:
            check_canceled(feedback)
            if what != shown:
                feedback.setProgressText(tr(what))
                shown = what
            feedback.setProgress(first + (last - first) * share)
