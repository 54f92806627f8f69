"""Results survive new projects and reloads of the plugin."""

import shutil
from pathlib import Path

import pytest
from dock_area import CONSTELLATION, choose_method, localize, results_of, settle, wait_until
from qgis.core import QgsProject

from semref.ui.running import run_history
from semref.ui.widgets.progress import remaining_text

pytestmark = pytest.mark.slow  # plugins and projects are loaded again


def test_two_projects_in_turn_have_each_their_own_results_without_anybody_saving_them(dock, area, tab, tmp_path):
    project, states = QgsProject.instance(), []
    for number, images in enumerate(([area.image], [area.image, area.unreadable])):
        project.clear()
        localize(dock, area.database, images)
        project.write(str(tmp_path / f"{number}.qgs"))
        states.append((tab.state_now(), results_of(dock)))
    for number in (0, 1, 0):
        project.read(str(tmp_path / f"{number}.qgs"))
        assert (tab.state_now(), results_of(dock)) == states[number]


def test_results_of_a_project_that_was_never_saved_are_among_the_earlier_ones(plugin, dock, iface, area, tab, tmp_path):
    choose_method(dock, CONSTELLATION)
    localize(dock, str(shutil.copy(area.database, tmp_path / "R&D.gpkg")), [area.image])
    shown = results_of(dock)
    QgsProject.instance().clear()
    # As when QGIS updates the plugin.
    plugin.unload()
    settle()
    plugin.initGui()
    again = iface.docks[-1]
    again.setUserVisible(True)
    settle()
    results = again.content.localize.results
    assert results_of(again) == [] and not results.save.isEnabled()
    results.earlier.aboutToShow.emit()
    first = results.earlier.actions()[0]
    assert first.text().endswith(" · R&&D (1)")
    first.trigger()
    assert results_of(again) == shown and results.save.isEnabled()
    wait_until(lambda: results.image.canvas.scene().items(), "the picture")


def test_only_the_last_runs_with_results_are_kept_and_folders_of_others(qgis_app):
    made = [run_history.begin_run("/area.gpkg", "", 1) for _ in range(25)]
    for run in made:
        Path(run.file).write_bytes(b"results")
    foreign = run_history.runs_folder() / "0 my copies"
    foreign.mkdir()
    run_history.forget_old_runs()
    # Only folders of SemRef's runs are deleted.
    foreign.rmdir()
    assert [run.folder for run in run_history.run_records()] == [run.folder for run in reversed(made[-20:])]
    for run in made[-20:-1]:
        Path(run.file).unlink()
    # Runs that came to nothing displace no results.
    for _ in range(25):
        run_history.begin_run("/area.gpkg", "", 1)
    run_history.forget_old_runs()
    assert [run.folder for run in run_history.run_records()] == [made[-1].folder]
    Path(made[-1].file).unlink()


def test_results_that_the_profile_cannot_store_are_shown_as_well(dock, area, tab, monkeypatch, tmp_path):
    monkeypatch.setattr(run_history, "runs_folder", lambda: tmp_path / "it's here")
    choose_method(dock, CONSTELLATION)
    localize(dock, area.database, [area.image])
    assert results_of(dock) == [("on_window.tif", "Position")] and not list(tmp_path.iterdir())


def test_a_run_shows_the_remaining_time(qgis_app):
    assert remaining_text(1.0, 50) == "" and remaining_text(100, 1) == "" and remaining_text(100, 100) == ""
    assert remaining_text(10, 50) == "about 10 s left"
    assert remaining_text(60, 10) == "about 9 min left"
    assert remaining_text(3600, 20) == "about 4.0 h left"
