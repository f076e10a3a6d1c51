"""Memory of a job: Python's search for garbage is left out."""

import gc
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def no_garbage_collection() -> Iterator[None]:
    """Let no objects be searched for garbage within a block; those made there never are.

    A job of a second makes modules, not garbage: looking through them for some takes a fifth of the
    time outside the solves, a part of it when Python ends.
    """
    gc.disable()
    try:
        yield
    finally:
        gc.freeze()
        gc.enable()
