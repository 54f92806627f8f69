"""Write which wheels *Settings ▸ Options ▸ SemRef* installs, with the hashes in the package index of today.

    .venv/bin/python tools/release/pin_wheels.py [--check]

The files in processing/packages/ have one requirement per line in pip's format, for numpy 1 and for numpy 2. The
versions below passed the tests (tools/requirements.txt, tools/test_newest.sh). ``--check`` writes nothing
and exits with 1 if the index has another hash for a wheel, or does not have the wheel.
"""

from __future__ import annotations

import argparse
import functools
import json
import re
import sys
import urllib.request
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "processing" / "packages"
INDEX = "https://pypi.org/simple/{name}/"
FORMAT = "application/vnd.pypi.simple.v1+json"
OLD, MIDDLE, NEW = 'python_version < "3.10"', 'python_version >= "3.10"', 'python_version >= "3.14"'
BEFORE_NEW = 'python_version >= "3.10" and python_version < "3.14"'
DASK = (
    ("distributed", "2024.8.0", OLD),
    ("dask", "2024.8.0", OLD),
    ("msgpack", "1.1.2", OLD),
    ("urllib3", "2.8.0", OLD),
    ("distributed", "2026.8.0", MIDDLE),
    ("dask", "2026.8.0", MIDDLE),
    ("msgpack", "1.2.4", MIDDLE),
    *(("click", "8.5.0", ""), ("cloudpickle", "3.1.2", ""), ("fsspec", "2026.9.0", ""), ("jinja2", "3.1.6", "")),
    *(
        ("importlib_metadata", "9.0.1", ""),
        ("locket", "1.0.0", ""),
        ("markupsafe", "3.0.4", ""),
        ("tblib", "3.2.2", ""),
    ),
    *(("packaging", "26.3", ""), ("partd", "1.4.2", ""), ("psutil", "7.2.2", ""), ("pyyaml", "6.0.3", "")),
    *(("sortedcontainers", "2.4.0", ""), ("toolz", "1.2.0", ""), ("tornado", "6.5.10", ""), ("zict", "3.0.0", "")),
    ("zipp", "4.1.0", ""),
)
"""Packages, each with its dependencies."""
CRYPTOGRAPHY = (
    *(("cryptography", "46.0.7", ""), ("cffi", "2.0.0", ""), ("pycparser", "2.23", "")),
    ("typing_extensions", "4.15.0", ""),
)
SHARED = (
    ("pillow", "11.3.0", OLD),
    ("pillow", "12.3.0", MIDDLE),
    *DASK,
    *CRYPTOGRAPHY,
    ("shapely", "2.0.7", OLD),
    ("shapely", "2.1.2", MIDDLE),
    ("onnxruntime", "1.19.2", OLD),
)
PINS = {
    "wheels_numpy1.txt": (
        ("opencv-python-headless", "4.11.0.86", ""),
        *SHARED,
        ("onnxruntime", "1.23.2", MIDDLE),
    ),
    "wheels_numpy2.txt": (
        ("opencv-python-headless", "5.0.0.93", ""),
        *SHARED,
        ("onnxruntime", "1.23.2", BEFORE_NEW),
        ("onnxruntime", "1.31.1", NEW),
    ),
}
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


def line(name: str, version: str, marker: str) -> str:
    """Return a requirement in pip's format."""
    condition = f" ; {marker}" if marker else ""
    return f"{name}=={version}{condition} " + " ".join(f"--hash=sha256:{text}" for text in wheel_hashes(name, version))


def main() -> int:
    """Write the files, or compare them with the index."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    status = 0
    for file, pins in PINS.items():
        text = "\n".join(["# Written by tools/release/pin_wheels.py.", *(line(*pin) for pin in pins)]) + "\n"
        if options.check:
            lacking = set((FOLDER / file).read_text(encoding="ascii").split()) - set(text.split())
            print(f"{file}: {'all wheels are in the index' if not lacking else f'not in the index: {sorted(lacking)}'}")
            status |= bool(lacking)
        else:
            (FOLDER / file).write_text(text, encoding="ascii")
    return status


if __name__ == "__main__":
    sys.exit(main())
