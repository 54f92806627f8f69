"""Installation of Python packages with pip: a generator yields each command and receives its answer.

This module runs no command: the caller (ui's ComponentInstaller) runs them as processes and closes the generator on a
cancel. Each package is installed in a temporary folder and moved to its place when it can be imported.
"""

from __future__ import annotations

import functools
import json
import os
import re
import sys
import sysconfig
from collections.abc import Generator
from dataclasses import dataclass, field
from pathlib import Path

from qgis.core import QgsNetworkAccessManager
from qgis.PyQt.QtCore import QUrl
from qgis.PyQt.QtNetwork import QNetworkProxy

from ...core.errors import ComponentError, SemRefError, reason_of
from ...core.sentences import Sentence
from ...storage.atomic_output import folder_written_beside
from ..translation import tr
from .components import (
    Package,
    components_folder,
    components_root,
    how_to_get_pip,
    install_command,
    is_own,
    numpy_version,
    origin,
)


@dataclass(frozen=True)
class Command:
    """A program to run in ``folder``, with environment variables in addition to QGIS's own."""

    title: str
    program: str
    arguments: list[str]
    folder: str
    variables: dict[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Answer:
    """Result of a command: exit status (−1 if it could not be started or crashed) and all output."""

    status: int
    output: str


Commands = Generator[Command, Answer, None]


def installing(packages: list[Package], wheels: str = "") -> Commands:
    """Install packages one after the other, from the package index or from a folder of wheels.

    Raises:
        ComponentError: At the end, with the reason for each package that was not installed.
    """
    python = yield from _find_python(packages)
    reasons: list[Sentence] = []
    for package in packages:
        try:
            yield from _install_one(python, package, wheels)
        except SemRefError as error:
            if error.sentence in reasons:
                # The same reason twice, as without a network: the other packages would fail, too.
                break
            reasons.append(error.sentence)
    if reasons:
        raise ComponentError(
            functools.reduce(lambda first, second: Sentence("{first} {second}", first=first, second=second), reasons)
        )


# --- the interpreter ---

_ASK = """
import importlib.util, json, sys, sysconfig
build = [sys.version, sysconfig.get_config_var("EXT_SUFFIX")]
print(json.dumps({"build": build, "pip": importlib.util.find_spec("pip") is not None}))
"""


def running_build() -> list[str]:
    """Return what identifies QGIS's Python: version with date and compiler of its build, and suffix of its binaries."""
    return [sys.version, sysconfig.get_config_var("EXT_SUFFIX")]


def _find_python(packages: list[Package]) -> Generator[Command, Answer, str]:
    """Return the path of QGIS's own Python with pip.

    Another build of the same version, such as pyenv or conda, would install wheels that QGIS cannot load.
    """
    version = sys.version_info[:2]
    candidates = python_candidates(sys.executable or "", sys.prefix, version, os.name == "nt")
    without_pip = ""
    for path in filter(os.path.isfile, candidates):
        answer = yield Command(tr("Searching for the Python of QGIS…"), path, ["-c", _ASK], os.path.dirname(path))
        found = _answer_of(answer)
        if found.get("build") != running_build():
            continue
        if found.get("pip") is True:
            return path
        without_pip = without_pip or path
    if without_pip:
        raise ComponentError(
            "{python}, the Python of QGIS, has no pip. To continue, {how_to_get_pip}.",
            python=without_pip,
            how_to_get_pip=how_to_get_pip(),
        )
    raise ComponentError(
        "The Python {version} of QGIS was not found (searched: {paths}). Run “{command}” instead.",
        version=f"{version[0]}.{version[1]}",
        paths=", ".join(candidates),
        command=install_command(packages),
    )


def _answer_of(answer: Answer) -> dict[str, object]:
    """Return the output of _ASK; empty if it failed."""
    lines = answer.output.strip().splitlines()
    try:
        found = json.loads(lines[-1]) if answer.status == 0 and lines else {}
    except ValueError:
        return {}
    return found if isinstance(found, dict) else {}


def python_candidates(executable: str, prefix: str, version: tuple, windows: bool) -> list[str]:
    """Return possible paths of QGIS's Python, the most likely first.

    Args:
        executable: sys.executable, which may be QGIS itself, or the first on PATH.
        prefix: sys.prefix, the folder of the running Python.
        version: Its first two numbers.
    """
    if windows:
        return [os.path.join(prefix, "python.exe"), os.path.join(prefix, "python3.exe")]
    exact = f"python{version[0]}.{version[1]}"
    folders = [os.path.join(prefix, "bin"), os.path.join(os.path.dirname(executable), "bin"), "/usr/bin"]
    paths = [os.path.join(folder, name) for folder in folders for name in (exact, "python3")]
    if os.path.basename(executable).startswith("python"):
        paths.append(executable)
    return list(dict.fromkeys(paths))


# --- one package ---


def _install_one(python: str, package: Package, wheels: str) -> Commands:
    found = origin(package)
    if found and not is_own(package):
        # It is before SemRef's on Python's path.
        raise ComponentError("QGIS finds {path} first, which is too old for SemRef. Update or remove it.", path=found)
    try:
        package.folder.parent.mkdir(parents=True, exist_ok=True)
        with folder_written_beside(str(package.folder), replaces=True) as folder:
            yield from _fill(python, package, folder, wheels)
    except OSError as error:
        name = error.filename or package.folder
        raise ComponentError(
            "{package} cannot be installed: {reason}: {name}.",
            package=package.pip_name,
            reason=reason_of(error),
            name=name,
        ) from error


_CHECK = """
import importlib, json, sys
sys.path[:] = json.loads(sys.argv[1])
import numpy
if numpy.__version__ != sys.argv[3]:
    sys.exit("numpy is " + numpy.__version__ + ", not " + sys.argv[3])
module = importlib.import_module(sys.argv[2])
print(module.__file__)
"""


def _fill(python: str, package: Package, folder: str, wheels: str) -> Commands:
    temporary = Path(folder).parent / "tmp"
    temporary.mkdir()
    requirement = package.requirement(numpy_version())
    title = tr("Installing {package}…").format(package=package.pip_name)
    variables = pip_variables(str(temporary))
    asked = package.asked(numpy_version()) if wheels else _with_hashes(package, temporary)
    pip = yield Command(title, python, pip_arguments(asked, folder, wheels), str(temporary), variables)
    if pip.status != 0:
        raise ComponentError(why_pip_failed(requirement, pip.output, wheels))
    # The path of the next start: earlier installations of SemRef come after it.
    own = [entry for entry in sys.path if entry.startswith(str(components_root()))]
    path = json.dumps([*(entry for entry in sys.path if entry not in own), folder, *own])
    title = tr("Checking {package}…").format(package=package.pip_name)
    arguments = ["-c", _CHECK, path, package.needed_module, numpy_version()]
    check = yield Command(title, python, arguments, str(temporary), {"PYTHONDONTWRITEBYTECODE": "1"})
    if check.status != 0:
        raise ComponentError(
            "{package} was installed, but does not work with numpy {numpy}: {reason}. It was removed again.",
            package=requirement,
            numpy=numpy_version(),
            reason=last_line(check.output),
        )


_PIP_VARIABLES = {
    "PYTHONIOENCODING": "utf-8",
    # User settings for other installations do not apply to a folder of its own.
    "PIP_USER": "0",
    "PIP_REQUIRE_VIRTUALENV": "0",
}


def pip_variables(temporary: str) -> dict[str, str]:
    """Return the environment of pip; ``temporary``: its folder for unpacking."""
    variables = {**_PIP_VARIABLES, **dict.fromkeys(("TMPDIR", "TEMP", "TMP"), temporary)}
    proxy = proxy_url(QgsNetworkAccessManager.instance().fallbackProxy())
    if proxy:
        # In the environment, because it may contain a password and other users can see command lines.
        variables["PIP_PROXY"] = proxy
    return variables


def _with_hashes(package: Package, temporary: Path) -> list[str]:
    """Return pip's requirements with SemRef's versions and hashes, so that changed wheels are refused."""
    file = temporary / "wheels.txt"
    file.write_text("\n".join(package.pinned(numpy_version())) + "\n", encoding="ascii")
    return ["--require-hashes", "--requirement", str(file)]


def pip_arguments(asked: list[str], folder: str, wheels: str) -> list[str]:
    """Return pip's command line with the user's index. Without dependencies, because numpy must be QGIS's."""
    options = ["--no-deps", "--only-binary=:all:", "--no-input", "--disable-pip-version-check", "--progress-bar=off"]
    offline = ["--no-index", "--find-links", wheels] if wheels else []
    return ["-m", "pip", "install", *options, "--target", folder, *offline, *asked]


def proxy_url(proxy: QNetworkProxy) -> str:
    """Return ``http://host:3128``, with user and password if they are set; empty without a proxy."""
    schemes = {
        QNetworkProxy.ProxyType.HttpProxy: "http",
        QNetworkProxy.ProxyType.HttpCachingProxy: "http",
        QNetworkProxy.ProxyType.Socks5Proxy: "socks5",
    }
    if proxy.type() not in schemes or not proxy.hostName():
        return ""
    url = QUrl()
    url.setScheme(schemes[proxy.type()])
    url.setHost(proxy.hostName())
    url.setPort(proxy.port() or -1)
    if proxy.user():
        url.setUserName(proxy.user())
        url.setPassword(proxy.password())
    return bytes(url.toEncoded()).decode("ascii")


_NETWORK_TROUBLE = re.compile(
    "NewConnectionError|ConnectTimeout|ReadTimeout|NameResolutionError|Retrying \\(Retry|Proxy|SOCKS|CERTIFICATE_VERIFY"
)


def why_pip_failed(requirement: str, output: str, wheels: str) -> Sentence:
    python = f"{sys.version_info[0]}.{sys.version_info[1]}"
    if "DO NOT MATCH THE HASHES" in output or "--require-hashes mode" in output:
        return Sentence(
            "The package index sent a different file for {package} than the one tested with SemRef. Nothing was "
            "installed. Use the public index, or install from a folder of wheels that you trust.",
            package=requirement,
        )
    if "No space left" in output or "Errno 28" in output:
        return Sentence("The disk is full: {folder} needs about 500 MB. Free some space.", folder=components_folder())
    if _NETWORK_TROUBLE.search(output):
        return Sentence(
            "The package index cannot be reached. Check network, proxy and certificates under Settings ▸ Options ▸ "
            "Network, or install from a folder of wheels."
        )
    if "No matching distribution" in output and wheels:
        return Sentence(
            "{folder} contains no wheel of {package} for Python {python} on this system.",
            folder=wheels,
            package=requirement,
            python=python,
        )
    if "No matching distribution" in output:
        return Sentence(
            "The package index contains no {package} for Python {python} on this system.",
            package=requirement,
            python=python,
        )
    return Sentence("pip could not install {package}: {reason}.", package=requirement, reason=last_error(output))


def last_error(output: str) -> str:
    """Return pip's last error, as part of a sentence."""
    errors = "\n".join(line for line in output.splitlines() if line.startswith("ERROR:"))
    return last_line(errors or output).replace("ERROR: ", "")


def last_line(output: str) -> str:
    """Return the last line with text, as part of a sentence."""
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    return lines[-1].rstrip(".") if lines else tr("no message")
