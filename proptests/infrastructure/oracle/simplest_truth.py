#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A second truth: slower, shorter, in Python's fractions. The common part of two shapes is found by cutting the
interval of the first one's parameter with half-planes; margins follow from their definition.

usage: simplest_truth.py CLAIMS OPERATIONS
CLAIMS: one {"op", "input", "truth", "margin"} a line; every difference is printed. OPERATIONS: one {"name", "words"} a
line, what the catalogue has; each must have its second truth here, and each of its words must have been seen.

A chapter's truths stand in simplest_truth_CHAPTER.py, any file of such a name: a function truth_OPERATION takes the
input and returns (truth, margin), the margin None where it is not compared. WITHOUT there says of an operation why it
has none.
"""
import importlib
import json
import pathlib
import sys

if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(0)


def found():
    """({operation: its truth}, {operation without one: why})"""
    truths, without = {}, {}
    for path in sorted(pathlib.Path(__file__).resolve().parent.glob("simplest_truth_*.py")):
        chapter = importlib.import_module(path.stem)
        without |= getattr(chapter, "WITHOUT", {})
        for name, value in vars(chapter).items():
            if name.startswith("truth_"):
                truths[name.removeprefix("truth_")] = value
    return truths, without


def words_in(truth):
    """Every word of an answer, at any depth."""
    if isinstance(truth, dict):
        return set().union(*map(words_in, truth.values()))
    return {truth} if isinstance(truth, str) and truth.strip("-0123456789/") else set()


def unseen(operations, truths, without, seen):
    """Yields what is missing of the catalogue: operations without a truth here, and enumerators that no claim had."""
    for operation in operations:
        name = operation["name"]
        if name in without:
            continue
        if name not in truths:
            yield f"{name}: no second truth, and no reason why (truth_{name}, WITHOUT)"
        for word in operation["words"] or [""]:
            if (name, word) not in seen:
                yield f"{name}: no claim with the answer {word!r} was compared"


def main(path, listed):
    truths, without = found()
    seen, wrong = set(), 0
    with open(path, encoding="utf-8") as lines:
        for position, text in enumerate(lines, 1):
            claim = json.loads(text)
            if claim["op"] not in truths:
                continue
            truth, margin = truths[claim["op"]](claim["input"])
            seen |= {(claim["op"], word) for word in words_in(truth) or {""}}
            if truth != claim["truth"] or (margin is not None and str(margin) != claim["margin"]):
                wrong += 1
                print(f"{path}:{position}: {truth}, margin {margin}, instead of {text[:600]}")
    with open(listed, encoding="utf-8") as lines:
        missing = list(unseen([json.loads(line) for line in lines], truths, without, seen))
    print(*missing, sep="\n")
    return 1 if wrong or missing else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
