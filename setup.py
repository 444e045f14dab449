# SPDX-License-Identifier: Apache-2.0
"""A wheel of the Python module: pip wheel . --no-build-isolation (docs/python.md). CMake builds it, below build/wheel."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent


class WithCMake(build_ext):
    """Builds the target touchstone_python and takes the package as CMake has put it together."""

    def run(self):
        build = ROOT / "build/wheel"
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []
        off = [f"-DTOUCHSTONE_{part}=OFF" for part in ("TESTS", "FUZZ", "BENCH", "INSTALL")]
        subprocess.run(["cmake", "-S", ROOT, "-B", build, *generator, "-DCMAKE_BUILD_TYPE=Release", "-DTOUCHSTONE_COMPONENTS=c",
                        f"-DTOUCHSTONE_PYTHON_EXECUTABLE={sys.executable}", *off], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "touchstone_python", "-j", str(os.cpu_count() or 1)], check=True)
        package = pathlib.Path(self.get_ext_fullpath("touchstone._touchstone")).parent
        shutil.rmtree(package, ignore_errors=True)
        shutil.copytree(build / "python/touchstone", package, ignore=shutil.ignore_patterns("__pycache__"))


version = re.search(r"^project\(touchstone VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"), re.MULTILINE)
setup(version=version.group(1), packages=["touchstone"], package_dir={"touchstone": "python/touchstone"},
      package_data={"touchstone": ["py.typed", "*.pyi"]}, ext_modules=[Extension("touchstone._touchstone", sources=[])],
      cmdclass={"build_ext": WithCMake})
