"""A job logs, and leaves the search for garbage out; either without the other."""

import gc
import logging
import warnings
from contextlib import contextmanager

import pytest

from wrinklestudy.stages.log import log_cpu, log_to
from wrinklestudy.stages.memory import no_garbage_collection


@contextmanager
def own_process():
    """Let a block set up logging as a job does, which has the process to itself."""
    root = logging.getLogger()
    handlers, level = root.handlers[:], root.level
    root.handlers = []
    try:
        yield
    finally:
        for handler in root.handlers:
            handler.close()
        root.handlers, root.level = handlers, level
        logging.captureWarnings(False)


def test_a_log_has_warnings_and_times_and_garbage_is_collected_as_ever(tmp_path):
    path = tmp_path / "log" / "job.log"
    with own_process(), log_to(str(path)), warnings.catch_warnings():
        warnings.simplefilter("always")
        warnings.warn("close to singular", stacklevel=1)
        with log_cpu("solve"):
            assert gc.isenabled()
    text = path.read_text()
    assert "close to singular" in text
    assert "solve: " in text
    assert "job: " in text
    assert gc.get_freeze_count() == 0


def test_a_wrong_input_ends_a_job_with_its_line_and_the_log_has_the_traceback(tmp_path):
    path = tmp_path / "job.log"
    with pytest.raises(SystemExit) as ended, own_process(), log_to(str(path)):
        raise ValueError("a.csv, line 3: no number")
    assert ended.value.code == "a.csv, line 3: no number"
    assert "Traceback" in path.read_text()


@pytest.mark.parametrize(
    ("error", "line"),
    [
        (OSError("a.h5: cannot be written (No space left on device)"), "a.h5: cannot be written"),
        (MemoryError(), "not enough memory"),
    ],
)
def test_a_fault_of_the_machine_ends_a_job_with_one_line(tmp_path, error, line):
    with pytest.raises(SystemExit) as ended, own_process(), log_to(str(tmp_path / "job.log")):
        raise error
    assert ended.value.code.startswith(line)
    assert "\n" not in ended.value.code


def test_a_log_that_cannot_be_written_ends_a_job_with_one_line(tmp_path):
    (tmp_path / "log").write_text("")
    with pytest.raises(SystemExit) as ended, own_process(), log_to(f"{tmp_path}/log/job.log"):
        raise AssertionError("the job must not begin")
    assert str(tmp_path / "log") in ended.value.code


def test_an_error_of_the_program_goes_on_after_it_is_logged(tmp_path):
    path = tmp_path / "job.log"
    with pytest.raises(KeyError), own_process(), log_to(str(path)):
        raise KeyError("lost")
    assert "KeyError: 'lost'" in path.read_text()


@pytest.mark.parametrize("error", [None, ValueError])
def test_no_garbage_is_looked_for_within_the_block_and_it_is_after(error):
    def job():
        with no_garbage_collection():
            assert not gc.isenabled()
            if error:
                raise error

    if error:
        with pytest.raises(error):
            job()
    else:
        job()
    assert gc.isenabled()
    assert gc.get_freeze_count() > 0
    gc.unfreeze()
