"""What a reader of YAML gets wrong without a word: repeated keys, numbers read as others, loops."""

import re
from collections.abc import Iterator
from pathlib import Path

import yaml

# Numbers that people read as YAML does. Not these: 1_000, 010 (octal), 0x10, 1:30 (base 60).
_PLAIN = re.compile(r"[-+]?(0|[1-9][0-9]*|[0-9]*\.[0-9]+|[0-9]+\.[0-9]*)([eE][-+]?[0-9]+)?")
_NUMBERS = ("tag:yaml.org,2002:int", "tag:yaml.org,2002:float")
_MOST_ENTRIES, _DEEPEST = 100_000, 50
_NOT_FINITE = re.compile(r"[-+]?\.(inf|Inf|INF)|\.(nan|NaN|NAN)")


def misleading(path: str) -> list[str]:
    """Return what is misleading in a YAML file: one line of text each, with file, line and key.

    Parameters
    ----------
    path : str
        YAML or JSON file whose syntax is right.
    """
    root = yaml.compose(Path(path).read_text(encoding="utf-8"), Loader=yaml.SafeLoader)
    if root is None:
        return []
    problems = _endless(root) or sorted(set(_problems(root, "")))
    return [f"{path}, line {line + 1}: {text}" for line, text in problems]


def _endless(root: yaml.Node) -> list[tuple[int, str]]:
    """Return line (from 0) and text if aliases make a file endless, or as good as that."""
    count, todo = 0, [(root, "", frozenset[int]())]
    while todo:
        node, key, above = todo.pop()
        count += 1
        if id(node) in above:
            return [(node.start_mark.line, f"{key}: contains itself, by an alias")]
        if len(above) > _DEEPEST:
            return [(node.start_mark.line, f"lists and blocks in each other, over {_DEEPEST} deep")]
        if count > _MOST_ENTRIES:
            return [(0, f"has more than {_MOST_ENTRIES:,} entries, counted as often as aliased")]
        within = above | {id(node)}
        if isinstance(node, yaml.MappingNode):
            for name, value in node.value:
                inner = name.value if isinstance(name, yaml.ScalarNode) else "?"
                todo += [(name, key, within), (value, f"{key}.{inner}".removeprefix("."), within)]
        elif isinstance(node, yaml.SequenceNode):
            todo += [(entry, f"{key}[{i}]", within) for i, entry in enumerate(node.value)]
    return []


def _problems(node: yaml.Node, key: str) -> Iterator[tuple[int, str]]:
    """Yield line (from 0) and text of each problem in a part of a file."""
    if isinstance(node, yaml.MappingNode):
        lines: dict[str, int] = {}
        for name, value in node.value:
            inner = f"{key}.{name.value}".removeprefix(".")
            line = name.start_mark.line
            if not isinstance(name, yaml.ScalarNode):
                continue  # no key of a config; refused when the content is checked
            if name.value in lines:
                yield line, f"{inner} stands twice, first in line {lines[name.value] + 1}"
            lines[name.value] = line
            yield from _problems(value, inner)
    elif isinstance(node, yaml.SequenceNode):
        for index, value in enumerate(node.value):
            yield from _problems(value, f"{key}[{index}]")
    elif isinstance(node, yaml.ScalarNode) and _is_odd(node):
        read = yaml.safe_load(node.value)
        text = f"{key} = {node.value}: YAML reads {read}; write plain digits"
        yield node.start_mark.line, text


def _is_odd(node: yaml.ScalarNode) -> bool:
    """Return whether YAML reads a number differently from how it looks."""
    text = node.value
    odd = not (_PLAIN.fullmatch(text) or _NOT_FINITE.fullmatch(text))
    return odd and node.tag in _NUMBERS and node.style is None
