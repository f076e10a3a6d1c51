"""Memory of a job, which does without Python's search for garbage."""

import gc
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def no_garbage_collection() -> Iterator[None]:
    """Search for no garbage within a block, nor later among the objects made in it.

    A job of a second makes modules, not garbage: the search takes a fifth of the time outside the
    solves, some of it when Python ends.
    """
    gc.disable()
    try:
        yield
    finally:
        gc.freeze()
        gc.enable()
