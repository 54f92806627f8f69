import re
from pathlib import Path

from source_trees import for_each

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
GENERATED = {DOCS / "reference" / f"{name}.md" for name in ("algorithms", "messages", "command_line", "settings")}
"""Pages that the site build writes; git ignores them."""

PAGES = [*sorted(ROOT.glob("*.md")), *sorted(set(DOCS.rglob("*.md")) - GENERATED)]
LARGEST_PICTURE_BYTES, LARGEST_MOVING_BYTES, LARGEST_SUM_BYTES = 250_000, 1_500_000, 6_000_000

each_page = for_each(PAGES)


def without_code(text: str) -> str:
    return re.sub(r"^```.*?^```", "", text, flags=re.DOTALL | re.MULTILINE)


def links(page: Path) -> list[str]:
    """Return the targets of links and pictures that are files of the repository."""
    found = re.findall(r"\]\(([^)\s]+)\)", without_code(page.read_text(encoding="utf-8")))
    return [target for target in found if "://" not in target and not target.startswith("mailto:")]


def anchors(page: Path) -> set[str]:
    """Return the anchors as forges build them: lower case, no punctuation, hyphens, a number for a repeated heading."""
    found: set[str] = set()
    for heading in re.findall(r"^#+ (.+?)\s*$", without_code(page.read_text(encoding="utf-8")), flags=re.MULTILINE):
        text = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).lower()
        anchor = re.sub(r"[^\w\- ]", "", text).replace(" ", "-")
        count = sum(re.fullmatch(re.escape(anchor) + r"(-\d+)?", other) is not None for other in found)
        found.add(f"{anchor}-{count}" if count else anchor)
    return found


def exists(path: Path) -> bool:
    return path.exists() or path.resolve() in GENERATED


def source_files() -> list[Path]:
    rooms = ("core", "storage", "cluster", "processing", "ui", "tools", "benchmarks", "tests")
    return sorted([*ROOT.glob("*.py"), *(path for room in rooms for path in (ROOT / room).rglob("*.py"))])


def registered_algorithms() -> set[str]:
    """Return the ids of the algorithms and models in the source code."""
    found = set()
    for path in (ROOT / "processing" / "algorithms").glob("*.py"):
        found |= set(re.findall(r'^    ID = "(\w+)"', path.read_text(encoding="utf-8"), flags=re.MULTILINE))
    for path in (ROOT / "models").glob("*.model3"):
        found |= set(re.findall(r'name="model_name" type="QString" value="(\w+)"', path.read_text(encoding="utf-8")))
    return found


@each_page
def test_every_link_and_picture_leads_to_a_file(page):
    targets = [target.partition("#")[0] for target in links(page)]
    assert [target for target in targets if target and not exists(page.parent / target)] == []


@each_page
def test_every_link_to_a_heading_leads_to_one(page):
    missing = []
    for target in links(page):
        file, _, anchor = target.partition("#")
        linked = (page.parent / file).resolve() if file else page
        if anchor and linked in PAGES and anchor not in anchors(linked):
            missing.append(target)
    assert missing == []


def test_every_page_that_code_cites_exists_with_its_heading():
    missing = []
    for path in source_files():
        for file, anchor in re.findall(r"\bdocs/([\w/-]+\.md)(?:#([\w-]+))?", path.read_text(encoding="utf-8")):
            page = DOCS / file
            if not exists(page) or (anchor and page in PAGES and anchor not in anchors(page)):
                missing.append(f"{path.relative_to(ROOT)}: {file}#{anchor}")
    assert missing == []


def test_code_and_docs_cite_no_page_outside_the_repository():
    cited = re.compile("DESIG" + "N(\\.md)? ?§?|shared/[A-Z]")
    assert [str(path) for path in [*source_files(), *PAGES] if cited.search(path.read_text(encoding="utf-8"))] == []


@each_page
def test_every_algorithm_that_is_named_exists(page):
    named = set(re.findall(r"semref:(\w+)", page.read_text(encoding="utf-8")))
    assert named - registered_algorithms() == set()


@each_page
def test_every_script_that_is_named_exists(page):
    named = set(re.findall(r"(?<!tests/)\btools/[\w/]+(?:\.py|\.sh|\.js|\.txt)\b", page.read_text(encoding="utf-8")))
    assert [name for name in sorted(named) if not (ROOT / name).exists()] == []


def test_every_picture_is_shown_somewhere():
    shown = {(page.parent / target.partition("#")[0]).resolve() for page in PAGES for target in links(page)}
    assert [path.name for path in sorted((DOCS / "images").iterdir()) if path.resolve() not in shown] == []


def test_pictures_are_small():
    sizes = {path.name: path.stat().st_size for path in (DOCS / "images").iterdir()}
    large = {name: size for name, size in sizes.items() if size > LARGEST_PICTURE_BYTES and not name.endswith(".webp")}
    assert large == {}
    assert max(sizes.values()) <= LARGEST_MOVING_BYTES
    assert sum(sizes.values()) <= LARGEST_SUM_BYTES


def test_the_plugin_opens_pages_of_the_guide_that_exist():
    sources = [path for room in ("processing", "ui") for path in (ROOT / room).rglob("*.py")]
    pages = [page for path in sources for page in re.findall(r'"([\w/-]+\.md)"', path.read_text(encoding="utf-8"))]
    assert "README.md" in pages
    assert [page for page in pages if not exists(DOCS / page)] == []


def test_the_docs_have_the_licenses_of_all_that_ships_or_is_installed():
    page = (DOCS / "reference" / "third_party.md").read_text(encoding="utf-8")
    files = [*(ROOT / "processing" / "packages").glob("wheels_*.txt"), ROOT / "training" / "requirements.txt"]
    pinned = {name for path in files for name in re.findall(r"^([\w-]+)[=>]=", path.read_text(), flags=re.MULTILINE)}
    assert {"onnxruntime", "torch"} <= pinned
    assert {name for name in pinned if not re.search(rf"(?<![\w-]){name}(?![\w-])", page)} == set()


def test_the_version_is_the_same_everywhere():
    version = re.search(r"^version=(.+)$", (ROOT / "metadata.txt").read_text(encoding="utf-8"), re.MULTILINE)[1]
    assert f"\nversion: {version}\n" in (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    headings = re.findall(r"^## \[(.+?)\]", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE)
    assert version in headings[:2]
