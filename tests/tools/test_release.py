from __future__ import annotations

import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
RELEASE = ROOT / "tools" / "release"
sys.path.append(str(RELEASE))

import changelog  # noqa: E402
import check_zip  # noqa: E402
import metadata  # noqa: E402
import package  # noqa: E402
import release  # noqa: E402

CHANGELOG = """# Changelog

## [1.1.0] – 2027-01-02

### News

- *Two things* are
  new, see [here](page.md).
- And `three`.

### All that is new

- Much more.

## [1.0.0] – 2026-12-01

### News

- First.
"""
HABITS = [*(ROOT / ".github").rglob("*.yml"), ROOT / "CITATION.cff"]


def test_the_news_of_a_version_are_plain_sentences_and_nothing_of_the_rest():
    newest, oldest = changelog.releases(CHANGELOG)
    assert newest == changelog.Release("1.1.0", "2027-01-02", ("Two things are new, see here.", "And three."))
    assert oldest.news == ("First.",)


def test_the_plugin_manager_shows_the_newest_version_first():
    newest = ["1.1.0 (2027-01-02)", "  - Two things are new, see here.", "  - And three."]
    assert changelog.for_metadata(CHANGELOG).splitlines() == [*newest, " 1.0.0 (2026-12-01)", "  - First."]


def test_shipped_metadata_has_the_news_of_the_changelog_and_every_language_by_each_of_its_names():
    shipped = metadata.general(metadata.shipped_metadata())
    newest = changelog.releases((ROOT / "CHANGELOG.md").read_text(encoding="utf-8"))[0]
    assert shipped["changelog"].startswith(f"{shipped['version']} ({newest.date})\n- {newest.news[0]}")
    assert shipped["description[zh-Hans]"] == shipped["description[zh]"] != shipped["description"]
    assert "地标" in shipped["description[zh]"] and shipped["description[de]"].startswith("Findet")
    assert (shipped["qgisMinimumVersion"], shipped["qgisMaximumVersion"]) == ("3.22", "4.99")
    assert shipped["hasProcessingProvider"] == "yes" and "supportsQt6" not in shipped


def test_addresses_that_nobody_filled_in_are_named():
    text = "[general]\nemail=a@example.org\nhomepage=https://forge.net/a\nrepository=https://forge.net/a\n"
    left = ["email=a@example.org", "tracker=example.org", "SECURITY-KEY"]
    assert metadata.placeholders(text, "Write to a@b.org (key: SECURITY-KEY).") == left


@pytest.fixture
def contents(sample, tmp_path) -> dict[str, bytes]:
    """Return the files of a zip of this repository, with placeholders for guide pages and translations."""
    target = tmp_path / "made.zip"
    package.write_package(target)
    with zipfile.ZipFile(target) as archive:
        found = {name: archive.read(name) for name in archive.namelist()}
    for language in ("de", "es", "fr", "zh_Hans"):
        found.setdefault(f"semref/i18n/semref_{language}.qm", b"\xb8")
    return {**found, check_zip.HELP_START: b"<html></html>"}


@pytest.fixture
def faults(contents, tmp_path):
    """`faults(version, name=content, …)`: faults of the zip with these files changed; None removes one."""

    def found(version: str = "", changed: dict | None = None) -> list[str]:
        target = tmp_path / "looked_at.zip"
        with zipfile.ZipFile(target, "w") as archive:
            for name, content in {**contents, **(changed or {})}.items():
                if content is not None:
                    archive.writestr(name, content)
        return check_zip.faults(target, version)

    return found


@pytest.mark.slow
def test_the_zip_of_this_repository_is_in_order_but_not_that_of_another_version_than_the_tag(faults):
    assert faults(metadata.plugin_version()) == []
    assert faults("9.9.9") == [f"metadata.txt has version {metadata.plugin_version()}, not 9.9.9."]


@pytest.mark.slow
def test_the_same_source_gives_the_same_zip(sample, tmp_path):
    made = [tmp_path / name for name in ("one.zip", "two.zip")]
    for target in made:
        package.write_package(target)
    assert made[0].read_bytes() == made[1].read_bytes()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({check_zip.HELP_START: None}, "guide is missing"),
        ({check_zip.SAMPLE_MARKER: None}, "sample area is missing"),
        ({"semref/i18n/semref_fr.qm": None}, "translation into fr is missing"),
        ({"semref/tests/test_x.py": b""}, "not for users"),
        ({"other/x.py": b""}, "is not in the folder semref"),
        ({"semref/core/new.py": b"match x:\n    case 1: pass\n"}, "new.py"),
        ({"semref/help/x.html": b"\xff\xfe"}, "x.html"),
        ({"semref/resources/x.txt": b"a\0b"}, "x.txt is binary"),
        ({"semref/CITATION.cff": b"version: 9.9.9\n"}, "CITATION.cff does not have version"),
        ({"semref/CHANGELOG.md": b"## [9.9.9]\n"}, "CHANGELOG.md does not begin with"),
        ({"semref/resources/icon.svg": None}, "icon resources/icon.svg is missing"),
        ({"semref/metadata.txt": b"[general]\nabout=100 %\n"}, "about has a per cent sign"),
    ],
)
def test_faults_of_a_zip_are_reported(faults, changed, message):
    assert any(message in fault for fault in faults("", changed))


@pytest.mark.parametrize("path", HABITS, ids=[path.name for path in HABITS])
def test_files_that_a_forge_reads_can_be_read(path):
    yaml = pytest.importorskip("yaml")
    assert isinstance(yaml.safe_load(path.read_text(encoding="utf-8")), dict)


@pytest.mark.skipif(shutil.which("git") is None, reason="git is not installed")
def test_a_release_of_a_missing_tag_shows_how_to_make_it(tmp_path):
    subprocess.run(["git", "init", "--quiet", str(tmp_path)], check=True)
    with pytest.raises(SystemExit, match="git tag -a v9.9.9"):
        release.release(tmp_path, "v9.9.9", tmp_path / "dist")


@pytest.mark.slow
def test_one_command_goes_from_a_tag_to_a_checked_zip_with_its_hash(tmp_path):
    if not (release.DOCS_ENVIRONMENT / "state").is_file():
        pytest.skip("the guide's pages were never made here: tools/docs/build_site.py")
    copy = tmp_path / "repository"
    shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns(".*", "help", "demo", "dist", "__pycache__"))
    git = ["git", "-C", str(copy), "-c", "user.name=t", "-c", "user.email=t@t"]
    tag = f"v{metadata.plugin_version()}"
    for command in (["init", "-q"], ["add", "-A"], ["commit", "-qm", "x"], ["tag", "-a", tag, "-m", tag]):
        subprocess.run([*git, *command], check=True)
    target = release.release(copy, tag, tmp_path / "dist")
    assert target.name == f"semref-{tag[1:]}.zip"
    assert subprocess.run(["sha256sum", "-c", "--quiet", f"{target.name}.sha256"], cwd=target.parent).returncode == 0
    assert check_zip.HELP_START in zipfile.ZipFile(target).namelist()
