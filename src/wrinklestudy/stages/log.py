"""Log file of a job: what it warned of, its CPU time, and the whole traceback if it failed."""

import logging
import sys
import time
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from wrinklestudy.vocabulary import one_line

_LOGGER = logging.getLogger(__name__)


@contextmanager
def log_cpu(part: str) -> Iterator[None]:
    """Log the CPU time that a block took in this process, to tell solving from the rest of a job.

    Parameters
    ----------
    part : str
        What the block does.
    """
    start = time.process_time()
    yield
    _LOGGER.info("%s: %.3f s of CPU", part, time.process_time() - start)


@contextmanager
def log_to(path: str) -> Iterator[None]:
    """Send log messages and warnings to a file, and errors before the job ends with them.

    A `ValueError` or a missing file is a fault of the input, an `OSError` one of the disk, and a
    `MemoryError` one of the machine: the log gets the traceback, the terminal the one line of its
    message. Nobody has the log where the disk is full.

    Parameters
    ----------
    path : str
        Log file; an old one is replaced.
    """
    form = "%(asctime)s %(levelname)s %(name)s: %(message)s"
    logging.raiseExceptions = False  # a log that the disk has no room for is no fault of the job
    try:
        Path(path).parent.mkdir(parents=True, exist_ok=True)
        logging.basicConfig(filename=path, filemode="w", level=logging.INFO, format=form)
        logging.captureWarnings(True)
        yield
        _LOGGER.info("job: %.3f s of CPU", time.process_time())
    except (ValueError, OSError, MemoryError) as error:
        logging.error(traceback.format_exc())
        sys.exit(one_line(str(error)) or "not enough memory")
    except BaseException:
        logging.error(traceback.format_exc())
        raise
