"""Tests mirror the rooms: a module of core has its test file at the same place under tests/core."""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ROOMS_WITH_SENTENCES = (
    *("assessment", "database", "flight", "geometry", "labels", "localization", "onboard", "segmentation"),
)
DATA_ONLY = {
    "geometry/error_settings.py",
    *(f"{solver}/settings.py" for solver in ("constellation", "correlation", "flight", "localizer")),
    *(f"sentences/{room}.py" for room in ROOMS_WITH_SENTENCES),
}
"""Modules of nothing but values: settings are held to their page by test_calibration.py, tables of sentences to the
codes in the source by test_sentences.py."""

LACKING: set[str] = set()
"""Modules whose tests still lie in a neighbor's file; the list only shrinks."""


def modules_without_tests():
    modules = (path.relative_to(ROOT / "core") for path in (ROOT / "core").rglob("*.py"))
    return {
        module.as_posix()
        for module in modules
        if not module.name.startswith("__")
        and not (ROOT / "tests" / "core" / module.parent / f"test_{module.name}").exists()
    }


def test_every_module_of_core_has_its_test_file():
    assert sorted(modules_without_tests() - LACKING - DATA_ONLY) == []


def test_what_has_a_test_file_is_in_neither_list():
    assert sorted((LACKING | DATA_ONLY) - modules_without_tests()) == []
