"""Writes the list of algorithms with their keys into docs/how-to/toolbox.md: python tools/docs/list_algorithms.py."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parent))
from example_calls import ELSEWHERE, in_python, in_terminal

PAGE = Path(__file__).resolve().parents[2] / "docs" / "how-to" / "toolbox.md"
BEGIN, END = "<!-- algorithms: tools/docs/list_algorithms.py -->", "<!-- /algorithms -->"
GROUPS = ("annotation", "referencedatabase", "localization")


def listing(provider) -> str:
    """Markdown: a heading for each algorithm of the provider, by group, with title, what it does, keys and a call."""
    parts = []
    for group in GROUPS:
        algorithms = sorted((a for a in provider.algorithms() if a.groupId() == group), key=lambda a: a.name())
        parts += [f"### {algorithms[0].group()}", *(entry(algorithm) for algorithm in algorithms)]
    return "\n\n".join(parts)


def entry(algorithm) -> str:
    from qgis.core import QgsProcessingModelAlgorithm

    title = f"*{algorithm.displayName()}*"
    if isinstance(algorithm, QgsProcessingModelAlgorithm):
        title += " (a model)"
    about = f"{title}: {algorithm.shortDescription()}" if algorithm.shortDescription() else f"{title}."
    keys = [key_text(parameter) for parameter in algorithm.parameterDefinitions()]
    named = {parameter.name() for parameter in algorithm.parameterDefinitions()}
    results = [f"`{o.name()}`" for o in algorithm.outputDefinitions() if o.name() not in named]
    keys_text = ", ".join(keys) + (" → " + ", ".join(results) if results else "")
    name = algorithm.name()
    calls = f"```sh\n{in_terminal(name)}\n```\n\n```python\n{in_python(name)}\n```"
    needs = [ELSEWHERE[name]] if name in ELSEWHERE else []
    return "\n\n".join([f"#### {algorithm.id()}", about, keys_text, calls, *needs])


def key_text(parameter) -> str:
    """The key, in brackets where it may be left out, with its choices or its default."""
    from qgis.core import QgsProcessingParameterDefinition

    default = parameter.defaultValue()
    has_default = default is not None and default != ""
    if has_default or parameter.flags() & QgsProcessingParameterDefinition.FlagOptional:
        text = f"`[{parameter.name()}]`"
    else:
        text = f"`{parameter.name()}`"
    if parameter.type() == "enum":
        return text + " (" + ", ".join(f"{number} {name}" for number, name in enumerate(parameter.options())) + ")"
    if has_default:
        return text + (f" ({default:g})" if isinstance(default, float) else f" ({default})")
    return text


def with_listing(page: str, text: str) -> str:
    """The page with this text between its markers."""
    before, _, rest = page.partition(BEGIN)
    _, _, after = rest.partition(END)
    return f"{before}{BEGIN}\n\n{text}\n\n{END}{after}"


def sections(page: str) -> list[str]:
    """Ids of the algorithms that have a heading on the page."""
    return [line[5:] for line in page.splitlines() if line.startswith("#### ")]


def main() -> None:
    sys.path.append(str(Path(__file__).resolve().parents[1]))
    from qgis_session import qgis_session

    with qgis_session() as provider:
        page = with_listing(PAGE.read_text(encoding="utf-8"), listing(provider))
    PAGE.write_text(page, encoding="utf-8")
    print(f"{PAGE}: {len(sections(page))} algorithms")


if __name__ == "__main__":
    main()
