"""The reference page of the Processing algorithms, from SemRef's provider."""

import re
from pathlib import Path

from example_calls import ELSEWHERE, in_python, in_terminal

GROUPS = ("annotation", "referencedatabase", "localization")
HEAD = Path(__file__).with_name("heads").joinpath("algorithms.md").read_text(encoding="utf-8")


def page(provider) -> str:
    """Return the whole page, by groups of algorithms."""
    parts = [HEAD.rstrip()]
    for group in GROUPS:
        algorithms = sorted((a for a in provider.algorithms() if a.groupId() == group), key=lambda a: a.name())
        parts += [f"## {algorithms[0].group()}", *(entry(algorithm) for algorithm in algorithms)]
    return "\n\n".join(parts) + "\n"


def entry(algorithm) -> str:
    """Return heading, summary, tables of parameters and results, and two example calls of an algorithm."""
    from qgis.core import QgsProcessingModelAlgorithm

    name = algorithm.name()
    kind = ", a model" if isinstance(algorithm, QgsProcessingModelAlgorithm) else ""
    parameters = ["| key | parameter | meaning |", "|---|---|---|"]
    parameters += [parameter_row(parameter) for parameter in algorithm.parameterDefinitions()]
    keys = {parameter.name() for parameter in algorithm.parameterDefinitions()}
    results = [f"`{o.name()}` ({o.description()})" for o in algorithm.outputDefinitions() if o.name() not in keys]
    return "\n\n".join(
        [
            f"### {algorithm.displayName()} {{#semref{name}}}",
            f"`{algorithm.id()}`{kind}. {algorithm.shortDescription()}".rstrip(),
            "\n".join(parameters),
            *([f"Results besides the outputs: {', '.join(results)}."] if results else []),
            f"```sh\n{in_terminal(name)}\n```\n\n```python\n{in_python(name)}\n```",
            *([ELSEWHERE[name]] if name in ELSEWHERE else []),
        ]
    )


def parameter_row(parameter) -> str:
    """Return key, title, and meaning of a parameter with choices and default."""
    from qgis.core import QgsProcessingParameterDefinition

    default = parameter.defaultValue()
    if isinstance(default, bool):
        default = str(default).lower()
    default = "" if default is None else f"{default:g}" if isinstance(default, float) else str(default)
    is_optional = bool(default) or bool(parameter.flags() & QgsProcessingParameterDefinition.FlagOptional)
    key = f"`[{parameter.name()}]`" if is_optional else f"`{parameter.name()}`"
    meaning = parameter.help()
    if parameter.type() == "enum":
        choices = ", ".join(f"{number} {name}" for number, name in enumerate(parameter.options()))
        meaning = f"{meaning} Choices: {choices}.".strip()
    if default:
        meaning = f"{meaning} Default: {default}.".strip()
    title, meaning = (text.replace("|", "&#124;").replace("<", "&lt;") for text in (parameter.description(), meaning))
    return f"| {key} | {title} | {meaning} |"


def ids(text: str) -> list[str]:
    """Return the ids of the algorithms that have a heading on the page."""
    return [f"semref:{name}" for name in re.findall(r"^### .+ \{#semref(\w+)\}$", text, flags=re.MULTILINE)]
