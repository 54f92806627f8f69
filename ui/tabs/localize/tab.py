"""Tab *Localize*: choose images, localize them in the background, and show their positions."""

from __future__ import annotations

import os
from functools import partial
from typing import Callable

from qgis.core import QgsApplication, QgsProject, QgsSettings
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import pyqtSignal
from qgis.PyQt.QtWidgets import QFileDialog, QPushButton, QVBoxLayout, QWidget

from ....core.errors import ParameterError
from ....core.named_files import named_file
from ....processing.jobs.image_results import count_sentence
from ....processing.layers.results_file import save_results
from ....processing.messages.sentences import worded
from ....processing.translation import tr
from ...findings import Finding, lat_lon_text, read_findings, x_y_text
from ...project_state import DockState
from ...running.background import Reader
from ...running.localization_run import LocalizationRun, named_results
from ...running.run_history import RunRecord, forget_old_runs, labels_of, run_records, runs_folder
from ...widgets.database_box import DatabaseBox
from ...widgets.layouts import MARGIN_PX
from ...widgets.messages import Messages
from ...widgets.progress import RemainingBar, StatusLine
from .inputs import ImageBox, MethodRow
from .prior_row import PriorRow
from .results import ResultsBox
from .shown_hit import ShownHit

_RESULTS_FOLDER_SETTING = "semref/dock/results_folder"


class LocalizeTab(QWidget):
    """Localizes images in the chosen database.

    found: a sentence about the results of a run.
    """

    found = pyqtSignal(str)

    def __init__(self, canvas: QgsMapCanvas, database: DatabaseBox, messages: Messages) -> None:
        super().__init__()
        self._database, self._messages = database, messages
        self._findings: list[Finding] = []
        self._results_file = self._idle_shown = ""
        self._found_with = self._chosen = "", ""
        self.run = LocalizationRun(self)
        self._reader = Reader(self)
        self.images = ImageBox(messages)
        self.method = MethodRow()
        self.prior = PriorRow(canvas)
        self.localize_button = QPushButton()
        self.progress = RemainingBar()
        self.state = StatusLine()
        self.results = ResultsBox()
        self.hit = ShownHit(canvas, self.results, messages)
        self._lay_out()
        self._connect()
        self._show_idle()

    def _lay_out(self) -> None:
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, MARGIN_PX, 0, 0)
        for widget in (self.images, self.method, self.prior, self.localize_button, self.progress, self.state):
            layout.addWidget(widget)
        layout.addWidget(self.results, 1)

    def _connect(self) -> None:
        self._database.changed.connect(self._follow_choice)
        self._database.replaced.connect(self._forget_results)
        self._database.changed.connect(self._show_idle)
        self._database.checked.connect(self._show_looked)
        self.images.changed.connect(self._follow_choice)
        self.images.changed.connect(self._show_idle)
        self.images.looked.connect(self._show_looked)
        self.images.collapsedStateChanged.connect(self._show_choices)
        self.localize_button.clicked.connect(self._localize_or_cancel)
        self.results.save.clicked.connect(self._save_results)
        self.results.earlier.aboutToShow.connect(self._list_earlier)
        self.results.copy.clicked.connect(self._copy_position)
        self.run.progressed.connect(self.progress.show_percent)
        self.run.textChanged.connect(self.state.show_text)
        self.run.logged.connect(self._messages.log)
        self.run.done.connect(lambda *_: self._show_found())
        self.run.failed.connect(self._messages.error)
        for ended in (self.run.failed, self.run.canceled):
            ended.connect(self._show_idle)
        self.run.canceled.connect(lambda: self.state.show_text(tr("Canceled.")))

    # --- project ---

    def state_now(self) -> DockState:
        """Return the state for the project file."""
        return DockState(
            self._database.path(),
            self.images.model_path(),
            self.method.method(),
            self.images.paths(),
            self._results_file if self._now_chosen() == self._found_with else "",
            self.prior.circle,
            self.images.flight.isChecked(),
        )

    def show_state(self, state: DockState) -> None:
        """Restore a state; a message reports missing results."""
        self.run.cancel()
        self._show_results("", state.model)
        self.method.choose(state.method)
        self._database.file.setFilePath(state.database)
        self.images.restore_model(state.model)
        self.images.list.show_only(state.images)
        self.images.flight.setChecked(state.is_flight)
        self.prior.restore(state.prior)
        if not state.results:
            return
        try:
            # Results in the profile come from the user's own runs.
            is_own = bool(named_file(state.results, [str(runs_folder())]))
            chosen = None if is_own else lambda: [os.path.dirname(state.results), *self.images.paths()]
            self._show_results(state.results, state.model, chosen=chosen)
            self._collapse_inputs()
        except ParameterError as error:
            self._messages.warning(worded(error))

    # --- running ---

    def _localize_or_cancel(self) -> None:
        if self.run.running:
            self.localize_button.setEnabled(False)
            self.state.show_text(tr("Canceling…"))
            self.run.cancel()
            return
        settings = self.prior.parameters()
        if self.images.model_path():
            settings["MODEL"] = self.images.model_path()
        if self.run.start(
            self._database.path(), self.images.paths(), self.method.method(), settings, self.images.flight.isChecked()
        ):
            self._set_running(True)
            self.state.show_text(tr("Starting…"))

    def _set_running(self, running: bool) -> None:
        for part in (self._database, self.images, self.method, self.prior):
            part.setEnabled(not running)
        self.progress.setVisible(running)
        self.progress.begin()
        self.localize_button.setText(tr("Cancel") if running else tr("Localize"))
        self.localize_button.setEnabled(running or self._is_ready())

    def _is_ready(self) -> bool:
        return self._has_database() and bool(self.images.paths()) and not self.images.fault

    def _has_database(self) -> bool:
        return bool(self._database.path()) and not self._database.fault

    def _show_idle(self, *_) -> None:
        # A model or database may be completed during a run.
        if not self.run.running:
            self._set_running(False)
            self.state.show_text(*self._idle_text())
            self._idle_shown = self.state.text_shown

    def _show_looked(self) -> None:
        """Show the faults of the choices, unless a message about a run is shown."""
        if not self.run.running:
            self.localize_button.setEnabled(self._is_ready())
            if self.state.text_shown == self._idle_shown:
                self._show_idle()

    def _idle_text(self) -> tuple[str, ...]:
        """Return a sentence, and optionally a second one."""
        if not self.images.paths():
            return (tr("Add images.") if self._has_database() else tr("Choose a database and add images."),)
        if not self._has_database():
            return (tr("Choose a database."),)
        if self.images.fault:
            return tr("A folder of images can’t be used."), self.images.fault
        if self.images.chosen is None:
            return (tr("Reading the folder…"),)
        if self.images.chosen.has_photos and not self.images.model_path():
            return tr("These are photos: choose a model."), tr("Otherwise SemRef reads colors as classes.")
        return (tr("Ready to localize."),)

    # --- results ---

    def _show_found(self) -> None:
        self._set_running(False)
        if not self._show_run(self.run.record):
            self._show_idle()
            return
        self._reader.read(tr("Removing old results"), forget_old_runs)
        if self.run.pace:
            self.state.show_text(self.state.text_shown, self.run.pace)
        self.found.emit(self.state.text_shown)

    def _show_run(self, run: RunRecord, *_checked) -> bool:
        """Show the results of a run. Returns False after an error, as when another program removed the file."""
        try:
            self._show_results(run.file, run.model, run.database)
        except ParameterError as error:
            self._messages.error(worded(error))
            return False
        self._collapse_inputs()
        return True

    def _show_results(
        self, file: str, model: str, database: str = "", chosen: Callable[[], list[str]] | None = None
    ) -> None:
        """Show the results of a run.

        Args:
            file: GeoPackage of the results; empty for no results.
            model: Model of the run; empty for label images.
            database: Database of the run; empty for the chosen one.
            chosen: Returns files and folders with images that may be opened; None if the user chose all images.

        Raises:
            ParameterError: The file has no results.
        """
        findings = read_findings(file, labels_of(file)) if file else []
        self._results_file = file
        self._found_with = database or self._database.path(), model
        self._chosen = self._now_chosen()
        self.hit.use(*self._found_with, chosen)
        self._findings = findings
        if findings:
            self.state.show_text(count_sentence([finding.status for finding in findings]))
        self._show_findings(findings)

    def _show_findings(self, findings: list[Finding]) -> None:
        self.hit.track.show(findings)
        self.results.show_findings(findings)

    def _now_chosen(self) -> tuple[str, str]:
        return self._database.path(), self.images.model_path()

    def _follow_choice(self) -> None:
        """Hide the results while another database or model than theirs is chosen."""
        chosen = self._now_chosen()
        if chosen != self._chosen:
            self._chosen = chosen
            self._show_findings(self._findings if chosen == self._found_with else [])

    def _forget_results(self) -> None:
        """Clear the results, because the database has new content. The earlier results still list them."""
        self._show_results("", self.images.model_path())

    def _collapse_inputs(self) -> None:
        """Collapse the inputs, so that the results have room."""
        for box in (self._database, self.images):
            box.setCollapsed(True)

    def _show_choices(self, folded: bool) -> None:
        for row in (self.method, self.prior):
            row.setVisible(not folded)

    def _save_results(self) -> None:
        folder = QgsSettings().value(_RESULTS_FOLDER_SETTING, "", type=str)
        path, _ = QFileDialog.getSaveFileName(self.window(), tr("Save results"), folder, tr("GeoPackage (*.gpkg)"))
        if not path:
            return
        path = path if path.lower().endswith(".gpkg") else f"{path}.gpkg"
        QgsSettings().setValue(_RESULTS_FOLDER_SETTING, os.path.dirname(path))
        name = os.path.splitext(os.path.basename(path))[0]
        try:
            save_results(self._results_file, path)
            positions, *_others, track = named_results(path, name)
        except ParameterError as error:
            self._messages.error(worded(error))
            return
        self._results_file = path
        positions.setName(name)
        if track is not None:
            QgsProject.instance().addMapLayer(track)
        QgsProject.instance().addMapLayer(positions)
        self._messages.info(tr("Results saved. The dock shows them again when you open this project."))

    def _list_earlier(self) -> None:
        self.results.earlier.clear()
        for kept in run_records():
            # A single & would be an access key.
            shown = self.results.earlier.addAction(kept.title.replace("&", "&&"))
            shown.triggered.connect(partial(self._show_run, kept))
        if self.results.earlier.isEmpty():
            self.results.earlier.addAction(tr("No results yet")).setEnabled(False)

    def _copy_position(self) -> None:
        """Copy latitude and longitude; without them, as with a local CRS, x and y."""
        finding = self.results.list.selected()
        text = lat_lon_text(finding)
        label, text = (tr("lat, lon"), text) if text else ("x, y", x_y_text(finding))
        QgsApplication.clipboard().setText(text)
        self.state.show_text(tr("Copied: {command}").format(command=f"{text} ({label})"))
