"""The training environment: the selected Python, and the commands that create it, without running them."""

import os
import shutil
import sys

import pytest
from qgis.core import QgsSettings

from semref.core.errors import ComponentError
from semref.processing.packages import training_environment
from semref.processing.packages.install import Answer


@pytest.fixture
def folder(qgis_app, tmp_path, monkeypatch):
    """Return the folder of the environment; the options are empty."""
    QgsSettings().remove(training_environment.PYTHON_SETTING)
    made = tmp_path / "profile" / "semref_training"
    monkeypatch.setattr(training_environment, "environment_folder", lambda: made)
    return made


def drive(commands, answer):
    """Return (title, program, arguments) of the commands; ``answer(command)`` simulates each."""
    seen = []
    try:
        command = next(commands)
        while True:
            seen.append(command)
            command = commands.send(answer(command))
    except StopIteration:
        return seen


def making(folder):
    def answer(command):
        if "venv" in command.arguments:
            python = training_environment.environment_python(folder)
            python.parent.mkdir(parents=True)
            python.write_text("")
        return Answer(0, '{"event": "ready"}')

    return answer


def test_an_environment_is_made_filled_checked_and_then_used(folder):
    seen = drive(training_environment.making_environment(), making(folder))
    assert seen[1].arguments == ["-m", "venv", str(folder)]
    assert seen[2].program == str(training_environment.environment_python(folder))
    assert seen[2].arguments[:3] == ["-m", "pip", "install"]
    assert seen[2].arguments[-2:] == ["--requirement", str(training_environment.REQUIREMENTS)]
    assert all(command.variables["PYTHONHOME"] == "" for command in seen)
    assert training_environment.is_environment_ready()
    assert training_environment.training_python() == seen[2].program


def test_wheels_need_no_index_and_without_graphics_cards_torch_comes_first_from_its_makers(folder):
    seen = drive(training_environment.making_environment("/wheels", True), making(folder))
    assert len(seen) == 4
    assert "--no-index" in seen[2].arguments and "/wheels" in seen[2].arguments
    shutil.rmtree(folder)
    seen = drive(training_environment.making_environment("", True), making(folder))
    assert "--index-url" in seen[2].arguments and any(a.startswith("torch==") for a in seen[2].arguments)
    assert not any(a.startswith(("timm", "#")) for a in seen[2].arguments)
    assert "--index-url" not in seen[3].arguments


@pytest.mark.parametrize(
    ("failing", "said"),
    [
        ("venv", "python3-venv"),
        ("pip", "could not be installed: no matching distribution"),
        ("training.command", "does not work"),
    ],
)
def test_a_failed_step_is_reported_and_leaves_nothing(folder, failing, said):
    well = making(folder)

    def answer(command):
        done = well(command)
        failed = any(os.path.basename(argument) == failing for argument in command.arguments)
        return Answer(1, "ERROR: no matching distribution") if failed else done

    with pytest.raises(ComponentError, match=said):
        drive(training_environment.making_environment(), answer)
    assert not folder.exists() and not training_environment.is_environment_ready()


def test_a_cancel_leaves_nothing(folder):
    commands = training_environment.making_environment()
    answer = making(folder)
    command = next(commands)
    while "pip" not in command.arguments:
        command = commands.send(answer(command))
    commands.close()
    assert not folder.exists()


def test_the_python_asked_for_comes_before_that_of_the_options(folder):
    with pytest.raises(ComponentError, match="Training needs a Python"):
        training_environment.training_python()
    QgsSettings().setValue(training_environment.PYTHON_SETTING, sys.executable)
    assert training_environment.training_python() == sys.executable
    with pytest.raises(ComponentError, match="/no/such is not executable"):
        training_environment.training_python("/no/such")
    QgsSettings().remove(training_environment.PYTHON_SETTING)
