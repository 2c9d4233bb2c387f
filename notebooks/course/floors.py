"""A claim must not hold for its floor: for what could be had without the work.

A comment in the cell of a claim names a floor as an assignment, such as
``# floor: error = error["repeat"]``. Small runs (`course.FAST`) run the cell again with it.
"""

import ast
import re
from collections.abc import Callable, Mapping
from typing import Any

import course

FLOOR = re.compile(r"^# floor: (.+)$", re.M)


class WithFloor(ast.NodeTransformer):
    """Assigns the floor before the cell, and once more just before the claim, because the cell
    may compute the variable.
    """

    def __init__(self, floor: str):
        self.floor = ast.parse(floor).body

    def visit_Module(self, node: ast.Module) -> ast.Module:
        return ast.Module([*self.floor, *self.within(node.body)], [])

    def visit_If(self, node: ast.If) -> ast.If:
        node.body = self.within(node.body)
        return node

    def within(self, body: list[ast.stmt]) -> list[ast.stmt]:
        """Statements with the floor before those that hold the claim."""
        found = []
        for statement in body:
            if "course.claim(" in ast.unparse(statement) and not isinstance(statement, ast.If):
                found += self.floor
            found.append(self.visit(statement))
        return found


class Judging:
    """The course, with another `claim`."""

    def __init__(self, claim: Callable[..., str]):
        self.claim = claim

    def __getattr__(self, name: str) -> Any:
        return getattr(course, name)


def refuse(cell: str, names: Mapping[str, Any]) -> None:
    """Run the cell of a claim with its floor. AssertionError if the claim holds there, too.

    ``names`` are the variables of the notebook; they are not changed. A claim with a weaker
    condition in a small run is tried with that of the full run, too.
    """
    for floor in FLOOR.findall(cell):
        code = compile(ast.fix_missing_locations(WithFloor(floor).visit(ast.parse(cell))),
                       "<floor>", "exec")
        if all(holds(code, names, fast) for fast in (True, False)):
            raise AssertionError(f"the claim holds for its floor, too: {floor}")


def holds(code: Any, names: Mapping[str, Any], fast: bool) -> bool:
    """Whether the conditions of a claim hold in a run of its cell."""
    told: list[bool] = []

    def claim(_: str, *conditions: bool) -> str:
        told.append(all(map(bool, conditions)))
        return ""

    exec(code, {**names, "FAST": fast, "course": Judging(claim), "display": lambda _: None})
    return all(told)
