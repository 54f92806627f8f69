"""The shipped source as syntax trees; each file is parsed once for all tests."""

import ast
import functools
from collections.abc import Callable, Iterable
from pathlib import Path


@functools.cache
def nodes_of(path: Path) -> tuple[ast.AST, ...]:
    """Return the nodes of a file's tree; callers must not change them."""
    return tuple(ast.walk(ast.parse(path.read_text(encoding="utf-8"))))


def for_each(items: Iterable) -> Callable:
    """Make one test of a rule that holds for each item: it names every item that breaks the rule."""
    items = tuple(items)
    assert items

    def of(rule: Callable) -> Callable:
        def test() -> None:
            broken = []
            for item in items:
                try:
                    rule(item)
                except AssertionError as error:
                    broken.append(f"{item}: {error}")
            assert not broken, "\n".join(broken)

        test.__name__, test.__doc__ = rule.__name__, rule.__doc__
        return test

    return of
