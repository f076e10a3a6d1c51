"""What the README shows works as it stands there."""

import re
import subprocess
import sys
from pathlib import Path

README = (Path(__file__).parents[2] / "README.md").read_text()


def test_the_library_example_prints_a_wrinkled_state():
    (example,) = re.findall(r"```python\n(.*?)```", README, flags=re.DOTALL)
    run = subprocess.run(
        [sys.executable, "-c", example], capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stderr
    status, amplitude = run.stdout.split()
    assert status == "wrinkled"
    assert 1 < float(amplitude) < 10
