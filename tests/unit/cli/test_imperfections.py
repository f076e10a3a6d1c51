"""`wrinklestudy solve` of sheets that are not perfect."""

import json

import pytest

from wrinklestudy.cli import main

SHEET = ["--aspect", "2", "--thickness", "1e-3", "--c10", "6.21e4", "--c01", "1.58e5"]
COARSE = ["--cells-along", "4", "--cells-across", "12"]
SOLVE = ["solve", *SHEET, *COARSE, "--strain", "0.12"]


def test_all_imperfections_at_once(capsys):
    options = ["--shear", "0.01", "--rotate", "-0.01", "--twist", "0.01", "--thickness-along"]
    assert main([*SOLVE, "--symmetry", "whole", *options, "0.03", "--json"]) in (0, None)
    (state,) = json.loads(capsys.readouterr().out)
    assert state["status"] == "wrinkled"
    assert state["amplitude_low"] < state["amplitude_high"]
    assert state["bifurcation"] == "rounded"


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--shear", "0.01"], "clamps that are off need 'whole'"),
        (["--symmetry", "whole", "--shear", "3"], "--shear = 3: must be >= -0.5 and <= 0.5"),
        (["--symmetry", "whole", "--density", "900"], "--density: needs --length-mm"),
        (["--symmetry", "whole", "--gravity", "9"], "--gravity: needs --density"),
        (["--symmetry", "whole", "--thickness-along", "0.6"], "thickness along = 0.6: must be"),
        (["--symmetry", "whole", "--thickness-ripple", "0.1"], "is not AMPLITUDE:WAVELENGTH"),
        (["--symmetry", "whole", "--thickness-table", "none.csv"], "none.csv"),
    ],
)
def test_what_is_wrong_is_said_in_a_line(options, message, capsys):
    try:
        code = main([*SOLVE, *options])
    except SystemExit as stop:
        code = stop.code
    captured = capsys.readouterr()
    assert code != 0
    assert message in captured.err
    assert len(captured.err.strip().splitlines()) == 1


def test_a_table_of_thickness_is_read(tmp_path, capsys):
    """A table that is even changes nothing; one with a gap is refused."""
    even = tmp_path / "even.csv"
    rows = [f"{x},{y},0.14" for x in (-1.0, 0.0, 1.0) for y in (-0.5, 0.5)]
    even.write_text("x,y,thickness\n" + "\n".join(rows) + "\n")
    command = [*SOLVE, "--symmetry", "half", "--json"]
    main(command)
    (plain,) = json.loads(capsys.readouterr().out)
    main([*command, "--thickness-table", str(even)])
    (measured,) = json.loads(capsys.readouterr().out)
    assert measured["amplitude_low"] == pytest.approx(plain["amplitude_low"], rel=1e-6)
    even.write_text("x,y,thickness\n" + "\n".join(rows[:-1]) + "\n")
    with pytest.raises(SystemExit):
        raise SystemExit(main([*command, "--thickness-table", str(even)]))
    assert "each of the 6 combinations once" in capsys.readouterr().err
