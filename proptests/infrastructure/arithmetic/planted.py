#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Bugs in a copy of arithmetic/, each of which the comparison with GMP and MPFR has to notice.

  planted.py write OUT       writes the copy, with all bugs in it; TOUCHSTONE_MUTANT=n turns the n-th on
  planted.py run PROGRAM     runs the comparison with each, and with none
"""
import collections
import json
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(ROOT / "proptests" / "mutation"))
from instrument import mutated  # noqa: E402

PERCENT, SECONDS = "6", 60


def write(out):
    places = collections.defaultdict(list)
    for number, bug in enumerate(BUGS, 1):
        places[bug["file"], bug["find"], bug.get("within")].append((number, bug))
    texts = {path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8")
             for path in sorted((ROOT / "arithmetic").rglob("*")) if path.suffix in (".h", ".cpp")}
    for (file, _, _), bugs in sorted(places.items(), key=lambda place: -len(place[0][1])):
        texts[file] = mutated(texts[file], file, bugs)
    for file, text in texts.items():
        target = out / file
        target.parent.mkdir(parents=True, exist_ok=True)
        if not target.exists() or target.read_text(encoding="utf-8") != text:
            target.write_text(text, encoding="utf-8")


def notices(program, number):
    """Returns whether a comparison with that bug, 0 for none, fails; it fails if it does not end."""
    try:
        return subprocess.run([program, PERCENT], env=os.environ | {"TOUCHSTONE_MUTANT": str(number)}, timeout=SECONDS,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode != 0
    except subprocess.TimeoutExpired:
        return True


def run(program):
    if notices(program, 0):
        return ["the comparison fails without a bug"]
    return [f"not noticed: {bug['file']}: {bug['what']}" for number, bug in enumerate(BUGS, 1) if not notices(program, number)]


BUGS = [json.loads(line) for line in (HERE / "planted.jsonl").read_text(encoding="utf-8").splitlines()]
if __name__ == "__main__":
    if sys.argv[1] == "write":
        sys.exit(write(pathlib.Path(sys.argv[2])))
    missed = run(sys.argv[2])
    print(*missed, f"{len(BUGS) - len(missed)} of {len(BUGS)} planted bugs noticed", sep="\n")
    sys.exit(1 if missed else 0)
