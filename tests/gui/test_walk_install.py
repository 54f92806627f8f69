"""The way of a newcomer to the first position, in desktop QGIS with a new profile and without SemRef's packages.

There is no network but what pip's index gave before. SEMREF_PICTURES names a folder for pictures of the screen.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path
from urllib.parse import unquote, urlparse

import numpy as np
import pytest
from desktop_qgis import TIMEOUT_S, make_package, run_desktop

from semref.processing.packages.components import ONNXRUNTIME, OPENCV, PILLOW, SHAPELY

pytestmark = [pytest.mark.slow, pytest.mark.newer]  # a QGIS of its own is started

DATA = Path(__file__).resolve().parents[1] / "data"
OFFLINE = ("unshare", "--map-root-user", "--net")
"""A program started so has no network at all."""


def can_go_offline() -> bool:
    return shutil.which("unshare") is not None and subprocess.run([*OFFLINE, "true"]).returncode == 0


@pytest.fixture(scope="module")
def package(repository, tmp_path_factory) -> Path:
    target = tmp_path_factory.mktemp("package") / "semref.zip"
    make_package(repository, target)
    return target


@pytest.fixture(scope="module")
def wheels(tmp_path_factory) -> Path | None:
    """What the button *Install* asks pip for, from the index that pip has here; None where that is out of reach."""
    folder = tmp_path_factory.mktemp("wheels")
    pinned = [line for package in (OPENCV, PILLOW, SHAPELY, ONNXRUNTIME) for line in package.pinned(np.__version__)]
    (folder / "pinned.txt").write_text("\n".join(pinned), encoding="ascii")
    options = ["--no-deps", "--only-binary=:all:", "--require-hashes", "--retries=1", "--timeout=15", "--quiet"]
    files = ["--dest", str(folder), "--requirement", str(folder / "pinned.txt")]
    command = [sys.executable, "-m", "pip", "download", *options, *files]
    return folder if subprocess.run(command, timeout=TIMEOUT_S, check=False).returncode == 0 else None


@pytest.fixture(scope="module")
def walk(package, wheels, display, tmp_path_factory) -> dict:
    home = tmp_path_factory.mktemp("walk")
    kept = Path(os.environ.get("SEMREF_PICTURES", home / "pictures"))
    variables = {"SEMREF_ZIP": str(package), "SEMREF_SAMPLE": str(home / "sample"), "SEMREF_PICTURES": str(kept)}
    variables["PYTHONPATH"] = os.pathsep.join([str(DATA / "bare"), str(DATA)])
    if wheels is not None:
        variables.update(SEMREF_HAS_WHEELS="yes", PIP_NO_INDEX="1", PIP_FIND_LINKS=str(wheels))
    script = Path(__file__).with_name("walk_install_session.py")
    for folder in (home / "sample", kept):
        folder.mkdir(exist_ok=True)
    seen = run_desktop(home, display, script, variables, OFFLINE if can_go_offline() else ())
    (kept / "walk_install.json").write_text(json.dumps(seen, indent=1), encoding="utf-8")
    return seen


@pytest.fixture
def whole_walk(walk, wheels) -> dict:
    """Where it went on to the first fix."""
    if wheels is None:
        pytest.skip("pip's index is out of reach: the packages are not installed, and nothing is localized")
    return walk


@pytest.fixture
def comes_with_pages(package):
    if "semref/help/index.html" not in zipfile.ZipFile(package).namelist():
        pytest.skip("the guide's pages were not made of these docs: tools/docs/build_site.py")


def test_the_zip_installs_into_a_bare_qgis_without_a_network_and_without_python_errors(walk):
    assert walk["reached"] is False or not can_go_offline()
    assert (walk["was_there"], walk["found"], walk["active"]) == (False, [], True)
    assert walk["messages"] == [] and walk["errors"] == [] and "Traceback" not in walk["output"]


def test_every_menu_entry_answers_and_the_dock_names_what_is_missing(walk):
    assert "OpenCV, Pillow, Shapely, ONNX Runtime" in walk["notice"] and len(walk["menu"]) == 5
    said = " ".join(walk["bar"])
    assert "Diagnostics are on the clipboard" in said and "The sample project needs OpenCV" in said


def test_every_algorithm_opens_and_the_toolbox_shows_where_to_install_missing_packages(walk):
    assert walk["dialogs"]["opened"] > 20
    # QGIS shows it as HTML: a < would end it.
    assert walk["dialogs"]["shown"].endswith("Install it under Settings ▸ Options ▸ SemRef.")


def test_the_button_installs_the_packages_and_all_photos_are_localized_without_a_restart(whole_walk):
    state, log = whole_walk["packages"]
    assert "You do not need to restart QGIS" in state, log
    assert whole_walk["filled"] and whole_walk["rows"] == 12
    assert [text for text in whole_walk["left"] if "needs" in text] == []


def test_every_help_opens_a_page_that_came_with_the_zip(whole_walk, comes_with_pages):
    names = [Path(unquote(urlparse(address).path)).name for address in whole_walk["help"]]
    assert names == ["index.html", "index.html", "builddatabase.html"]
    assert [address for address in whole_walk["help"] if not address.startswith("file:///")] == []


def test_qgis_quits_at_once_though_the_dock_still_reads(walk):
    assert walk["exit_status"] == 0, walk["output"]


def test_a_browser_without_a_network_finds_words_in_the_installed_pages(package, comes_with_pages, tmp_path):
    browser = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if browser is None or not can_go_offline():
        pytest.skip("no Chromium here, or no way to take its network away")
    with zipfile.ZipFile(package) as archive:
        archive.extractall(tmp_path)
    page = (tmp_path / "semref" / "help" / "index.html").as_uri()
    options = ["--headless=new", "--no-sandbox", "--disable-gpu", f"--user-data-dir={tmp_path / 'browser'}"]
    command = [*OFFLINE, browser, *options, "--virtual-time-budget=8000", "--dump-dom", f"{page}?q=minimum+area"]
    shown = subprocess.run(command, capture_output=True, text=True, timeout=TIMEOUT_S, check=False).stdout
    found = re.search(r"(\d+) matching documents", shown)
    assert found is not None and int(found[1]) > 3
