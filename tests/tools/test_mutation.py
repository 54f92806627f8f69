"""Mutants are the faults that they are called, and the engine tells those that tests notice from the others."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

TOOLS = Path(__file__).resolve().parents[2] / "tools"


@pytest.fixture(scope="module")
def mutation():
    """tools/mutation as a package."""
    sys.path.append(str(TOOLS))
    import mutation.engine
    import mutation.operators

    yield mutation
    sys.path.remove(str(TOOLS))


def faults(mutation, body: str) -> list[str]:
    source = f"def f(a, b):\n    {body}\n"
    return [f"{mutant.old} -> {mutant.new}" for mutant in mutation.operators.mutants_of(source)]


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("return a < b", {"a < b -> a <= b", "a < b -> a > b", "return a < b -> return None"}),
        ("return a + 1", {"a + 1 -> a - 1", "1 -> 2", "1 -> 0", "return a + 1 -> return None"}),
        ("a += b", {"a += b -> pass", "a += b -> a -= b"}),
        ("a.append(b)", {"a.append(b) -> pass"}),
        ("a[b] = b", {"a[b] = b -> pass"}),
        ("raise a", {"raise a -> pass"}),
        ("c = a and b", {"a and b -> a or b"}),
        ("c = a if b else 'd'", {"a if b else 'd' -> a if not b else 'd'"}),
        ("c = not a", {"not a -> a"}),
        ("c = g(a, b)", {"g(a, b) -> g(b, a)"}),
        ("c = max(a, b)", set()),
        ("c: list[1] = a", set()),
        ("c = True", {"True -> False"}),
        ('"""1 + 1"""', set()),
    ],
)
def test_each_construct_has_its_faults(mutation, body, expected):
    assert set(faults(mutation, body)) == expected


def test_a_mutant_differs_from_its_module_in_its_one_place(mutation):
    source = 'def f(é):\n    """Says."""\n    c = "ü" * (é - 2)\n    return c\n'
    changed = {mutant.source for mutant in mutation.operators.mutants_of(source)}
    assert 'def f(é):\n    """Says."""\n    c = "ü" * ((é + 2))\n    return c\n' in changed


def test_methods_are_named_by_their_class_and_what_stands_outside_functions_is_left_alone(mutation):
    source = "A = 1\nclass B:\n    C = 2\n    def d(self, e=3):\n        return 4\n"
    assert {mutant.key for mutant in mutation.operators.mutants_of(source)} == {
        "B.d: 4 -> 5",
        "B.d: 4 -> 3",
        "B.d: return 4 -> return None",
    }


@pytest.mark.slow
def test_a_noticed_fault_and_one_that_never_ends_fail_and_an_unnoticed_one_passes(mutation, tmp_path):
    module = tmp_path / "counted.py"
    module.write_text("def count(n):\n    k = 0\n    while k < n:\n        k += 1\n    return k\n")
    test = tmp_path / "test_counted.py"
    test.write_text(
        f"import sys\nsys.path.insert(0, {str(tmp_path)!r})\n"
        "def test_count():\n    import counted\n    assert counted.count(3) == 3\n"
    )
    mutants = {one.key: one for one in mutation.operators.mutants_of(module.read_text())}
    found = {}
    for key in (None, "count: k < n -> k <= n", "count: k += 1 -> pass", "count: 1 -> 0"):
        mutant = mutants[key] if key else None
        found[key] = mutation.engine.run([str(test)], module, mutant, 2, tmp_path / "log")[0]
    assert found.pop(None) == 0
    assert all(found.values())
    unnoticed = next(one for key, one in mutants.items() if key == "count: return k -> return None")
    test.write_text(test.read_text().replace("== 3", "or True"))
    assert mutation.engine.run([str(test)], module, unnoticed, 2, tmp_path / "log")[0] == 0
