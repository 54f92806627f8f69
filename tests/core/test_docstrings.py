"""Whatever core offers says what it is."""

import ast
from pathlib import Path

from source_trees import for_each, tree_of

CORE = Path(__file__).resolve().parents[2] / "core"
FILES = sorted(path for path in CORE.rglob("*.py") if "__pycache__" not in path.parts)


def public_definitions(module):
    """Public functions and classes of a module, and public methods that do more than return something."""
    definitions = (ast.FunctionDef, ast.ClassDef)
    for node in module.body:
        if isinstance(node, definitions) and not node.name.startswith("_"):
            yield node.name, node
            for part in node.body if isinstance(node, ast.ClassDef) else ():
                if isinstance(part, definitions) and not part.name.startswith("_") and len(part.body) > 2:
                    yield f"{node.name}.{part.name}", part


@for_each(FILES)
def test_every_public_function_and_class_of_core_has_a_docstring(path):
    module = tree_of(path)
    assert ast.get_docstring(module)
    assert [name for name, node in public_definitions(module) if not ast.get_docstring(node)] == []
