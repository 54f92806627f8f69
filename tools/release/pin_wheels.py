"""Writes which wheels *Settings ▸ Options ▸ SemRef* installs, with their hashes, as the package index tells them today.

    .venv/bin/python tools/release/pin_wheels.py [--check]

One requirement a line in pip's format, for Pythons with numpy 1 and with numpy 2, in processing/packages/. The versions
stand below: ones that tests passed with (tools/requirements.txt, tools/test_newest.sh). ``--check`` writes nothing and
ends with 1 where the index tells another hash than the file, or lacks a wheel that the file has.
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
"""With all that it needs of others, which come with it."""
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
    ("onnxruntime-gpu", "1.19.2", OLD),
    ("onnxruntime-directml", "1.19.2", OLD),
    ("onnxruntime-openvino", "1.19.0", OLD),
    ("onnxruntime-gpu", "1.23.2", BEFORE_NEW),
    ("onnxruntime-directml", "1.23.0", BEFORE_NEW),
    ("onnxruntime-openvino", "1.23.0", BEFORE_NEW),
    ("onnxruntime-gpu", "1.31.1", NEW),
    ("onnxruntime-directml", "1.24.4", NEW),
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
"""Wheels for Pythons before 3.9, PyPy, Pythons without a lock, and systems that QGIS is not made for."""


@functools.cache
def files_of(name: str) -> list[dict]:
    """What the index has of a package: filename and hashes of each file."""
    asked = urllib.request.Request(INDEX.format(name=name), headers={"Accept": FORMAT})
    with urllib.request.urlopen(asked, timeout=60) as answer:
        return json.load(answer)["files"]


def wheel_hashes(name: str, version: str) -> list[str]:
    """The SHA-256 of each wheel of a version, sorted by file name; abi3 wheels carry their oldest Python's name."""
    start = f"{name.replace('-', '_')}-{version}-"
    wheels = {
        file["filename"]: file["hashes"]["sha256"]
        for file in files_of(name)
        if file["filename"].startswith(start) and file["filename"].endswith(".whl")
    }
    return [wheels[n] for n in sorted(wheels) if "abi3" in n or not _NO_SYSTEM_OF_QGIS.search(n)]


def line(name: str, version: str, marker: str) -> str:
    """One requirement in pip's format."""
    condition = f" ; {marker}" if marker else ""
    return f"{name}=={version}{condition} " + " ".join(f"--hash=sha256:{text}" for text in wheel_hashes(name, version))


def main() -> int:
    """Writes the files, or compares them."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    status = 0
    for file, pins in PINS.items():
        text = "\n".join(["# Written by tools/release/pin_wheels.py.", *(line(*pin) for pin in pins)]) + "\n"
        if options.check:
            lacking = set((FOLDER / file).read_text(encoding="ascii").split()) - set(text.split())
            print(f"{file}: {'the index has it all' if not lacking else f'not in the index: {sorted(lacking)}'}")
            status |= bool(lacking)
        else:
            (FOLDER / file).write_text(text, encoding="ascii")
    return status


if __name__ == "__main__":
    sys.exit(main())
