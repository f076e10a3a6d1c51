"""Work that several processes share."""

import signal
from collections.abc import Callable, Iterator, Sequence
from typing import TypeVar

from wrinklestudy.files import origin

Given = TypeVar("Given")
Result = TypeVar("Result")


def in_processes(
    work: Callable[[Given], Result], tasks: Sequence[Given], jobs: int
) -> Iterator[Result]:
    """Yield the results of all tasks, in their order, from processes of one thread each.

    Raises
    ------
    MemoryError
        If one of the processes was killed, which is what systems do where memory is short.
    """
    import multiprocessing
    from concurrent.futures import ProcessPoolExecutor
    from concurrent.futures.process import BrokenProcessPool

    context = multiprocessing.get_context("spawn")  # BLAS does not outlive a fork
    pool = ProcessPoolExecutor(jobs, context, initializer=_begin, initargs=(origin.current(),))
    try:
        yield from pool.map(work, tasks)
    except BrokenProcessPool:
        text = f"one of {jobs} processes was killed; fewer --jobs need less memory"
        raise MemoryError(text) from None
    except BaseException:
        for process in multiprocessing.active_children():
            process.terminate()
        raise
    finally:
        pool.shutdown(cancel_futures=True)


def _begin(stated: str) -> None:
    """Begin a process, with the origin of the files that it writes.

    Ctrl-C ends it without a traceback: the parent says what there is to say.
    """
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    origin.take_over(stated)
