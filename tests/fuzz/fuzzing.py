"""Property-based fuzzing: how many examples, what is thrown at the readers, what is allowed."""

import linecache
import os
import signal
import traceback
from contextlib import contextmanager
from pathlib import Path

from hypothesis import HealthCheck, Phase, settings
from hypothesis import strategies as st

# `make test-fuzz` sets it; otherwise the same few hundred every time, so that tests do not flicker.
GIVEN = os.environ.get("FUZZ_EXAMPLES")
SECONDS = 30


def fuzzed(share=1.0):
    """Run a test on some hundred examples, or on as many as are asked for; fewer if it is slow."""
    return settings(
        max_examples=max(1, round(share * int(GIVEN or 300))),
        derandomize=GIVEN is None,
        database=None,
        deadline=None,
        suppress_health_check=list(HealthCheck),
        phases=[Phase.explicit, Phase.generate],  # to make a broken file smaller takes minutes
    )


@contextmanager
def in_time():
    """Fail where something takes longer than half a minute."""

    def late(*_):
        raise AssertionError(f"took longer than {SECONDS} s")

    before = signal.signal(signal.SIGALRM, late)
    signal.alarm(SECONDS)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


def is_said(error):
    """Return whether an error was raised on purpose, by a line of this package that raises."""
    last = traceback.extract_tb(error.__traceback__)[-1]
    line = linecache.getline(last.filename, last.lineno).strip()
    return "wrinklestudy" in last.filename and line.startswith("raise ")


def outcome(action, path):
    """Return what a reader returns, or its error: one line that names the file, said on purpose."""
    with in_time():
        try:
            return action()
        except ValueError as error:
            raised = error
    assert is_said(raised), "".join(traceback.format_exception(raised))
    assert "\n" not in str(raised), str(raised)
    assert path.name in str(raised), str(raised)
    return raised


# What ends up in files of numbers, names and paths that people, scripts and spreadsheets write.
_NUMBERS = (
    "nan NaN inf -inf 1e999 -1e999 1e-320 5e-324 -0 0 -1 1_0 1,5 1. . + 0x10 1e --1 ٣ ½ #N/A 1;2"
)
_MARKS = '\' " """ \\ ` # % { } {} {{7*7}} [ ] , ; : | .. . / ~ * ? @x -x --help con ]]> <!--'
_CODE = (
    "$(touch x)",
    "`touch x`",
    "; touch x",
    "${HOME}",
    "../x",
    "/x",
    "a/../../x",
    "<script>alert(1)</script>",
    "&amp;",
    "{% x %}",
    "&a [*a]",
    "!!python/object/apply:os.system ['touch x']",
    "<<: *x",
    "? x",
    "- -",
)
_SPACE = ("", " ", "1 000", "\t", "\n", "\r", "\r\n", "\x00", "\x1b", "\ufeff", "\u2028")
ODD = st.sampled_from([*_NUMBERS.split(), *_MARKS.split(), *_CODE, *_SPACE, "x" * 300])
JUNK = ODD | st.text(max_size=8)

_EDITS = st.lists(
    st.tuples(
        st.sampled_from(["insert", "replace", "cut", "word", "drop line", "twice", "swap"]),
        st.floats(0.0, 1.0, exclude_max=True),
        st.integers(1, 12),
        JUNK,
    ),
    min_size=1,
    max_size=4,
)


def _edited(text, edit):
    kind, place, length, junk = edit
    at = int(place * (len(text) + 1))
    if kind == "insert":
        return text[:at] + junk + text[at:]
    if kind == "replace":
        return text[:at] + junk + text[at + length :]
    if kind == "cut":
        return text[:at]
    if kind == "word":  # a whole word or cell
        start = max(text.rfind(mark, 0, at) for mark in " ,\n\t[:") + 1
        ends = [end for mark in " ,\n\t]:" if (end := text.find(mark, start)) >= 0]
        return text[:start] + junk + text[min(ends, default=len(text)) :]
    rows = text.split("\n")
    row = int(place * len(rows))
    if kind == "drop line":
        del rows[row]
    elif kind == "twice":
        rows[row:row] = [rows[row]] * length
    else:
        other = (row + length) % len(rows)
        rows[row], rows[other] = rows[other], rows[row]
    return "\n".join(rows)


def broken(*texts):
    """Return a strategy for the bytes of files that were sound before someone edited them."""

    def apply(text, edits, flips):
        for edit in edits:
            text = _edited(text, edit)
        raw = bytearray(text.encode("utf-8", errors="surrogatepass"))
        for place, bit in flips:
            if raw:
                raw[int(place * len(raw))] ^= 1 << bit
        return bytes(raw)

    place = st.floats(0.0, 1.0, exclude_max=True)
    flips = st.just([]) | st.lists(st.tuples(place, st.integers(0, 7)), max_size=3)
    return st.builds(apply, st.sampled_from(texts), _EDITS, flips) | st.binary(max_size=60)


def tree(folder):
    """Return the names of everything in a folder."""
    return {path.relative_to(folder).as_posix() for path in Path(folder).rglob("*")}
