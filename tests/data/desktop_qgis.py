"""Run desktop QGIS with a script that writes its results."""

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

TIMEOUT_S = 1500
"""Time limit of a whole walk, on a busy machine."""

OUTPUT_SHOWN = 4000
"""Characters of QGIS's output in a failure message."""


def run_desktop(
    home: Path, display: str, script: Path, variables: dict[str, str], before: tuple[str, ...] = ()
) -> dict:
    """What the script saw, with ``exit_status`` and ``output`` of the process; skips where there is no desktop QGIS.

    Args:
        home: Folder of the user, with ``profiles``; made where it is missing.
        display: Of X.
        script: Writes JSON to the file that SEMREF_DESKTOP_RESULT names.
        variables: Of its environment, beside the usual ones.
        before: Command that runs QGIS.
    """
    program = shutil.which("qgis")
    if program is None:
        pytest.skip("desktop QGIS is not installed")
    runtime, result, output = home / "runtime", home / "result.json", home / "output.txt"
    runtime.mkdir(parents=True, mode=0o700)
    environment = {
        "PATH": os.environ["PATH"],
        "LANG": "C.UTF-8",
        "DISPLAY": display,
        "HOME": str(home),
        "XDG_RUNTIME_DIR": str(runtime),
        # Freed memory is overwritten, so that a use of it fails in every run.
        "MALLOC_PERTURB_": "165",
        # OpenCV of a virtual environment, if there is one: QGIS runs the system's Python; and shared modules.
        "PYTHONPATH": os.pathsep.join([sysconfig.get_path("purelib"), str(Path(__file__).parent)]),
        "SEMREF_DESKTOP_RESULT": str(result),
        **variables,
    }
    if "XAUTHORITY" in os.environ:
        environment["XAUTHORITY"] = os.environ["XAUTHORITY"]
    command = [*before, program, "--nologo", "--noversioncheck", "--profiles-path", str(home), "--code", str(script)]
    with output.open("wb") as stream:
        status = run_with_limit(command, environment, stream)
    said = output.read_text(encoding="utf-8", errors="replace")
    assert result.exists(), f"desktop QGIS (exit status {status}) wrote no result; it said:\n{said}"
    seen = json.loads(result.read_text(encoding="utf-8"))
    assert "error" not in seen, f"{seen['error']}\nThe end of what QGIS said:\n{said[-OUTPUT_SHOWN:]}"
    return {**seen, "exit_status": status, "output": said}


def make_package(repository: Path, target: Path) -> None:
    command = [sys.executable, str(repository / "tools" / "release" / "package.py"), "--output", str(target)]
    subprocess.run(command, check=True, timeout=TIMEOUT_S)


def install_package(repository: Path, plugins: Path) -> None:
    plugins.mkdir(parents=True, exist_ok=True)
    package = plugins.parent / "semref.zip"
    make_package(repository, package)
    with zipfile.ZipFile(package) as archive:
        archive.extractall(plugins)


def run_with_limit(command: list[str], environment: dict, output) -> int | None:
    """Return the exit status of the command, or None if it had to be killed with all its processes."""
    process = subprocess.Popen(
        command, env=environment, stdin=subprocess.DEVNULL, stdout=output, stderr=output, start_new_session=True
    )
    try:
        return process.wait(TIMEOUT_S)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        return None
