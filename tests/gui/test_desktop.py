"""Desktop QGIS, as a user starts it, with the zip installed in a fresh profile."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import sysconfig
import zipfile
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow  # a QGIS of its own is started

TIMEOUT_S = 600


@pytest.fixture(scope="module")
def desktop(repository, display, tmp_path_factory) -> dict:
    """What desktop_session.py saw in QGIS, with `exit_status` and `output` of the process."""
    program = shutil.which("qgis")
    if program is None:
        pytest.skip("desktop QGIS is not installed")
    home = tmp_path_factory.mktemp("desktop")
    install_package(repository, home / "profiles" / "default" / "python" / "plugins")
    result = home / "result.json"
    output = home / "output.txt"
    environment = {
        "PATH": os.environ["PATH"],
        "LANG": "C.UTF-8",
        "DISPLAY": display,
        "HOME": str(home),
        "XDG_RUNTIME_DIR": str(tmp_path_factory.mktemp("runtime")),
        # OpenCV, where a virtual environment has it: QGIS runs the system's Python.
        "PYTHONPATH": sysconfig.get_path("purelib"),
        "SEMREF_DESKTOP_RESULT": str(result),
    }
    if "XAUTHORITY" in os.environ:
        environment["XAUTHORITY"] = os.environ["XAUTHORITY"]
    script = Path(__file__).with_name("desktop_session.py")
    command = [program, "--nologo", "--noversioncheck", "--profiles-path", str(home), "--code", str(script)]
    with output.open("wb") as stream:
        status = run_with_limit(command, environment, stream)
    said = output.read_text(encoding="utf-8", errors="replace")
    assert result.exists(), f"desktop QGIS (exit status {status}) wrote no result; it said:\n{said}"
    seen = json.loads(result.read_text(encoding="utf-8"))
    assert "error" not in seen, seen["error"]
    return {**seen, "exit_status": status, "output": said}


def install_package(repository: Path, plugins: Path) -> None:
    plugins.mkdir(parents=True)
    package = plugins.parent / "semref.zip"
    command = [sys.executable, str(repository / "tools" / "release" / "package.py"), "--output", str(package)]
    subprocess.run(command, check=True, timeout=TIMEOUT_S)
    with zipfile.ZipFile(package) as archive:
        archive.extractall(plugins)


def run_with_limit(command: list[str], environment: dict, output) -> int | None:
    """Exit status of the command; None when it had to be killed, with all that it started."""
    process = subprocess.Popen(
        command, env=environment, stdin=subprocess.DEVNULL, stdout=output, stderr=output, start_new_session=True
    )
    try:
        return process.wait(TIMEOUT_S)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        return None


def test_no_python_error_is_logged(desktop):
    assert [message["text"] for message in desktop["messages"] if "Traceback" in message["text"]] == []
    assert "Traceback" not in desktop["output"]


def test_the_plugin_loads_and_unloads_five_times(desktop):
    assert [(one["loaded"], one["unloaded"]) for one in desktop["rounds"]] == [(True, True)] * 5


def test_each_load_brings_the_algorithms_and_a_place_in_the_window(desktop):
    for one in desktop["rounds"]:
        assert "semref:rasterizeannotation" in one["algorithms"]
        assert one["added"] != []


def test_unloading_leaves_nothing_behind(desktop):
    assert [one["left"] for one in desktop["rounds"]] == [[]] * 5


def test_qgis_quits_cleanly_with_the_plugin_loaded(desktop):
    assert desktop["stays"] is True
    assert desktop["exit_status"] == 0, desktop["output"]


def test_annotations_are_checked_and_repaired_beside_the_geos_of_qgis(desktop):
    assert "invalid" in " ".join(desktop["check"]["kinds"])
    # The bow tie's two triangles of 100 m², and the square.
    assert abs(desktop["check"]["area"] - 600) < 0.1
