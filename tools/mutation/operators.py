"""What a mutant is: one small fault put into a module's source."""

from __future__ import annotations

import ast
import copy
from collections.abc import Iterator
from dataclasses import dataclass

COMPARISONS = {
    ast.Lt: (ast.LtE, ast.Gt),
    ast.LtE: (ast.Lt, ast.Gt),
    ast.Gt: (ast.GtE, ast.Lt),
    ast.GtE: (ast.Gt, ast.Lt),
    ast.Eq: (ast.NotEq,),
    ast.NotEq: (ast.Eq,),
    ast.Is: (ast.IsNot,),
    ast.IsNot: (ast.Is,),
    ast.In: (ast.NotIn,),
    ast.NotIn: (ast.In,),
}
ARITHMETIC = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
    ast.FloorDiv: ast.Div,
    ast.Mod: ast.Mult,
    ast.Pow: ast.Mult,
    ast.BitAnd: ast.BitOr,
    ast.BitOr: ast.BitAnd,
    ast.LShift: ast.RShift,
    ast.RShift: ast.LShift,
}


EITHER_WAY = {"max", "min", "maximum", "minimum", "hypot", "logical_and", "logical_or"}
"""Functions that don't mind the order of their arguments."""


@dataclass(frozen=True)
class Mutant:
    """One fault.

    Attributes:
        function: The function that it is in.
        line: Of the source, from 1.
        old: What stood there.
        new: What stands there now.
        source: The whole module with it.
    """

    function: str
    line: int
    old: str
    new: str
    source: str

    @property
    def key(self) -> str:
        """Names it whatever lines stand above: function, old and new text, in one line."""
        return f"{self.function}: {' '.join(self.old.split())} -> {' '.join(self.new.split())}"


def mutants_of(source: str) -> list[Mutant]:
    """All mutants of a module's functions that are Python, in the order of the source; none of them twice."""
    lines = source.encode().splitlines(keepends=True)
    starts = [0]
    for line in lines:
        starts.append(starts[-1] + len(line))
    text, found = source.encode(), {}
    for function, node, new in _faults(ast.parse(source)):
        first = starts[node.lineno - 1] + node.col_offset
        last = starts[node.end_lineno - 1] + node.end_col_offset
        old = text[first:last].decode()
        # Another node's text may begin a line: what is longer than one stays in brackets.
        written = new if isinstance(node, ast.stmt) else f"({new})"
        changed = (text[:first] + written.encode() + text[last:]).decode()
        if " ".join(old.split()) != " ".join(new.split()) and _compiles(changed):
            found.setdefault((first, last, new), Mutant(function, node.lineno, old, new, changed))
    return [found[place] for place in sorted(found)]


def _compiles(source: str) -> bool:
    try:
        compile(source, "mutant", "exec")
    except SyntaxError:
        return False
    return True


def _faults(module: ast.Module) -> Iterator[tuple[str, ast.AST, str]]:
    """(function, node, its new text) of each fault in a function's body."""
    for name, function in _functions(module, ""):
        for node in _nodes(function.body):
            for new in (*_of_expression(node), *_of_statement(node)):
                yield name, node, new if isinstance(new, str) else ast.unparse(ast.fix_missing_locations(new))


def _functions(node: ast.AST, prefix: str) -> Iterator[tuple[str, ast.FunctionDef]]:
    """Functions and methods by their dotted names; what is defined in a function belongs to it."""
    for part in ast.iter_child_nodes(node):
        if isinstance(part, ast.FunctionDef):
            yield prefix + part.name, part
        elif isinstance(part, ast.ClassDef):
            yield from _functions(part, f"{prefix}{part.name}.")


def _nodes(body: list[ast.stmt]) -> Iterator[ast.AST]:
    """All nodes of a body but annotations, docstrings, and texts with values, whose places Python doesn't tell."""
    waiting: list[ast.AST] = [part for part in body if not _is_text(part)]
    while waiting:
        node = waiting.pop()
        yield node
        if isinstance(node, ast.JoinedStr):
            continue
        for name, value in ast.iter_fields(node):
            if name not in ("annotation", "returns", "decorator_list"):
                waiting += [part for part in (value if isinstance(value, list) else [value]) if _is_node(part)]


def _is_node(part: object) -> bool:
    return isinstance(part, ast.AST) and not _is_text(part)


def _is_text(part: object) -> bool:
    return isinstance(part, ast.Expr) and isinstance(part.value, ast.Constant) and isinstance(part.value.value, str)


def _changed(node: ast.AST, **fields: object) -> ast.AST:
    """A copy with other fields."""
    other = copy.deepcopy(node)
    for name, value in fields.items():
        setattr(other, name, value)
    return other


def _of_expression(node: ast.AST) -> Iterator[ast.AST | str]:
    """What an expression may become."""
    if isinstance(node, ast.Compare) and len(node.ops) == 1:
        for kind in COMPARISONS[type(node.ops[0])]:
            yield _changed(node, ops=[kind()])
    elif isinstance(node, ast.Compare):
        for place, one in enumerate(node.ops):
            yield _changed(node, ops=[*node.ops[:place], COMPARISONS[type(one)][0](), *node.ops[place + 1 :]])
    elif isinstance(node, ast.BinOp) and type(node.op) in ARITHMETIC:
        yield _changed(node, op=ARITHMETIC[type(node.op)]())
    elif isinstance(node, ast.BoolOp):
        yield _changed(node, op=ast.Or() if isinstance(node.op, ast.And) else ast.And())
    elif isinstance(node, ast.UnaryOp):
        yield node.operand
    elif isinstance(node, ast.Constant) and isinstance(node.value, bool):
        yield repr(not node.value)
    elif isinstance(node, ast.Constant) and isinstance(node.value, (int, float)):
        yield repr(node.value + 1)
        yield repr(node.value - 1)
    elif isinstance(node, ast.Call) and len(node.args) > 1 and not isinstance(node.args[0], ast.Starred):
        one, other, *rest = node.args
        name = getattr(node.func, "attr", getattr(node.func, "id", ""))
        if name not in EITHER_WAY and ast.dump(one) != ast.dump(other) and not isinstance(other, ast.Starred):
            yield _changed(node, args=[other, one, *rest])
    elif isinstance(node, ast.IfExp):
        yield _changed(node, test=ast.UnaryOp(ast.Not(), node.test))


def _of_statement(node: ast.AST) -> Iterator[ast.AST | str]:
    """What a statement may become: nothing, the opposite condition, no value."""
    if (
        isinstance(node, ast.Expr)
        and isinstance(node.value, ast.Call)
        or isinstance(node, (ast.Raise, ast.Break, ast.Continue))
    ):
        yield "pass"
    elif isinstance(node, ast.AugAssign):
        yield "pass"
        if type(node.op) in ARITHMETIC:
            yield _changed(node, op=ARITHMETIC[type(node.op)]())
    elif isinstance(node, ast.Assign) and isinstance(node.targets[0], (ast.Subscript, ast.Attribute)):
        yield "pass"
    elif isinstance(node, ast.Return) and node.value is not None and ast.unparse(node.value) != "None":
        yield "return None"
