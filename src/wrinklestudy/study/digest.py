"""Digest of the code behind a stage: it changes when the code changes, not when a comment does.

Snakemake does not see edits in an imported package, and of a script it sees every change. Each rule
therefore gets the digest of its script and of all modules of this package that the script imports,
directly or through others. Only the syntax trees count, without docstrings, comments and layout.
Templates of pages are in packages: a module that imports one has the templates in its digest. A
table of numbers beside a module, of its name, is in the digest of the module.
"""

import ast
import hashlib
from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from pathlib import Path

PACKAGE = "wrinklestudy"
SOURCE = Path(__file__).resolve().parents[2]


def code_digest(
    script: Path | str, also: Iterable[str] = (), sources: Sequence[Path] = (SOURCE,)
) -> str:
    """Return the digest of a script and of the package modules that it imports.

    Parameters
    ----------
    script : path
        Python script that runs a stage.
    also : iterable of str
        Names of further modules, which the script imports by a name that it computes.
    sources : sequence of path
        Folders with the packages whose code counts; code from elsewhere does not.

    Returns
    -------
    str
        Sixteen hexadecimal digits.
    """
    parts = [_read(Path(script))[0]]
    for name, path in sorted(modules(script, also, sources).items()):
        parts += [name, _read(path)[0]]
        for text in _read_by(path):
            parts += [text.name, text.read_text("utf-8")]
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:16]


def _read_by(path: Path) -> list[Path]:
    """Return the templates of a package, and the table beside a module."""
    if path.name == "__init__.py":
        return sorted(path.parent.glob("*.j2"))
    table = path.with_suffix(".csv")
    return [table] if table.is_file() else []


def modules(
    script: Path | str, also: Iterable[str] = (), sources: Sequence[Path] = (SOURCE,)
) -> dict[str, Path]:
    """Return name and file of the package modules that a script imports, directly or not.

    Imports inside functions count; those for type checkers only do not. The ``__init__`` of a
    package counts where something is imported from it, not for every module inside it.
    A module that is imported by a computed name is not seen: name it in ``also``.
    """
    files: dict[str, Path] = {}
    todo = [*also, *_imports(Path(script), "", sources)]
    while todo:
        name = todo.pop()
        path = module_file(name, sources)
        if path is not None and name not in files:
            files[name] = path
            package = name if path.name == "__init__.py" else name.rpartition(".")[0]
            todo += _imports(path, package, sources)
    return files


def module_file(name: str, sources: Sequence[Path]) -> Path | None:
    """Return the file of a module in one of the folders; None for any other module."""
    for source in sources if name else ():
        stem = source.joinpath(*name.split("."))
        for path in (stem.with_name(f"{stem.name}.py"), stem / "__init__.py"):
            if path.is_file():
                return path
    return None


def _imports(path: Path, package: str, sources: Sequence[Path]) -> Iterator[str]:
    """Yield the names of the modules that one file imports.

    ``from a import b`` is an import of the module ``a.b`` if there is one, else of ``a``.
    """
    for base, level, name in _read(path)[1]:
        if level:
            parents = package.split(".")[: len(package.split(".")) - level + 1]
            base = ".".join([*parents, *filter(None, [base])])
        inner = f"{base}.{name}"
        yield inner if name and module_file(inner, sources) else base


def _read(path: Path) -> tuple[str, tuple[tuple[str, int, str], ...]]:
    """Return what counts in a file: digest of its tree, and imports (module, level, name)."""
    stat = path.stat()
    return _read_version(path, stat.st_mtime_ns, stat.st_size)


@cache
def _read_version(path: Path, *_version: int) -> tuple[str, tuple[tuple[str, int, str], ...]]:
    tree = ast.parse(path.read_text(encoding="utf-8"), filename=str(path))
    imports: list[tuple[str, int, str]] = []
    for node in _nodes(tree):
        if isinstance(node, ast.Import):
            imports += [(alias.name, 0, "") for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            imports += [(node.module or "", node.level, alias.name) for alias in node.names]
    text = ast.dump(_WithoutDocstrings().visit(tree))
    return hashlib.sha256(text.encode()).hexdigest(), tuple(imports)


def _nodes(node: ast.AST) -> Iterator[ast.AST]:
    """Walk the statements of a tree, but not those that only type checkers see."""
    yield node
    children: Iterable[ast.AST] = ast.iter_child_nodes(node)
    if isinstance(node, ast.If) and ast.unparse(node.test).endswith("TYPE_CHECKING"):
        children = node.orelse
    for child in children:
        if not isinstance(child, ast.expr):
            yield from _nodes(child)


class _WithoutDocstrings(ast.NodeTransformer):
    def visit_Expr(self, node: ast.Expr) -> ast.Expr | None:
        """Drop a string that is a statement: a docstring, or a comment written as one."""
        text = isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)
        return None if text else node
