#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that the folders of the library are floors: includes between folders run one way, no folder is crowded, and
docs/architecture.md says of every module what it sees.

  floors.py               the source tree around this file
  floors.py --self-check  small trees with one defect each: every one must be found
"""
import argparse
import collections
import graphlib
import pathlib
import re
import sys
import tempfile

from layout import INCLUDE, MODULES

ROOT = pathlib.Path(__file__).resolve().parent.parent
MOST_FILES = 30
# These have a file for every operation or every family of certificates, so they are as long as the catalogue is.
LISTS = {"robust/mixed", "oracle/mixed", "robust/volumes", "oracle/volumes", "robust/batch", "oracle/certificates"}


def library(root):
    for module in MODULES:
        if module not in ("proptests", "fuzz", "bench", "coverage", "engines", "examples"):
            yield from (path for path in sorted((root / module).rglob("*")) if path.suffix in (".h", ".cpp"))


def circles(root):
    below = collections.defaultdict(dict)
    for path in library(root):
        folder = path.parent.relative_to(root).as_posix()
        for _, included in INCLUDE.findall(path.read_text(encoding="utf-8")):
            other = pathlib.PurePosixPath(included).parent.as_posix()
            if other != folder and (root / included).exists():
                below[folder].setdefault(other, f"{path.relative_to(root).as_posix()} includes {included}")
    try:
        graphlib.TopologicalSorter(below).prepare()
    except graphlib.CycleError as found:
        folders = found.args[1]
        yield "folders in a circle: " + "; ".join(below[b][a] for a, b in zip(folders, folders[1:]))


def crowded(root):
    files = collections.Counter(path.parent.relative_to(root).as_posix() for path in library(root))
    for folder, count in sorted(files.items()):
        if count > MOST_FILES and folder not in LISTS:
            yield f"{folder}: {count} files, at most {MOST_FILES}"


def sees(module):
    allowed = MODULES[module]
    return "anything" if allowed is None else ", ".join(f"`{name}`" for name in sorted(allowed - {module})) or "nothing"


def untold(root):
    page = (root / "docs/architecture.md").read_text(encoding="utf-8")
    for module in MODULES:
        if not re.search(rf"^\| `{module}/` \|.*\| {sees(module)} \|$", page, re.MULTILINE):
            yield f"docs/architecture.md: no row says that {module}/ sees {sees(module)}"


def defects(root):
    yield from circles(root)
    yield from crowded(root)
    yield from untold(root)


def self_check():
    right = {"geometry/points.h": "", "robust/kernel/turn.h": '#include "geometry/points.h"\n',
             "robust/lines/side.cpp": '#include "robust/kernel/turn.h"\n',
             "docs/architecture.md": "".join(f"| `{module}/` | what | {sees(module)} |\n" for module in MODULES)}
    wrong = [({"robust/kernel/turn.h": '#include "robust/lines/side.cpp"\n'}, "folders in a circle"),
             ({f"geometry/{i}.h": "" for i in range(MOST_FILES)}, "geometry: 31 files"),
             ({"docs/architecture.md": right["docs/architecture.md"].replace("`fuzz/`", "")}, "no row says that fuzz/ sees"),
             ({"docs/architecture.md": right["docs/architecture.md"].replace("what | nothing", "what | `robust`", 1)}, "arithmetic/ sees nothing")]
    missed = 0
    for change, expected in [({}, None), *wrong]:
        with tempfile.TemporaryDirectory() as folder:
            for name, text in (right | change).items():
                path = pathlib.Path(folder, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            found = list(defects(pathlib.Path(folder)))
        if found if expected is None else not (len(found) == 1 and expected in found[0]):
            missed += 1
            print(f"expected {expected}, found {found}")
    print(f"self-check: {len(wrong) + 1 - missed} of {len(wrong) + 1} as expected")
    return 1 if missed else 0


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--self-check", action="store_true")
    if arguments.parse_args().self_check:
        return self_check()
    found = list(defects(ROOT))
    print(*found, sep="\n", end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
