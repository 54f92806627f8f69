import json
import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools" / "docs"))

import build_site  # noqa: E402
import reference_pages  # noqa: E402
import site_pages  # noqa: E402


class Page(HTMLParser):
    """Ids and links of a page, and the files that a browser loads for it."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.ids, self.links, self.fetched = set(), [], []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        found = dict(attrs)
        self.ids.update(value for key, value in attrs if key in ("id", "name") and value)
        if tag == "a" and found.get("href"):
            self.links.append(found["href"])
        if tag in ("img", "script", "iframe") and found.get("src"):
            self.fetched.append(found["src"])
        if tag == "link" and found.get("href"):
            self.fetched.append(found["href"])


@pytest.fixture(scope="module")
def site(tmp_path_factory) -> Path:
    environment = ROOT / ".venv-docs"
    if not (environment / "state").is_file():
        pytest.skip("run tools/docs/build_site.py once: it creates the environment")
    target = tmp_path_factory.mktemp("site") / "help"
    build_site.build(target, environment)
    return target


@pytest.fixture(scope="module")
def pages(site) -> dict[Path, Page]:
    return {path: Page(path) for path in sorted(site.rglob("*.html"))}


def test_the_menu_names_each_page_once_but_single_decisions():
    menu = (site_pages.SITE / "mkdocs.yml").read_text(encoding="utf-8").partition("\nnav:\n")[2]
    named = re.findall(r"^ {6}- .+: (\S+\.md)$", menu, re.MULTILINE)
    assert len(set(named)) == len(named) > 30
    places = set(site_pages.page_places(ROOT).values())
    assert set(named) - places - {f"reference/{name}" for name in reference_pages.NAMES} == set()
    unnamed = {page for page in places - set(named) if page.endswith(".md")}
    assert {page for page in unnamed if not page.startswith("decisions/")} == set()


def test_links_to_what_has_no_page_become_the_name_of_the_file(tmp_path):
    page = tmp_path / "docs" / "architecture.md"
    page.parent.mkdir()
    page.write_text("[core](../core/errors.py) [top](../README.md#a) [web](https://x.y)\n", encoding="utf-8")
    places = {page: "architecture.md", tmp_path / "docs" / "README.md": "README.md"}
    text = site_pages.staged(page, tmp_path, places)
    assert text.endswith("core (`core/errors.py`) [top](README.md#a) [web](https://x.y)\n")


def test_what_a_browser_would_fetch_from_the_web_is_seen_and_links_are_not(tmp_path):
    page = tmp_path / "page.html"
    page.write_text('<a href="https://a.b">x</a><img src="c.png"><link rel=x href=//d.e/f><script src="https://g">')
    assert build_site.asked_of_the_web(page) == ["<link rel=x href=//d.e/f", 'src="https://g']


@pytest.mark.slow
def test_every_link_and_heading_of_the_built_pages_is_there_and_no_page_asks_the_web(site, pages):
    broken = []
    for path, page in pages.items():
        for link in (*page.links, *page.fetched):
            if re.match(r"(https?|mailto):", link):
                continue
            target, _, anchor = link.partition("#")
            linked = (path.parent / unquote(target)).resolve() if target else path
            heading_is_there = not anchor or linked not in pages or unquote(anchor) in pages[linked].ids
            if not linked.exists() or not heading_is_there:
                broken.append(f"{path.relative_to(site)}: {link}")
    assert broken == []
    assert [path.name for path, page in pages.items() if any("//" in fetched for fetched in page.fetched)] == []


@pytest.mark.slow
def test_the_search_has_every_page_and_works_without_a_server(site, pages):
    text = (site / "search" / "search_index.js").read_text(encoding="utf-8")
    found = {entry["location"].partition("#")[0] for entry in json.loads(text.partition("=")[2])["docs"]}
    made = {path.relative_to(site).as_posix() for path in pages if path.parent.name != "algorithms"}
    assert made - found == set()
    assert "iframe-worker" in (site / "index.html").read_text(encoding="utf-8")


@pytest.mark.slow
def test_every_algorithm_has_a_page_that_leads_to_its_section(site, pages):
    sections = {name for name in pages[site / "reference" / "algorithms.html"].ids if name.startswith("semref")}
    assert {f"semref{path.stem}" for path in (site / "algorithms").iterdir()} == sections


def test_formulas_are_mathml(site):
    page = (site / "explanation" / "method.html").read_text(encoding="utf-8")
    assert '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block">' in page
    assert not re.findall(r"arithmatex|\\frac|\\ln", page)
