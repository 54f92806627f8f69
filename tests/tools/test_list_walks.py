"""The clicks, keys and seconds of the walks: as their tests kept them, on the page of each walk."""

from __future__ import annotations

import importlib.util
import json
import shutil

import pytest


@pytest.fixture(scope="module")
def tool(repository):
    spec = importlib.util.spec_from_file_location("list_walks", repository / "tools" / "docs" / "list_walks.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def kept(tmp_path):
    """A folder as the tests leave it, one walk by mouse alone."""
    took = {"clicks": 4, "keys": 0, "values": 3, "seconds": 12.6}
    mouse = {"own photos": took, "inspect": {**took, "values": 1}, "messages": []}
    (tmp_path / "walk_job_mouse.json").write_text(json.dumps(mouse))
    (tmp_path / "walk_job_keys.json").write_text(json.dumps({"own photos": {**took, "clicks": 0, "keys": 31}}))
    (tmp_path / "walk_install.json").write_text(json.dumps({"seconds": {"install": 4.2}}))
    return tmp_path


def test_every_walk_has_its_line_on_its_page_once(tool, repository):
    for name, (_, page) in tool.PAGES.items():
        text = (repository / "docs" / page).read_text(encoding="utf-8")
        assert [mark for (mark,) in ((m[1],) for m in tool.LINE.finditer(text)) if mark == name] == [name], page


def test_the_table_and_the_lines_are_what_was_kept(tool, kept, repository, tmp_path):
    docs = tmp_path / "docs"
    shutil.copytree(repository / "docs", docs, ignore=shutil.ignore_patterns("images"))
    tool.write(docs, tool.walks(kept), "today")
    written = (docs / tool.PAGE).read_text(encoding="utf-8")
    rows = [row for row in written.partition(tool.BEGIN)[2].partition(tool.END)[0].splitlines() if "](" in row]
    assert [row.rpartition("](")[2].partition(") ")[2] for row in rows] == [
        "| 3 | – | 1 | 4 | 3, 1, – |",
        "| 4 | 31 | 3 | 13 | 4, 3, 8 |",
        "| 4 | – | 1 | 13 | 7, 1, 4 |",
    ]
    photos, guide = ((docs / page).read_text(encoding="utf-8") for page in ("guide/own_photos.md", "user_guide.md"))
    assert "*At the least: 4 clicks, or 31 keys without the mouse, 3 values to type or choose, 13 s until" in photos
    assert "*At the least: 4 clicks, 1 value to type or choose, 13 s until it is done" in guide


def test_walks_that_were_not_gone_keep_their_lines(tool, tmp_path, repository):
    docs = tmp_path / "docs"
    shutil.copytree(repository / "docs", docs, ignore=shutil.ignore_patterns("images"))
    tool.write(docs, {}, "today")
    for page in {page for _, page in tool.PAGES.values()} - {tool.PAGE}:
        assert (docs / page).read_text(encoding="utf-8") == (repository / "docs" / page).read_text(encoding="utf-8")


def test_every_walk_tells_what_it_took_before(tool):
    before = json.loads(tool.BEFORE.read_text(encoding="utf-8"))
    assert set(before["walks"]) == set(tool.PAGES) and len(before["commit"]) == 7
    assert tool._before(None) == "not possible"
