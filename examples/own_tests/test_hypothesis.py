#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Hypothesis with questions of touchstone: pytest test_hypothesis.py, or python3 test_hypothesis.py.

The environment variable TOUCHSTONE names the program where it is not on the path.
"""
import json
import os
import subprocess
import sys

try:
    from hypothesis import given, settings, strategies
except ImportError:
    print("skipped: Hypothesis is not installed (python3-hypothesis)")
    sys.exit(77)


def questions(operation, cases=500, families="", seed=1):
    """A strategy of questions with their truth; shrinks to short ones."""
    command = [os.environ.get("TOUCHSTONE", "touchstone"), "draw", operation, "--cases", str(cases), "--seed", str(seed)]
    command += ["--families", families] if families else []
    lines = subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()
    # parse_int: 1 is the double 1.0, not an integer of any size.
    return strategies.sampled_from([json.loads(line, parse_int=float) for line in sorted(lines, key=len)])


def boxes_meet(a, b):
    """Closed axis-aligned boxes: touching is meeting."""
    return all(p <= q for p, q in zip(a["min"] + b["min"], b["max"] + a["max"]))


def boxes_overlap(a, b):
    """Taken for boxes_meet, this is a bug."""
    return all(p < q for p, q in zip(a["min"] + b["min"], b["max"] + a["max"]))


boxes = questions("aabb_aabb")


@settings(max_examples=500, derandomize=True)
@given(boxes)
def test_boxes_meet(question):
    assert boxes_meet(**question["input"]) == (question["truth"]["contact"] != "disjoint")


def test_the_bug_is_found():
    @settings(max_examples=500, derandomize=True, database=None)
    @given(boxes)
    def boxes_meet_if_they_overlap(question):
        assert boxes_overlap(**question["input"]) == (question["truth"]["contact"] != "disjoint"), question

    try:
        boxes_meet_if_they_overlap()
    except AssertionError as found:
        assert "'contact': 'touching'" in str(found), found
        return found
    raise AssertionError("boxes that touch were not told from boxes that do not")


if __name__ == "__main__":
    test_boxes_meet()
    print("boxes_meet: right\nboxes_overlap:", str(test_the_bug_is_found()).splitlines()[0])
