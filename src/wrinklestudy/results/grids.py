"""Mesh files, which meshio and ParaView read."""

from pathlib import Path

import numpy as np

from wrinklestudy.fem.grid import Grid
from wrinklestudy.files.origin import append_comment
from wrinklestudy.files.records import check
from wrinklestudy.files.storage import atomic_path


def write_grid(grid: Grid, output: Path | str) -> None:
    """Write a grid as quadrilaterals in a mesh file; the format follows from the suffix."""
    import meshio

    nodes = np.array([(x, y, 0.0) for x in grid.x for y in grid.y])
    numbers = np.arange(len(nodes)).reshape(len(grid.x), len(grid.y))
    corners = (numbers[:-1, :-1], numbers[1:, :-1], numbers[1:, 1:], numbers[:-1, 1:])
    quads = np.stack([corner.ravel() for corner in corners], axis=1)
    with atomic_path(output) as path:
        meshio.write(path, meshio.Mesh(nodes, [("quad", quads)]))
        if path.suffix == ".vtu":
            append_comment(path)


def read_grid(path: Path | str) -> Grid:
    """Read a grid back from its mesh file.

    Raises
    ------
    ValueError
        If the file does not hold the nodes of a tensor grid; `DamagedFileError` if it is not
        what its record says.
    """
    import meshio

    check(path)

    points = meshio.read(path).points
    x, y = np.unique(points[:, 0]), np.unique(points[:, 1])
    if len(x) * len(y) != len(points):
        raise ValueError(f"{path}: {len(points)} nodes are not a {len(x)} x {len(y)} tensor grid")
    return Grid(x, y)
