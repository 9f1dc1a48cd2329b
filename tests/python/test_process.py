"""The process around the package: Ctrl-C, MPI, imports."""
import os
import signal
import subprocess
import time
from pathlib import Path

import pytest
from conftest import plates_scene

import gapflow

folder = Path(__file__).parent


@pytest.mark.parametrize("files", [False, True])
def test_control_c_ends_a_long_run_after_a_step(python, environment, tmp_path, files):
    script = f"""
import gapflow, conftest
sim = gapflow.Simulation(conftest.ball_scene(cells=128), set={{"time.end": 1e6}}, output={str(tmp_path) if files else None!r})
print("ready", flush=True)
try:
    sim.run()
except KeyboardInterrupt:
    print(sim.steps, sim.report.step, flush=True)
    sim.step()
    print(sim.steps, flush=True)
    raise
"""
    run = subprocess.Popen([*python, "-c", script], env=environment, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                           text=True)
    try:
        assert run.stdout.readline() == "ready\n"
        time.sleep(0.3)
        run.send_signal(signal.SIGINT)
        sent = time.monotonic()
        out, error = run.communicate(timeout=20)
    finally:
        run.kill()
    assert time.monotonic() - sent < 10 and run.returncode == -signal.SIGINT and "KeyboardInterrupt" in error
    first, second = out.splitlines()
    steps, reported = map(int, first.split())
    assert steps > 0 and reported == steps and int(second) == steps + 1  # one can go on
    if files:
        rows = (tmp_path / "steps.csv").read_text().splitlines()
        assert rows[-1].startswith(f"{steps + 1},") and '"interrupted"' in (tmp_path / "run.json").read_text()


def test_two_ranks_share_the_fields_and_agree_on_the_rest(python, environment):
    mpiexec = os.environ.get("GAPFLOW_MPIEXEC")
    if not mpiexec:
        pytest.skip("GAPFLOW_MPIEXEC is not set")
    script = """
import sys, gapflow, conftest
rank, size = gapflow.rank()
sim = gapflow.Simulation(conftest.plates_scene())
sim.run()
row = f"{size} {rank} {sim.grid.low} {sim.velocity.shape} {sim.bodies['upper'].centre[1]:.9f}"
sys.stdout.write(row + chr(10))
"""
    words = [mpiexec, "-n", "2", *python, "-c", script]
    out = subprocess.run(words, env=environment, cwd=folder, capture_output=True, text=True, check=True, timeout=60).stdout
    first, second = sorted(out.splitlines())
    sim = gapflow.Simulation(plates_scene())
    sim.run()
    centre = f"{sim.bodies['upper'].centre[1]:.9f}"
    assert first.startswith("2 0 (0, 0)") and second.startswith("2 1 ") and first.split()[-1] == second.split()[-1] == centre
    shapes = [eval(row[row.index(") (") + 2:row.rindex(")") + 1]) for row in (first, second)]
    assert sum(shape[0] * shape[1] for shape in shapes) == 40 * 40


def test_importing_starts_nothing_and_needs_no_plotting(python, environment):
    script = """
import sys, gapflow, gapflow.plot
loaded = [name for name in ("matplotlib", "vtkmodules", "pyvista") if name in sys.modules]
maps = open("/proc/self/maps").read()
print(loaded, "mca_pml" in maps)
"""
    out = subprocess.run([*python, "-c", script], env=environment, capture_output=True, text=True, check=True).stdout
    assert out == "[] False\n"
    assert (Path(gapflow.__file__).parent / "py.typed").exists() and gapflow.__version__.count(".") == 2


def test_everything_public_is_documented():
    def undocumented(owner, names):
        return [name for name in names if not (getattr(owner, name).__doc__ or "").strip()]

    assert not undocumented(gapflow, [n for n in gapflow.__all__ if n != "SceneLike"])
    methods = [n for n, value in vars(gapflow.Simulation).items() if not n.startswith("_") and n != "time"]
    assert not undocumented(gapflow.Simulation, methods)
    states = [n for n in vars(gapflow.BodyState) if not n.startswith("_") and n not in ("name", "motion")]
    assert not undocumented(gapflow.BodyState, states)
