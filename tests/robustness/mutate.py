"""Mutation: do tests fail if a module is changed in one place? ``python tests/robustness/mutate.py MODULES TESTS…``

MODULES have commas between them. mutmut leaves out decorated functions and the constants of modules; cosmic-ray runs every
test for every change. Here pytest collects the tests once, and then forks for each change: the functions, constants and
defaults of the loaded module get those of the changed one. The tests that run the changed line are run (all, if none does,
as for constants), the quickest first, until one fails. No real recordings are read, and hypothesis tries five examples.
Compiled code and tests in other processes see no change.
"""

import ast
import functools
import os
import pickle
import random
import signal
import sys
import tempfile
import time
import traceback
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
import typer
from coverage import Coverage

COMPARED = {ast.Lt: (ast.LtE, ast.Gt), ast.LtE: (ast.Lt, ast.GtE), ast.Gt: (ast.GtE, ast.Lt), ast.GtE: (ast.Gt, ast.LtE),
            ast.Eq: [ast.NotEq], ast.NotEq: [ast.Eq], ast.In: [ast.NotIn], ast.NotIn: [ast.In], ast.Is: [ast.IsNot],
            ast.IsNot: [ast.Is]}
OPERATORS = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.Pow: ast.Mult, ast.Mod: ast.Mult,
             ast.FloorDiv: ast.Div, ast.BitAnd: ast.BitOr, ast.BitOr: ast.BitAnd, ast.And: ast.Or, ast.Or: ast.And,
             ast.USub: ast.UAdd, ast.Invert: ast.UAdd}
LIMIT = 30.0  # seconds of processor time for a test, and ten times what it takes without a change


def changes(tree: ast.AST, line: int = 0):
    """Every change of a tree: first and last line, a node, the field to set and its new value."""
    line = tree.lineno if isinstance(tree, ast.stmt) else line
    found, value = [], getattr(tree, "value", None)
    if isinstance(tree, ast.Compare):
        found = [("ops", [*tree.ops[:k], new(), *tree.ops[k + 1 :]]) for k, op in enumerate(tree.ops)
                 for new in COMPARED[type(op)]]
    elif type(getattr(tree, "op", None)) in OPERATORS and not isinstance(tree, ast.AugAssign):
        found = [("op", OPERATORS[type(tree.op)]())]
    elif isinstance(tree, ast.IfExp):
        found = [("test", ast.UnaryOp(ast.Not(), tree.test))]
    elif isinstance(tree, ast.UnaryOp):  # not
        found = [("operand", ast.UnaryOp(ast.Not(), tree.operand))]
    elif isinstance(tree, ast.Constant) and isinstance(value, bool | int | float):
        other = not value if isinstance(value, bool) else value + 1 if isinstance(value, int) else value * 1.5 or 1.0
        found = [("value", other)]
    elif isinstance(tree, ast.If):
        found = [("test", ast.Constant(False))]
    yield from ((line, tree.end_lineno if isinstance(tree, ast.expr) else line, tree, *change) for change in found)
    for name, value in ast.iter_fields(tree):
        for k, part in enumerate(value if isinstance(value, list) else [value]):
            if isinstance(part, ast.AugAssign) or (isinstance(part, ast.Expr) and isinstance(part.value, ast.Call)):
                yield part.lineno, part.lineno, tree, name, [*value[:k], ast.Pass(), *value[k + 1 :]]
            message = isinstance(part, ast.Raise | ast.JoinedStr) or getattr(part, "arg", "") == "strict"
            if isinstance(part, ast.AST) and name not in ("annotation", "returns", "decorator_list") and not message:
                yield from changes(part, line)


def functions(holder: dict, module: str) -> Iterator[tuple[str, Callable]]:
    """The functions of a module or class with their names, also those inside decorators, properties and classes."""
    for name, value in [*holder.items()]:
        if isinstance(value, type) and value.__module__ == module:
            yield from ((f"{name}.{inner}", function) for inner, function in functions(vars(value), module))
        for field in ("fget", "func", "__func__", "__wrapped__"):
            value = getattr(value, field, value)
        if hasattr(value, "__code__") and value.__module__ == module:
            yield name, value


def put(module, text: str) -> None:
    """Give a loaded module the functions, defaults and constants of another text."""
    made = {"__name__": module.__name__, "__file__": module.__file__}
    exec(compile(text, module.__file__, "exec"), made)
    new = dict(functions(made, module.__name__))
    for name, old in functions(vars(module), module.__name__):
        if name in new:  # the methods of a dataclass may be made with other free variables
            old.__defaults__, old.__kwdefaults__ = new[name].__defaults__, new[name].__kwdefaults__
            if len(old.__code__.co_freevars) == len(new[name].__code__.co_freevars):
                old.__code__ = new[name].__code__
    for name, old in [*vars(module).items()]:
        if isinstance(made.get(name), int | float | str | tuple | dict) and not name.startswith("__"):
            for holder in [*sys.modules.values()]:
                if getattr(holder, "__dict__", {}).get(name) is old:
                    setattr(holder, name, made[name])
        for cached in (old, *(vars(old).values() if isinstance(old, type) else ())):
            if isinstance(cached, functools._lru_cache_wrapper):
                cached.cache_clear()


class Mutation:
    """A plugin of pytest that runs the collected tests once for each change, instead of once."""

    def __init__(self, paths: list[Path], mutants: int, seed: int) -> None:
        self.paths, self.mutants, self.seed, self.seconds = paths, mutants, seed, {}

    def pytest_runtest_setup(self, item: pytest.Item) -> None:
        if item.nodeid in self.seconds:
            signal.setitimer(signal.ITIMER_PROF, LIMIT + 10 * self.seconds[item.nodeid])

    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        import hypothesis  # pytest wants to load it itself

        hypothesis.settings.register_profile("quick", hypothesis.settings.get_profile("repeatable"), max_examples=5)
        hypothesis.settings.load_profile("quick")
        modules = {getattr(module, "__file__", None): module for module in [*sys.modules.values()]}
        with tempfile.NamedTemporaryFile() as file:
            covered = Coverage(None, config_file=False, include=[*map(str, self.paths)])
            covered.set_option("run:dynamic_context", "test_function")
            if self.fork(session, session.items, covered=covered, file=file.name):
                sys.exit("without a change, a test fails")
            self.seconds, runs = pickle.loads(Path(file.name).read_bytes())
        items = sorted(session.items, key=lambda item: self.seconds[item.nodeid])
        if self.fork(session, items):
            sys.exit("without a change, a test fails in another order")
        self.say(f"{len(items)} tests take {sum(self.seconds.values()):.0f} s")
        every = [(path, k) for path in self.paths for k in range(len([*changes(ast.parse(path.read_text()))]))]
        for path, k in random.Random(self.seed).sample(every, min(self.mutants, len(every))):
            tree = ast.parse(path.read_text())
            low, high, node, field, value = [*changes(tree)][k]
            before = ast.unparse(node)
            setattr(node, field, value)
            by = {test for line in range(low, high + 1) for test in runs[path].get(line, [])}
            early = [item for item in items if f"{item.module.__name__}.{item.originalname}" in by]
            began, text = time.perf_counter(), ast.unparse(ast.fix_missing_locations(tree))
            ended = self.fork(session, early or items, lambda m=modules[str(path)], text=text: put(m, text))
            self.say(f"{path.name}:{low}", f"detected ({ended})" if ended else f"SURVIVED {len(early or items)} tests",
                     *(" ".join(code.split())[:90] for code in (before, "->", ast.unparse(node))),
                     f"{time.perf_counter() - began:.0f} s")
        self.say(f"{len(every)} changes are possible")
        return True

    def say(self, *words: str) -> None:
        os.write(self.out, (" ".join(words) + "\n").encode())

    def fork(self, session: pytest.Session, items: list[pytest.Function], change: Callable = lambda: None,
             covered: Coverage | None = None, file: str = "") -> int:
        """Run tests in a process of its own up to the first failure: 0, 1, or minus the signal that ends it."""
        if child := os.fork():
            return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        ended = 1
        try:
            change()
            if covered:
                covered.start()
            for item, following in zip(items, [*items[1:], None], strict=True):
                began = time.process_time()
                session.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
                self.seconds[item.nodeid] = time.process_time() - began
                if session.testsfailed:
                    break
            else:
                ended = 0
            if covered:
                covered.stop()
                runs = {path: covered.get_data().contexts_by_lineno(str(path)) for path in self.paths}
                Path(file).write_bytes(pickle.dumps((self.seconds, runs)))
        except BaseException:  # a change that cannot be loaded
            traceback.print_exc()
        finally:
            os._exit(ended)


def main(modules: str, tests: list[str], mutants: int = 30, seed: int = 0) -> None:
    """Change modules in one place at a time, and run the tests that are meant to hold them."""
    os.environ["TOOLKIT_DATA"] = os.devnull
    plugin = Mutation([Path(module).resolve() for module in modules.split(",")], mutants, seed)
    plugin.out = os.dup(1)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    pytest.main(["-xq", "-p", "no:cacheprovider", *tests], [plugin])


if __name__ == "__main__":
    typer.run(main)
