"""Log file of a job: what it warned of, and the whole traceback if it failed."""

import logging
import sys
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def log_to(path: str) -> Iterator[None]:
    """Send log messages and warnings to a file, and errors too before the job ends with them.

    A `ValueError` or a missing file is a matter of the input: the log has the traceback, and on
    the terminal stands its one line.

    Parameters
    ----------
    path : str
        Log file; written anew.
    """
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    form = "%(asctime)s %(levelname)s %(name)s: %(message)s"
    logging.basicConfig(filename=path, filemode="w", level=logging.INFO, format=form)
    logging.captureWarnings(True)
    try:
        yield
    except (ValueError, FileNotFoundError) as error:
        logging.error(traceback.format_exc())
        sys.exit(str(error))
    except BaseException:
        logging.error(traceback.format_exc())
        raise
