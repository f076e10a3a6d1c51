"""The JSON schema of a config, from which editors check one while it is written.

``python -m wrinklestudy.study.config.schema config/schema.json`` writes it (``make schema``).
"""

import copy
import json
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from wrinklestudy.study.config.model import StudyConfig
from wrinklestudy.typing import AnyPath


def schema() -> dict[str, Any]:
    """Return the schema of a config file, draft 2020-12 of JSON Schema.

    A file given with ``--configfile`` holds only what differs from ``config.yaml``, and Snakemake
    merges blocks key by key. So no key of a block is required here. A list replaces the whole list,
    so that its entries are complete.
    """
    whole = copy.deepcopy(StudyConfig.model_json_schema())
    _relax(whole, whole)
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        **whole,
        "title": "Config of a study",
    }


def _relax(whole: dict[str, Any], block: dict[str, Any]) -> None:
    """Make no key required in a block and in the blocks within it, except in lists."""
    block.pop("required", None)
    if "patternProperties" in block:  # of names; pydantic allows others
        block["additionalProperties"] = False
    inner = [*block.get("properties", {}).values(), *block.get("patternProperties", {}).values()]
    for value in inner:
        named = value.get("$ref", "").rpartition("/")[2]
        _relax(whole, whole["$defs"][named] if named else value)


def text(content: Mapping[str, Any]) -> str:
    """Return a schema as the text of its file."""
    return json.dumps(content, indent=2, ensure_ascii=False) + "\n"


def write(path: AnyPath) -> None:
    """Write the schema of a config to a file."""
    Path(path).write_text(text(schema()), encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python -m wrinklestudy.study.config.schema FILE")
    write(sys.argv[1])
