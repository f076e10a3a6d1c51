"""The house stays one in which a stranger finds every line: names once, no circles, short rooms."""

import ast
from collections import defaultdict
from pathlib import Path

import pytest

import wrinklestudy

ROOT = Path(wrinklestudy.__file__).parent
MOST_FILES_AT_THE_TOP = 8
MOST_LINES_OF_A_MODULE = 330
MOST_LINES_OF_A_FUNCTION = 45


def name_of(path):
    """Return the dotted name of a module of the package."""
    parts = path.relative_to(ROOT.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


SOURCES = {name_of(path): path.read_text(encoding="utf-8") for path in sorted(ROOT.rglob("*.py"))}
TREES = {name: ast.parse(text) for name, text in SOURCES.items()}


def is_alias(node):
    """Whether an assignment names a type: in capitals like a class, and not called like a value."""
    return (
        isinstance(node, ast.Assign)
        and isinstance(node.targets[0], ast.Name)
        and node.targets[0].id[0].isupper()
        and not node.targets[0].id.isupper()
    )


def types_of(tree):
    """Yield the names of the classes and type aliases that a module defines."""
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            yield node.name
        elif is_alias(node):
            yield node.targets[0].id


def statements_of(body):
    """Yield the statements of a module that run when it is imported, or that type checkers see."""
    for node in body:
        yield node
        if isinstance(node, ast.If | ast.Try):
            yield from statements_of([*node.body, *node.orelse])


def imports_of(tree):
    """Yield the modules of the package that one imports at its top, for type checkers included."""
    for node in statements_of(tree.body):
        if isinstance(node, ast.ImportFrom) and node.module in TREES:
            for alias in node.names:
                inner = f"{node.module}.{alias.name}"
                yield inner if inner in TREES else node.module
        elif isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names if alias.name in TREES)


def without_leaves(graph):
    """Return what is left of a graph when modules that import nothing else of it are taken off."""
    rest = {name: set(targets) for name, targets in graph.items()}
    while leaves := {name for name, targets in rest.items() if not targets & rest.keys()}:
        rest = {name: targets for name, targets in rest.items() if name not in leaves}
    return rest


def functions_of(tree):
    """Yield name and number of lines of each function, signature and docstring left out."""
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            start = node.body[0]
            if ast.get_docstring(node) is not None:
                start = node.body[1] if len(node.body) > 1 else None
            yield node.name, node.end_lineno - start.lineno + 1 if start else 0


def test_no_two_classes_or_aliases_share_a_name():
    homes = defaultdict(list)
    for module, tree in TREES.items():
        for name in types_of(tree):
            homes[name].append(module)
    assert {"Array", "StateRow", "Limits"} <= homes.keys()
    assert {name: modules for name, modules in homes.items() if len(modules) > 1} == {}


def test_arrays_have_their_names_in_one_module():
    defined = {
        module: [ast.unparse(node) for node in tree.body if is_alias(node)]
        for module, tree in TREES.items()
    }
    arrays = {
        module: [text for text in texts if text.partition(" = ")[2].startswith("NDArray[")]
        for module, texts in defined.items()
    }
    assert {module for module, texts in arrays.items() if texts} == {"wrinklestudy.typing"}
    types = [text.partition(" = ")[2] for text in arrays["wrinklestudy.typing"]]
    assert len(set(types)) == len(types)


def test_modules_import_each_other_in_no_circle():
    graph = {name: set(imports_of(tree)) for name, tree in TREES.items()}
    assert sum(map(len, graph.values())) > len(graph)
    assert without_leaves(graph) == {}


@pytest.mark.parametrize(
    ("graph", "circle"),
    [
        ({"a": {"b"}, "b": {"c"}, "c": set()}, set()),
        ({"a": {"b"}, "b": {"c"}, "c": {"b"}, "d": set()}, {"a", "b", "c"}),
        ({"a": {"a"}}, {"a"}),
    ],
)
def test_a_circle_would_be_seen(graph, circle):
    assert without_leaves(graph).keys() == circle


def test_few_modules_lie_outside_of_any_room():
    files = sorted(path.name for path in ROOT.iterdir() if path.suffix == ".py")
    assert len(files) <= MOST_FILES_AT_THE_TOP, files


@pytest.mark.parametrize("room", sorted(path.name for path in ROOT.iterdir() if path.is_dir()))
def test_a_room_says_what_it_is_for(room):
    if room != "__pycache__":
        assert ast.get_docstring(TREES[f"wrinklestudy.{room}"])


@pytest.mark.parametrize("name", sorted(SOURCES))
def test_modules_and_functions_are_short_enough_to_read(name):
    assert len(SOURCES[name].splitlines()) <= MOST_LINES_OF_A_MODULE
    long = {
        function: lines
        for function, lines in functions_of(TREES[name])
        if lines > MOST_LINES_OF_A_FUNCTION
    }
    assert long == {}
