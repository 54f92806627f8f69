"""The walk of a newcomer without a network: zip, help, sample, first fix, in desktop QGIS with a bare profile."""

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

import pytest
from desktop_qgis import TIMEOUT_S, run_desktop

pytestmark = pytest.mark.slow  # a QGIS of its own is started

OFFLINE = ("unshare", "--map-root-user", "--net")
"""A program started so has no network at all."""


def can_go_offline() -> bool:
    return shutil.which("unshare") is not None and subprocess.run([*OFFLINE, "true"]).returncode == 0


@pytest.fixture(scope="module")
def package(repository, tmp_path_factory) -> Path:
    target = tmp_path_factory.mktemp("package") / "semref.zip"
    command = [sys.executable, str(repository / "tools" / "release" / "package.py"), "--output", str(target)]
    subprocess.run(command, check=True, timeout=TIMEOUT_S)
    return target


@pytest.fixture(scope="module")
def walk(package, display, tmp_path_factory) -> dict:
    """What walk_install_session.py saw; SEMREF_PICTURES names a folder to keep it in."""
    home = tmp_path_factory.mktemp("walk")
    variables = {"SEMREF_ZIP": str(package), "SEMREF_SAMPLE": str(home / "sample")}
    script = Path(__file__).with_name("walk_install_session.py")
    (home / "sample").mkdir()
    seen = run_desktop(home, display, script, variables, OFFLINE if can_go_offline() else ())
    if "SEMREF_PICTURES" in os.environ:
        kept = Path(os.environ["SEMREF_PICTURES"]) / "walk_install.json"
        kept.write_text(json.dumps(seen, indent=1), encoding="utf-8")
    return seen


@pytest.fixture
def comes_with_pages(package):
    if "semref/help/user_guide.html" not in zipfile.ZipFile(package).namelist():
        pytest.skip("the guide's pages were not made of these docs: tools/docs/build_site.py")


def test_the_walk_is_without_a_network_where_that_can_be_had(walk):
    assert walk["reached"] is False or not can_go_offline()


def test_the_zip_installs_into_a_bare_profile_and_is_active_at_once(walk):
    assert (walk["was_there"], walk["active"]) == (False, True)
    assert walk["messages"] == [] and "Traceback" not in walk["output"]


def test_the_plugin_manager_describes_it_in_the_users_language_and_shows_what_is_new(walk):
    told = walk["manager"]
    assert told["en_US"]["description"].startswith("Find the position")
    assert told["de"]["description"].startswith("Findet")
    assert "地标" in told["zh-Hans"]["description"]
    assert told["en_US"]["changelog"].startswith(told["en_US"]["version_installed"])


def test_every_help_opens_a_page_that_came_with_the_zip(walk, comes_with_pages):
    names = [Path(unquote(urlparse(address).path)).name for address in walk["help"]]
    assert names == ["user_guide.html", "user_guide.html", "builddatabase.html"]
    assert [address for address in walk["help"] if not address.startswith("file:///")] == []


def test_all_photos_of_the_sample_are_localized(walk):
    assert walk["rows"] == 12


def test_qgis_quits_at_once_though_the_dock_still_reads(walk):
    assert walk["exit_status"] == 0, walk["output"]


def test_a_browser_without_a_network_finds_words_in_the_installed_pages(package, comes_with_pages, tmp_path):
    browser = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if browser is None or not can_go_offline():
        pytest.skip("no Chromium here, or no way to take its network away")
    with zipfile.ZipFile(package) as archive:
        archive.extractall(tmp_path)
    page = (tmp_path / "semref" / "help" / "user_guide.html").as_uri()
    options = ["--headless=new", "--no-sandbox", "--disable-gpu", f"--user-data-dir={tmp_path / 'browser'}"]
    command = [*OFFLINE, browser, *options, "--virtual-time-budget=8000", "--dump-dom", f"{page}?q=minimum+area"]
    shown = subprocess.run(command, capture_output=True, text=True, timeout=TIMEOUT_S, check=False).stdout
    found = re.search(r"(\d+) matching documents", shown)
    assert found is not None and int(found[1]) > 3
