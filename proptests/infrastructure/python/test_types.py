# SPDX-License-Identifier: Apache-2.0
"""The types of the module hold, as a user's checker sees them."""
import importlib.util
import pathlib
import subprocess
import sys

import pytest
import touchstone

PACKAGE = pathlib.Path(touchstone.__file__).parent
USE = """
from fractions import Fraction
import numpy
import touchstone
from numpy.typing import NDArray

sides: NDArray[numpy.uint8] = touchstone.orientation(numpy.zeros(2), (0.0, 1.0), numpy.zeros((3, 2)))
side: touchstone.Side = touchstone.Side(int(sides[0]))
truth: touchstone.Truth = touchstone.truth("orientation", {"p0": [0, 0], "p1": [1, 0], "p": [0, 1]})
margin: Fraction = truth.margin or Fraction(0)
questions: list[touchstone.Question] = touchstone.draw("orientation", cases=3, families=["collinear"])
"""


def test_the_package_says_that_it_is_typed():
    assert (PACKAGE / "py.typed").is_file() and (PACKAGE / "_touchstone.pyi").is_file()


def test_the_stub_declares_what_the_extension_has():
    declared = {line.split("(")[0][4:] for line in (PACKAGE / "_touchstone.pyi").read_text().splitlines() if line.startswith("def ")}
    assert declared == {name for name in dir(touchstone._touchstone) if not name.startswith("_")}


@pytest.mark.parametrize("text, is_right", [(USE, True), (USE.replace("sides: NDArray[numpy.uint8]", "sides: str"), False),
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
