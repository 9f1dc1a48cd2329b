"""The examples in Python do what their READMEs say."""
import re
import subprocess
from pathlib import Path

import pytest

examples = Path(__file__).parents[2] / "examples"


def test_the_gripper_lifts_the_ball(python, environment, tmp_path):
    script = examples / "20_gripper_python/gripper.py"
    done = subprocess.run([*python, script, "--cells", "64"], env=environment, cwd=tmp_path, capture_output=True, text=True,
                          timeout=120)
    assert done.returncode == 0, done.stderr
    closed, height, rest, rise, force = map(float, re.search(
        r"closed at t = (\S+);.*height (\S+) \(rest (\S+)\), finger rose (\S+), .*contact force (\S+)", done.stdout, re.S).groups())
    assert closed == pytest.approx(2.0, abs=0.05) and rise == pytest.approx(0.6, abs=0.003)
    assert height - rest == pytest.approx(rise, abs=0.005) and force == pytest.approx(2, abs=0.1)


def test_the_tutorials_code_runs(python, environment, tmp_path):
    """The blocks of docs/python.md, one after the other in one process."""
    pytest.importorskip("matplotlib")
    blocks = re.findall(r"```python\n(.*?)```", (examples.parent / "docs/python.md").read_text(), re.S)
    assert len(blocks) >= 6
    (tmp_path / "examples").symlink_to(examples)
    done = subprocess.run([*python, "-c", "\n".join(blocks)], env=environment | {"MPLBACKEND": "Agg"}, cwd=tmp_path,
                          capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "out/gapflow.pvd").exists() and (tmp_path / "pressure.png").read_bytes().startswith(b"\x89PNG")
