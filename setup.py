"""Builds gapflow._core with CMake; all else is in pyproject.toml. Words in GAPFLOW_CMAKE_ARGS go to CMake, and so do CMake's
own variables (CMAKE_GENERATOR, CMAKE_BUILD_PARALLEL_LEVEL, ...)."""
import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

root = Path(__file__).resolve().parent


class CMakeBuild(build_ext):
    def build_extension(self, ext):
        package = Path(self.get_ext_fullpath(ext.name)).resolve().parent
        folder = Path(self.build_temp).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        generator = ["-G", "Ninja"] if shutil.which("ninja") and "CMAKE_GENERATOR" not in os.environ else []
        subprocess.run(["cmake", "-S", root, "-B", folder, *generator, f"-DPython_EXECUTABLE={sys.executable}",
                        f"-DGAPFLOW_PYTHON_OUTPUT={package}", "-DGAPFLOW_PYTHON=ON", "-DGAPFLOW_TESTS=OFF",
                        *shlex.split(os.environ.get("GAPFLOW_CMAKE_ARGS", ""))], check=True)
        subprocess.run(["cmake", "--build", folder, "--parallel", *([] if "CMAKE_BUILD_PARALLEL_LEVEL" in os.environ
                                                                    else [str(os.cpu_count())]),
                        "--target", "gapflow_python"], check=True)


version = re.search(r"project\(gapflow VERSION ([0-9.]+)", (root / "CMakeLists.txt").read_text()).group(1)
setup(version=version, ext_modules=[Extension("gapflow._core", sources=[])], cmdclass={"build_ext": CMakeBuild})
