"""Build a checked zip from a tag: .venv/bin/python tools/release/release.py v0.2.0 [--output FOLDER].

The script clones the tag, builds the documentation, packages and checks the plugin, and writes the zip and its SHA-256.
It ignores changes in the working tree, creates no tag, and uploads nothing.
"""

import argparse
import hashlib
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from check_zip import faults

ROOT = Path(__file__).resolve().parents[2]
DOCS_ENVIRONMENT = ROOT / ".venv-docs"


def release(repository: Path, tag: str, folder: Path, docs_environment: Path = DOCS_ENVIRONMENT) -> Path:
    """Write semref-VERSION.zip and its .sha256 to the folder; exit at a fault."""
    version = tag[1:] if tag.startswith("v") else tag
    _require_tag(repository, tag)
    with tempfile.TemporaryDirectory(prefix="semref-release-") as temporary:
        clone, made = Path(temporary) / "semref", Path(temporary) / f"semref-{version}.zip"
        clone_quietly = ["git", "-c", "advice.detachedHead=false", "clone", "--quiet", "--branch", tag]
        _run([*clone_quietly, str(repository), str(clone)])
        _run([sys.executable, str(clone / "tools/docs/build_site.py"), "--environment", str(docs_environment)])
        _run([sys.executable, str(clone / "tools/release/package.py"), "--output", str(made)])
        found = faults(made, version)
        if found:
            sys.exit("\n".join(found))
        folder.mkdir(parents=True, exist_ok=True)
        target = Path(shutil.copy(made, folder))
    digest = hashlib.sha256(target.read_bytes()).hexdigest()
    target.with_name(f"{target.name}.sha256").write_text(f"{digest}  {target.name}\n", encoding="ascii")
    return target


def _require_tag(repository: Path, tag: str) -> None:
    known = subprocess.run(
        ["git", "-C", str(repository), "tag", "--list", tag], capture_output=True, text=True, check=True
    ).stdout.split()
    if tag not in known:
        sys.exit(f"There is no tag {tag}. Create it with: git tag -a {tag} -m 'SemRef {tag.lstrip('v')}'")


def _run(command: list[str]) -> None:
    ended = subprocess.run(command, check=False)
    if ended.returncode:
        sys.exit(f"{' '.join(command)} ended with {ended.returncode}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tag")
    parser.add_argument("--output", type=Path, default=ROOT / "dist")
    arguments = parser.parse_args()
    target = release(ROOT, arguments.tag, arguments.output)
    print(f"{target} ({target.stat().st_size / 1024**2:.1f} MB), checked")


if __name__ == "__main__":
    main()
