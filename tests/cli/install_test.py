"""What `cmake --install` leaves is used: the command, manual pages, completions, examples, and a program of another project.

Usage: install_test.py GAPFLOW BUILD CMAKE
"""
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import harness

BUILD, CMAKE = sys.argv.pop(1), sys.argv.pop(1)


def run(*words, **options):
    done = subprocess.run([*map(str, words)], capture_output=True, text=True, timeout=600, **options)
    assert done.returncode == 0, f"{words}\n{done.stdout}{done.stderr}"
    return done.stdout


class Install(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.prefix = Path(cls.folder.name) / "prefix"
        run(CMAKE, "--install", BUILD, "--prefix", cls.prefix)

    def test_command_and_example(self):
        command = self.prefix / "bin" / "gapflow"
        self.assertRegex(run(command, "--version"), r"gapflow \d+\.\d+\.\d+")
        example = self.prefix / "share" / "gapflow" / "examples" / "01_plates_pulled_apart" / "scene.toml"
        self.assertIn("lower - upper", run(command, "check", example))

    def test_manual_pages_name_every_command_and_table(self):
        manual = (self.prefix / "share" / "man" / "man1" / "gapflow.1").read_text()
        commands = re.findall(r"^  ([a-z-]+) +\S", harness.gapflow("--help").stdout.split("Subcommands:")[1], re.M)
        self.assertGreater(len(commands), 5)
        for name in commands:
            self.assertIn(f".SS gapflow {name}".replace("-", "\\-"), manual)
        self.assertIn(".SH [[body]]", (self.prefix / "share" / "man" / "man5" / "gapflow-scene.5").read_text())

    def test_bash_completes(self):
        script = self.prefix / "share" / "bash-completion" / "completions" / "gapflow"

        def completed(*words):
            line = " ".join(words)
            code = f'''source {script}; PATH={self.prefix}/bin:$PATH
                COMP_WORDS=({" ".join(repr(w) for w in words)}); COMP_CWORD={len(words) - 1}; COMP_LINE={line!r}
                compopt() {{ :; }}
                _gapflow gapflow "${{COMP_WORDS[COMP_CWORD]}}" "${{COMP_WORDS[COMP_CWORD-1]}}"; printf '%s\\n' "${{COMPREPLY[@]}}"'''
            return run("bash", "-c", code, cwd=self.prefix / "share" / "gapflow" / "examples" / "12_check_valve").split()

        self.assertEqual(completed("gapflow", "ad"), ["added-mass"])
        self.assertEqual(completed("gapflow", "run", "--re"), ["--resume"])
        self.assertEqual(completed("gapflow", "run", "sc"), ["scene.toml"])
        self.assertIn("gap.model=", completed("gapflow", "run", "scene.toml", "--set", "gap."))

    def test_other_completions_are_there(self):
        for file in ("zsh/vendor-completions/_gapflow", "fish/vendor_completions.d/gapflow.fish"):
            self.assertIn("added-mass", (self.prefix / "share" / file).read_text())

    def test_a_program_of_another_project(self):
        build = Path(self.folder.name) / "build"
        examples = self.prefix / "share" / "gapflow" / "examples"
        run(CMAKE, "-S", examples / "21_cpp_program", "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}", "-DCMAKE_BUILD_TYPE=Debug")
        run(CMAKE, "--build", build)
        scene = Path(self.folder.name) / "short.toml"
        scene.write_text((examples / "01_plates_pulled_apart" / "scene.toml").read_text()
                         .replace("cells = [128, 128]", "cells = [64, 64]").replace("end = 0.7", "end = 0.01"))
        first = run(build / "watch_gaps", scene).splitlines()[0]
        self.assertRegex(first, r"upper - lower: thickness 0\.0100\d, force -0\.9\d")


if __name__ == "__main__":
    unittest.main()
