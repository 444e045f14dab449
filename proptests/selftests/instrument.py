#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Copies robust/ and plants bugs in the copy: instrument.py SOURCE_ROOT OUT

Each bug replaces one expression by (TOUCHSTONE_PLANTED(n) ? (bug) : (expression)), n its place in the list from 1; the
environment variable TOUCHSTONE_PLANTED=n turns one of them on when the program starts. An expression that is not found
exactly once stops the build: the list must follow the code."""
import collections
import pathlib
import sys

from planted import listed


def planted(text, place, bugs):
    """text with every bug of one expression in it; place names the file."""
    find, within = bugs[0][1]["find"], bugs[0][1].get("within", bugs[0][1]["find"])
    if text.count(within) != 1 or within.count(find) != 1:
        sys.exit(f"{place}: expected exactly once, found {text.count(within)} times: {within}")
    expression = f"({find})"
    for number, bug in reversed(bugs):
        expression = f"(TOUCHSTONE_PLANTED({number}) ? ({bug['plant']}) : {expression})"
    return text.replace(within, within.replace(find, expression))


def main(source, out):
    places = collections.defaultdict(list)
    for number, bug in listed():
        places[bug["file"], bug["find"], bug.get("within")].append((number, bug))
    texts = {path.relative_to(source).as_posix(): path.read_text()
             for path in sorted((source / "robust").rglob("*")) if path.suffix in (".h", ".cpp")}
    # Longer expressions first, so that one inside another is still found as it was.
    for (file, find, _), bugs in sorted(places.items(), key=lambda item: -len(item[0][1])):
        texts[file] = planted(texts[file], file, bugs)
    for file, text in texts.items():
        target = out / file
        target.parent.mkdir(parents=True, exist_ok=True)
        if not target.exists() or target.read_text() != text:
            target.write_text(text)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
