"""Missing Python packages: the real pip installs small wheels made here, without a network."""

import hashlib
import importlib.util
import json
import shlex
import sys
import sysconfig
import time
import zipfile
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QCoreApplication, QTranslator

from semref.core.errors import ComponentError
from semref.plugin import SemRefPlugin
from semref.processing.packages import components
from semref.processing.packages import install as component_install
from semref.processing.packages.components import Package
from semref.ui.packages.component_installer import ComponentInstaller

needs_pip = pytest.mark.skipif(importlib.util.find_spec("pip") is None, reason="this Python has no pip")

DEADLINE_S = 300
EXT_SUFFIX = sysconfig.get_config_var("EXT_SUFFIX")
GOOD = Package("Made", "semref_made", "semref-made")
BROKEN = Package("Broken", "semref_broken", "semref-broken")


def make_wheel(folder: Path, package: Package, code: str, pip_name: str = "") -> None:
    """Write a wheel of one module; its requirement of another numpy must be ignored."""
    name = (pip_name or package.pip_name).replace("-", "_")
    information = f"{name}-1.0.dist-info"
    metadata = f"Metadata-Version: 2.1\nName: {pip_name or package.pip_name}\nVersion: 1.0\nRequires-Dist: numpy>=9\n"
    files = {
        f"{package.module}/__init__.py": code,
        f"{information}/METADATA": metadata,
        f"{information}/WHEEL": "Wheel-Version: 1.0\nGenerator: test\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
    }
    files[f"{information}/RECORD"] = "".join(f"{path},,\n" for path in [*files, f"{information}/RECORD"])
    folder.mkdir(exist_ok=True)
    with zipfile.ZipFile(folder / f"{name}-1.0-py3-none-any.whl", "w") as wheel:
        for path, text in files.items():
            wheel.writestr(path, text)


@pytest.fixture
def wheels(tmp_path) -> Path:
    make_wheel(tmp_path / "wheels", GOOD, "import numpy\nVALUE = 7\n")
    make_wheel(tmp_path / "wheels", BROKEN, "raise ImportError('compiled for another numpy')\n")
    return tmp_path / "wheels"


@pytest.fixture
def root(qgis_app, tmp_path, monkeypatch) -> Path:
    """Return SemRef's folder in an empty profile; path and modules are restored afterwards."""
    monkeypatch.setattr(QgsApplication, "qgisSettingsDirPath", staticmethod(lambda: str(tmp_path / "profile")))
    monkeypatch.setattr(components, "PACKAGES", (GOOD, BROKEN))
    path = list(sys.path)
    yield components.components_root()
    sys.path[:] = path
    sys.modules.pop(GOOD.module, None)
    importlib.invalidate_caches()


@pytest.fixture
def installer(qgis_app):
    """Return an installer; `.ends` has its messages."""
    made, ends = ComponentInstaller(), []
    made.failed.connect(ends.append)
    for name in ("installed", "canceled"):
        getattr(made, name).connect(lambda name=name: ends.append(name))
    made.ends = ends
    yield made
    made.cancel()


def end_of(installer) -> str:
    deadline = time.monotonic() + DEADLINE_S
    while not installer.ends:
        assert time.monotonic() < deadline, f"the installation did not end; pip said: {installer.log}"
        QCoreApplication.processEvents()
        time.sleep(0.01)
    return installer.ends[0]


def is_tidy(root: Path) -> bool:
    """Return whether no package and no temporary files remain."""
    return not root.exists() or [path for path in root.rglob("*") if path.name.startswith(".") or path.is_file()] == []


@pytest.mark.slow
@needs_pip
def test_a_package_is_installed_without_a_network_and_can_be_used_at_once(root, wheels, installer):
    numpy_path = np.__file__
    installer.start(component_install.installing([GOOD], str(wheels)))
    assert end_of(installer) == "installed", installer.log
    module = importlib.import_module(GOOD.module)
    assert module.VALUE == 7
    folder = root / components.components_key(sys.version_info, np.__version__) / GOOD.pip_name
    assert Path(module.__file__).is_relative_to(folder)
    assert sys.path[-1] == str(folder), "what QGIS has must come first"
    assert not list(folder.parent.glob(".*")) and not list(folder.rglob("numpy*"))
    assert importlib.util.find_spec("numpy").origin == numpy_path


@pytest.mark.slow
@needs_pip
def test_what_cannot_be_imported_is_removed_and_explained_and_the_others_are_installed(root, wheels, installer):
    installer.start(component_install.installing([BROKEN, GOOD], str(wheels)))
    sentence = end_of(installer)
    assert "semref-broken" in sentence and "compiled for another numpy" in sentence and np.__version__ in sentence
    assert "removed" in sentence
    assert not components.is_missing(GOOD)
    assert components.is_missing(BROKEN)
    assert [path.name for path in components.components_folder().iterdir()] == [GOOD.pip_name]


def test_a_cancel_leaves_nothing_and_what_was_there_as_it_was(root, wheels, installer, use_python):
    script = f'case "$1" in -c) {answers()};; *) touch "${{@: -1}}"; exec sleep 60;; esac'
    use_python(script)
    path = list(sys.path)
    installer.start(component_install.installing([GOOD], str(wheels)))
    deadline = time.monotonic() + DEADLINE_S
    while not list(root.rglob("tmp")):
        assert time.monotonic() < deadline
        QCoreApplication.processEvents()
    began = time.monotonic()
    installer.cancel()
    assert time.monotonic() - began < 30  # Half of the time that the process sleeps.
    assert installer.ends == ["canceled"] and not installer.running
    assert is_tidy(root) and sys.path == path


@pytest.fixture
def use_python(tmp_path, monkeypatch):
    """`use_python(script)` makes a shell script the Python of QGIS; returns its path."""

    def use(script: str) -> str:
        path = tmp_path / "python3"
        path.write_text(f"#!/bin/sh\n{script}\n")
        path.chmod(0o755)
        monkeypatch.setattr(component_install, "python_candidates", lambda *a: [str(path), str(tmp_path / "missing")])
        return str(path)

    return use


def test_a_python_without_pip_is_explained(root, installer, use_python):
    python = use_python(answers(pip=False))
    installer.start(component_install.installing([GOOD]))
    sentence = end_of(installer)
    assert f"{python}, the Python of QGIS, has no pip" in sentence and "install it with “" in sentence
    assert is_tidy(root)


def answers(pip=True, version=sys.version, ending=EXT_SUFFIX):
    return "echo " + shlex.quote(json.dumps({"build": [version, ending], "pip": pip}).replace("\\", "\\\\"))


ANOTHER = sys.version.replace("(", "(another build, ")
OTHER_BUILDS = [answers(version=ANOTHER), answers(ending=".cpython-27d.so"), "echo 3 11 True", "echo '[]'"]


@pytest.mark.parametrize("script", [*OTHER_BUILDS, "exit 3", "kill -9 $$"])
def test_a_python_of_another_build_or_a_broken_one_is_not_used(root, installer, use_python, script):
    python = use_python(script)
    installer.start(component_install.installing([GOOD]))
    sentence = end_of(installer)
    assert sentence.startswith("The Python 3.") and python in sentence and is_tidy(root)


@needs_pip
def test_a_folder_that_cannot_be_made_is_explained(root, tmp_path, wheels, installer):
    (tmp_path / "profile").write_text("a file")
    installer.start(component_install.installing([GOOD], str(wheels)))
    assert "semref-made cannot be installed" in end_of(installer)


def test_each_failure_is_reported_but_what_concerns_all_packages_only_once(qgis_app, tmp_path, monkeypatch):
    monkeypatch.setattr(components, "components_root", lambda: tmp_path)

    def outcome(*outputs):
        commands = component_install.installing([GOOD, BROKEN, replace(GOOD, pip_name="semref-third")])
        command = next(commands)
        left = list(outputs)
        with pytest.raises(ComponentError) as caught:
            while True:
                asks = command.arguments[0] == "-c"
                found = {"build": component_install.running_build(), "pip": True}
                answer = (0, json.dumps(found)) if asks else (1, left.pop(0))
                command = commands.send(component_install.Answer(*answer))
        return str(caught.value), left

    sentence, left = outcome("", "DO NOT MATCH THE HASHES", "")
    assert sentence.index("semref-made") < sentence.index("semref-broken") < sentence.index("semref-third")
    offline = "Retrying (Retry(total=0))\nERROR: No matching distribution found for semref-{}"
    sentence, left = outcome(offline.format("made"), offline.format("broken"), "")
    assert sentence.count("cannot be reached") == 1 and left == [""]


@pytest.mark.slow
def test_removing_takes_the_folder_and_its_part_of_the_path(root, wheels, installer):
    installer.start(component_install.installing([GOOD], str(wheels)))
    end_of(installer)
    components.remove_components()
    assert not root.exists()
    assert [entry for entry in sys.path if entry.startswith(str(root))] == []
    assert components.is_missing(GOOD)


@pytest.mark.slow
@needs_pip
@pytest.mark.parametrize("is_right", [True, False])
def test_only_a_wheel_with_the_pinned_hash_is_installed(root, wheels, installer, monkeypatch, is_right):
    (wheel,) = wheels.glob("semref_made*.whl")
    monkeypatch.setenv("PIP_NO_INDEX", "1")
    monkeypatch.setenv("PIP_FIND_LINKS", str(wheels))
    sha256 = hashlib.sha256(wheel.read_bytes()).hexdigest() if is_right else "0" * 64
    monkeypatch.setattr(Package, "pinned", lambda *a: [f"semref-made==1.0 --hash=sha256:{sha256}"])
    installer.start(component_install.installing([GOOD]))
    if is_right:
        assert end_of(installer) == "installed" and importlib.import_module(GOOD.module).VALUE == 7
    else:
        assert "sent a different file for semref-made" in end_of(installer)
        assert is_tidy(root) and components.is_missing(GOOD)


def test_a_package_without_its_newest_part_is_too_old(qgis_app, tmp_path, monkeypatch):
    old = Package("Old", "semref_old", "old", newest_part="newest")
    folder = tmp_path / "semref_old"
    folder.mkdir()
    (folder / "__init__.py").write_text("raise ImportError('is not imported')\n")
    monkeypatch.setattr(sys, "path", [*sys.path, str(tmp_path)])
    importlib.invalidate_caches()
    assert components.is_missing(old) and components.is_too_old(old)
    (folder / "newest.py").write_text("")
    importlib.invalidate_caches()
    assert not components.is_missing(old) and components.installed_version(old) == ""


def test_the_plugin_adds_what_is_installed_to_the_end_of_the_path(root, without_provider):
    folder = components.components_folder() / GOOD.pip_name
    folder.mkdir(parents=True)
    plugin = SemRefPlugin(None)
    plugin.initProcessing()
    plugin.unload()
    assert sys.path[-1] == str(folder)


def test_the_plugin_follows_the_language_that_qgis_was_started_with(qgis_app, without_provider, monkeypatch):
    plugin, before, asked = SemRefPlugin(None), qgis_app.translation(), []
    monkeypatch.setattr(QTranslator, "load", lambda _self, locale, *_names: asked.append(locale.name()))
    qgis_app.setTranslation("de")
    plugin.initProcessing()
    qgis_app.setTranslation(before)
    plugin.unload()
    assert asked == ["de_DE"]
