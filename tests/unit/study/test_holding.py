"""Who holds a folder of results."""

import os
import subprocess
import sys

import pytest

from wrinklestudy.study.holding import (
    FolderHeldError,
    hold,
    is_held,
    makes_files,
    remove_left_locks,
)


def test_a_folder_is_held_once_and_free_again_when_its_holder_ends(tmp_path):
    results = str(tmp_path / "results")
    assert not is_held(results)
    with hold(results):
        assert is_held(results)
        with pytest.raises(FolderHeldError) as refused:
            hold(results)
        line = f"{results}: a run works here already (process {os.getpid()} on "
        assert str(refused.value).startswith(line)
        assert "\n" not in str(refused.value)
        hold(str(tmp_path / "others")).close()
    assert not is_held(results)
    hold(results).close()


def test_a_killed_holder_holds_nothing(tmp_path):
    results = str(tmp_path / "results")
    code = "import sys; from wrinklestudy.study.holding import hold; held = hold(sys.argv[1]);"
    code += "print('held', flush=True); sys.stdin.read()"
    holder = subprocess.Popen(
        [sys.executable, "-c", code, results], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    )
    assert holder.stdout.readline() == b"held\n"
    with pytest.raises(FolderHeldError, match=f"process {holder.pid} on"):
        hold(results)
    holder.kill()
    holder.communicate()
    hold(results).close()


def test_a_file_in_the_place_of_the_folder_is_one_line(tmp_path):
    (tmp_path / "results").write_text("")
    with pytest.raises(FolderHeldError, match="cannot be written"):
        hold(str(tmp_path / "results"))


def test_only_locks_of_the_folder_itself_are_removed(tmp_path):
    locks = tmp_path / "locks"
    locks.mkdir()
    own, others = locks / "0.output.lock", locks / "1.output.lock"
    own.write_text("results/planar/latex/strain0.1.h5\n")
    others.write_text("results/quick/planar/latex/strain0.1.h5\n")
    assert remove_left_locks(tmp_path, ["results/mesh", "results/planar"])
    assert [path.name for path in locks.iterdir()] == [others.name]
    assert not remove_left_locks(tmp_path, ["results/mesh", "results/planar"])


@pytest.mark.parametrize(
    "words",
    [
        "-n",
        "-np",
        "--dry-run --cores 2",
        "--dryrun",
        "--cores 2 --report report.html",
        "--report=report.html",
        "--lint",
        "--unlock",
        "--rulegraph mermaid-js",
        "--summary",
        "-D",
        "--list-changes code",
    ],
)
def test_what_only_asks_holds_nothing(words):
    assert not makes_files(words.split())


@pytest.mark.parametrize(
    "words",
    [
        "--cores 2 --configfile config/quick.yaml",
        "-c2 -p -k",
        "--cores all results/planar/n/strain0.1.h5",
        "--rerun-incomplete -F",
        "--notemp",
        "-c 1 --nolock",
    ],
)
def test_what_makes_files_does(words):
    assert makes_files(words.split())
