"""Install Python packages: run one process after the other without blocking QGIS."""

from __future__ import annotations

import traceback

from qgis.PyQt.QtCore import QObject, QProcess, QProcessEnvironment, pyqtSignal

from ...core.errors import SemRefError
from ...processing.messages.sentences import worded
from ...processing.packages.components import add_components_to_path
from ...processing.packages.install import Answer, Command, Commands
from ..widgets.messages import bug_sentence

_KILLED_WITHIN_MS = 5000


class ComponentInstaller(QObject):
    """Runs an installation. It ends with one of installed, failed and canceled.

    began: description of the current step; outputRead: output of the process; failed: a sentence for the user.
    """

    began = pyqtSignal(str)
    outputRead = pyqtSignal(str)
    installed = pyqtSignal()
    failed = pyqtSignal(str)
    canceled = pyqtSignal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._commands: Commands | None = None
        self._process: QProcess | None = None
        self._output = ""
        self.log = ""
        """Output since the last start."""

    @property
    def running(self) -> bool:
        return self._commands is not None

    def start(self, commands: Commands) -> None:
        self.log = ""
        self._commands = commands
        self._go_on(None)

    def cancel(self) -> None:
        """Stop the installation and remove the incomplete package."""
        if self._commands is None:
            return
        process, self._process = self._process, None
        process.finished.disconnect(self._take_answer)
        process.errorOccurred.disconnect(self._take_error)
        process.kill()
        process.waitForFinished(_KILLED_WITHIN_MS)
        process.deleteLater()
        self._commands.close()
        self._end(self.canceled)

    def _go_on(self, answer: Answer | None) -> None:
        try:
            command = self._commands.send(answer)
        except StopIteration:
            self._end(self.installed)
        except SemRefError as error:
            self._end(self.failed, worded(error))
        except Exception:
            self._end(self.failed, bug_sentence(traceback.format_exc()))
        else:
            self._run(command)

    def _end(self, signal, *arguments) -> None:
        self._commands = None
        # Packages that were installed before a failure are usable.
        add_components_to_path()
        signal.emit(*arguments)

    def _run(self, command: Command) -> None:
        self.began.emit(command.title)
        self._output = ""
        variables = QProcessEnvironment.systemEnvironment()
        for name, value in command.variables.items():
            variables.insert(name, value)
        self._process = QProcess(self)
        self._process.setProcessEnvironment(variables)
        self._process.setWorkingDirectory(command.folder)
        self._process.setProcessChannelMode(QProcess.ProcessChannelMode.MergedChannels)
        self._process.readyReadStandardOutput.connect(self._read)
        self._process.finished.connect(self._take_answer)
        self._process.errorOccurred.connect(self._take_error)
        self._process.start(command.program, command.arguments)

    def _read(self) -> None:
        # None after a cancel.
        if self._process is not None:
            text = bytes(self._process.readAllStandardOutput()).decode("utf-8", "replace")
            self._output += text
            self.log += text
            self.outputRead.emit(text)

    def _take_answer(self, status: int, how: QProcess.ExitStatus) -> None:
        self._read()
        crashed = how == QProcess.ExitStatus.CrashExit
        self._forget_process()
        self._go_on(Answer(-1 if crashed else status, self._output))

    def _take_error(self, error: QProcess.ProcessError) -> None:
        # After all other errors Qt emits finished.
        if error == QProcess.ProcessError.FailedToStart:
            reason = self._process.errorString()
            self._forget_process()
            self._go_on(Answer(-1, reason))

    def _forget_process(self) -> None:
        self._process.deleteLater()
        self._process = None
