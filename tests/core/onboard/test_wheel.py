"""The wheel for the aircraft: built, installed into a new environment, and run by its command."""

import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import cv2
import pytest
from onboard_area import CENTER, HERE, write_area

WITHOUT_NETWORK = ["--no-index", "--no-deps", "--disable-pip-version-check"]


def test_the_wheel_has_all_packages_of_core_and_the_version_of_the_plugin(repository):
    settings = (repository / "pyproject.toml").read_text(encoding="utf-8")
    named = set(re.findall(r'^    "(semref\.core[^"]*)",$', settings, re.MULTILINE))
    files = (repository / "core").rglob("__init__.py")
    assert named == {".".join(("semref", *path.parent.relative_to(repository).parts)) for path in files}
    (version,) = re.findall(r"^version=(.*)$", (repository / "metadata.txt").read_text(encoding="utf-8"), re.MULTILINE)
    assert f'version = "{version}"' in settings


def done(*command, **more):
    result = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False, **more)
    assert result.returncode == 0, result.stdout + result.stderr
    return result.stdout


@pytest.fixture(scope="module")
def semref(repository, tmp_path_factory):
    """Return the path of the command in a new environment with the packages of this one."""
    if not all(importlib.util.find_spec(name) for name in ("setuptools", "wheel", "pip", "venv")):
        pytest.skip("setuptools, wheel and pip, which build a wheel, are not all here")
    folder = tmp_path_factory.mktemp("wheel")
    source, environment = folder / "source", folder / "environment"
    source.mkdir()
    for name in ("pyproject.toml", "README.md"):
        shutil.copy(repository / name, source)
    shutil.copytree(repository / "core", source / "core", ignore=shutil.ignore_patterns("__pycache__"))
    pip = [sys.executable, "-m", "pip"]
    done(*pip, "wheel", source, "--no-build-isolation", "--wheel-dir", folder, *WITHOUT_NETWORK, cwd=folder)
    (wheel,) = folder.glob("semref-*.whl")
    done(sys.executable, "-m", "venv", "--without-pip", environment)
    place = done(python_of(environment), "-c", "import sysconfig; print(sysconfig.get_path('purelib'))").strip()
    # The installed packages: numpy and OpenCV.
    shown = [path for path in sys.path if path.endswith(("site-packages", "dist-packages"))]
    Path(place, "here.pth").write_text("\n".join(shown), encoding="utf-8")
    done(*pip, "--python", python_of(environment), "install", wheel, *WITHOUT_NETWORK, "--ignore-installed")
    return python_of(environment).with_name("semref.exe" if os.name == "nt" else "semref")


def python_of(environment):
    return environment / ("Scripts/python.exe" if os.name == "nt" else "bin/python")


@pytest.mark.slow
def test_the_command_of_the_wheel_shows_a_file_and_localizes(semref, tmp_path):
    write_area(str(tmp_path / "area.npz"))
    cv2.imwrite(str(tmp_path / "here.png"), HERE)
    assert "references:" in done(semref, "info", "area.npz", cwd=tmp_path)
    found = json.loads(done(semref, "localize", "here.png", "--database", "area.npz", "--json", cwd=tmp_path))
    assert (found["x"], found["y"]) == pytest.approx(CENTER, abs=1)
    assert done(semref, "--help", cwd=tmp_path).startswith("usage: semref ")
