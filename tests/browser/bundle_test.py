"""The script and style in the repository are what web/src gives. Usage: bundle_test.py NODE PROJECT; exit status 77: skipped."""
import subprocess
import sys
import tempfile
from pathlib import Path

node, project = sys.argv[1], Path(sys.argv[2])
web, assets = project / "web", project / "src" / "gapflow" / "output" / "assets"
if not (web / "node_modules" / "esbuild").is_dir():
    print("skipped: no web/node_modules; web/test installs them")
    sys.exit(77)
with tempfile.TemporaryDirectory() as folder:
    subprocess.run([node, web / "build.mjs", folder], check=True)
    made = sorted(path.name for path in Path(folder).iterdir())
    assert made == ["LICENSES.txt", "report.css", "report.html", "report_2d.js", "report_3d.js"], made
    stale = [name for name in made if (Path(folder) / name).read_bytes() != (assets / name).read_bytes()]
if stale:
    sys.exit(f"not what web/src gives: {', '.join(stale)}; run web/build")
print("the pages' script and style are what web/src gives")
