"""Pin the wheels that *Settings ▸ Options ▸ SemRef* installs, with their hashes in the package index of today.

    .venv/bin/python tools/release/pin_wheels.py [--check]

The files in processing/packages/ have one requirement per line in pip's format, for numpy 1 and for numpy 2. To pin
another version, edit it there and run this script, which writes the hashes of all lines again. Pin versions that passed
the tests (tools/requirements.txt, tools/test_newest.sh). ``--check`` writes nothing and exits with 1 if the index has
another hash for a wheel, or does not have the wheel.
"""

import argparse
import functools
import json
import re
import sys
import urllib.request
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "processing" / "packages"
FILES = ("wheels_numpy1.txt", "wheels_numpy2.txt")
INDEX = "https://pypi.org/simple/{name}/"
FORMAT = "application/vnd.pypi.simple.v1+json"
_NO_SYSTEM_OF_QGIS = re.compile(r"-(cp3[678]|pp\d+)-|-cp3\d+t-|musllinux|win32\.whl")
"""Wheels that are not pinned: Python before 3.9, PyPy, free-threaded Python, and systems without QGIS."""


@functools.cache
def files_of(name: str) -> list[dict]:
    """Return the files of a package in the index, with file name and hashes."""
    asked = urllib.request.Request(INDEX.format(name=name), headers={"Accept": FORMAT})
    with urllib.request.urlopen(asked, timeout=60) as answer:
        return json.load(answer)["files"]


def wheel_hashes(name: str, version: str) -> list[str]:
    """Return the SHA-256 of each wheel of a version, sorted by file name; abi3 wheels name their oldest Python."""
    start = f"{name.replace('-', '_')}-{version}-"
    wheels = {
        file["filename"]: file["hashes"]["sha256"]
        for file in files_of(name)
        if file["filename"].startswith(start) and file["filename"].endswith(".whl")
    }
    return [wheels[n] for n in sorted(wheels) if "abi3" in n or not _NO_SYSTEM_OF_QGIS.search(n)]


def pinned(line: str) -> str:
    """Return a requirement with the hashes of the index; a comment is unchanged."""
    requirement = re.match(r"(?P<name>[\w.-]+)==(?P<version>\S+)[^#]*?(?= --hash|$)", line)
    if requirement is None:
        return line
    return " --hash=sha256:".join([requirement[0], *wheel_hashes(requirement["name"], requirement["version"])])


def main() -> int:
    """Write the files, or compare them with the index."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    status = 0
    for file in FILES:
        before = (FOLDER / file).read_text(encoding="ascii")
        text = "\n".join(map(pinned, before.splitlines())) + "\n"
        if options.check:
            lacking = set(before.split()) - set(text.split())
            print(f"{file}: {'all wheels are in the index' if not lacking else f'not in the index: {sorted(lacking)}'}")
            status |= bool(lacking)
        else:
            (FOLDER / file).write_text(text, encoding="ascii")
    return status


if __name__ == "__main__":
    sys.exit(main())
