"""Builds gapflow._core with CMake; all else is in pyproject.toml. Words in GAPFLOW_CMAKE_ARGS go to CMake, and so do CMake's
own variables (CMAKE_GENERATOR, CMAKE_BUILD_PARALLEL_LEVEL, ...).

Where the clone has a build tree in build/release, as tools/quickstart leaves it, the module is built there, and what is compiled already is not
compiled again. GAPFLOW_BUILD names another tree; GAPFLOW_BUILD=none, or GAPFLOW_CMAKE_ARGS, builds all anew.
"""
import os
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

root = Path(__file__).resolve().parent


def build_tree():
    """The build tree to use, if there is one of this clone, for release; else None."""
    named = os.environ.get("GAPFLOW_BUILD", "")
    if named == "none" or "GAPFLOW_CMAKE_ARGS" in os.environ:
        return None
    folder = Path(named).resolve() if named else root / "build" / "release"
    cache = folder / "CMakeCache.txt"
    entries = dict(re.findall(r"^([^#/:=]+):[A-Z]+=(.*)$", cache.read_text(), re.M)) if cache.is_file() else {}
    fits = entries.get("CMAKE_HOME_DIRECTORY") == str(root) and entries.get("CMAKE_BUILD_TYPE") == "Release"
    if named and not fits:
        sys.exit(f"GAPFLOW_BUILD={named}: not a release build of {root}; configure one there with cmake --preset release, or leave it out")
    return folder if fits else None


def parallel():
    return ["--parallel", *([] if "CMAKE_BUILD_PARALLEL_LEVEL" in os.environ else [str(os.cpu_count())])]


class CMakeBuild(build_ext):
    def build_extension(self, ext):
        package = Path(self.get_ext_fullpath(ext.name)).resolve().parent
        tree = build_tree()
        if tree and self.take_from(tree, Path(self.get_ext_fullpath(ext.name))):
            return
        folder = Path(self.build_temp).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        generator = ["-G", "Ninja"] if shutil.which("ninja") and "CMAKE_GENERATOR" not in os.environ else []
        subprocess.run(["cmake", "-S", root, "-B", folder, *generator, f"-DPython_EXECUTABLE={sys.executable}",
                        f"-DGAPFLOW_PYTHON_OUTPUT={package}", "-DGAPFLOW_PYTHON=ON", "-DGAPFLOW_TESTS=OFF", "-DCMAKE_UNITY_BUILD=ON",
                        *shlex.split(os.environ.get("GAPFLOW_CMAKE_ARGS", ""))], check=True)
        subprocess.run(["cmake", "--build", folder, *parallel(), "--target", "gapflow_python"], check=True)

    def take_from(self, tree, module):
        """Builds the module in a tree and copies it; False if the tree's is for another python."""
        subprocess.run(["cmake", "-S", root, "-B", tree, "-DGAPFLOW_PYTHON=ON"], check=True)
        for entry in (tree / "CMakeCache.txt").read_text().splitlines():
            name, _, python = entry.partition("=")
            if name.startswith("Python_EXECUTABLE:") or name.startswith("_Python_EXECUTABLE:"):
                suffix = subprocess.run([python, "-c", "import sysconfig; print(sysconfig.get_config_var('EXT_SUFFIX'))"],
                                        capture_output=True, text=True).stdout.strip()
                if suffix == sysconfig.get_config_var("EXT_SUFFIX"):
                    break
        else:
            return False
        subprocess.run(["cmake", "--build", tree, *parallel(), "--target", "gapflow_python"], check=True)
        module.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(tree / "python" / "gapflow" / module.name, module)
        return True


version = re.search(r"project\(gapflow VERSION ([0-9.]+)", (root / "CMakeLists.txt").read_text()).group(1)
setup(version=version, ext_modules=[Extension("gapflow._core", sources=[])], cmdclass={"build_ext": CMakeBuild})
