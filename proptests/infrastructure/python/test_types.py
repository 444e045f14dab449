# SPDX-License-Identifier: Apache-2.0
"""The module as it is installed, and its types as a user's checker sees them."""
import importlib.util
import pathlib
import re
import shutil
import subprocess
import sys

import pytest
import touchstone

PACKAGE = pathlib.Path(touchstone.__file__).parent
BUILD, SOURCE = PACKAGE.parents[1], pathlib.Path(__file__).resolve().parents[3]
USE = """
from fractions import Fraction
import numpy
import touchstone
from numpy.typing import NDArray

sides: touchstone.Answers = touchstone.orientation(numpy.zeros(2), (0.0, 1.0), numpy.zeros((3, 2)))
numbers: NDArray[numpy.uint8] = sides.numbers
left: NDArray[numpy.bool_] = sides == touchstone.Side.left
inside: NDArray[numpy.bool_] = touchstone.polygon_contains(numpy.zeros((4, 2)), numpy.zeros((3, 2)), boundary=False)
polygon: touchstone.Polygon = touchstone.Polygon(numpy.zeros((4, 2)))
within: touchstone.Answers = touchstone.point_in_polygon(polygon, numpy.zeros((3, 2)))
truth: touchstone.Truth = touchstone.truth("orientation", {"p0": [0, 0], "p1": [1, 0], "p": [0, 1]})
margin: Fraction = truth.margin or Fraction(0)
questions: list[touchstone.Question] = touchstone.draw("orientation", cases=3, families=["collinear"])
"""


@pytest.mark.skipif(shutil.which("cmake") is None or not (BUILD / "cmake_install.cmake").is_file(), reason="not in CMake's folder")
def test_it_is_imported_by_the_path_that_is_documented(tmp_path):
    [place] = re.findall(r"PYTHONPATH=PREFIX/([^`]+)`", (SOURCE / "docs/python.md").read_text(encoding="utf-8"))
    place = place.replace("python3.11", f"python{sys.version_info.major}.{sys.version_info.minor}")
    subprocess.run(["cmake", "--install", BUILD, "--component", "python", "--prefix", tmp_path], check=True, stdout=subprocess.DEVNULL)
    imported = subprocess.run([sys.executable, "-c", "import touchstone; print(touchstone.__file__, touchstone.__version__)"],
                              capture_output=True, text=True, check=True, cwd=tmp_path, env={"PYTHONPATH": str(tmp_path / place)})
    assert imported.stdout.split() == [str(tmp_path / place / "touchstone/__init__.py"), touchstone.__version__]


def test_the_package_says_that_it_is_typed():
    assert (PACKAGE / "py.typed").is_file() and (PACKAGE / "_touchstone.pyi").is_file()


def test_the_stub_declares_what_the_extension_has():
    declared = set(re.findall(r"^(?:def|class) (\w+)", (PACKAGE / "_touchstone.pyi").read_text(), re.MULTILINE))
    assert declared == {name for name in dir(touchstone._touchstone) if not name.startswith("_")}


@pytest.mark.parametrize("text, is_right", [(USE, True), (USE.replace("sides: touchstone.Answers", "sides: str"), False),
                                            (USE.replace("margin: Fraction", "margin: list[int]"), False)])
def test_a_checker_accepts_right_uses_alone(tmp_path, text, is_right):
    if importlib.util.find_spec("mypy") is None:
        pytest.skip("mypy is not installed")
    (tmp_path / "use.py").write_text(text)
    checked = subprocess.run([sys.executable, "-m", "mypy", "--strict", "use.py"], cwd=tmp_path, capture_output=True, text=True,
                             env={"MYPYPATH": str(PACKAGE.parent), "PATH": "/usr/bin:/bin"})
    assert (checked.returncode == 0) == is_right, checked.stdout + checked.stderr


def test_every_name_is_documented():
    for name in touchstone.__all__:
        if name not in ("Exact", "SegmentRelation", "SegmentTriangleRelation"):
            assert getattr(touchstone, name).__doc__, name
