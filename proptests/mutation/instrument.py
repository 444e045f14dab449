#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Copies robust/ with every mutant in the copy: instrument.py SOURCE_ROOT OUT

Each mutant replaces one expression by (TOUCHSTONE_MUTANT(n) ? (mutant) : (expression)), n its number from 1; the
environment variable TOUCHSTONE_MUTANT=n turns one of them on when the program starts. An expression that is not found
exactly once stops the build: the list must follow the code."""
import collections
import pathlib
import sys

from mutants import listed


def mutated(text, place, mutants):
    """text with every mutant of one expression in it; place names the file."""
    find, within = mutants[0][1]["find"], mutants[0][1].get("within", mutants[0][1]["find"])
    for part in [find] + [mutant["plant"] for _, mutant in mutants]:
        if any(part.count(a) != part.count(b) for a, b in ("()", "[]", "{}")) or ";" in part:
            sys.exit(f"{place}: a whole expression, not: {part}")
    if text.count(within) != 1 or within.count(find) != 1:
        sys.exit(f"{place}: expected exactly once, found {text.count(within)} times: {within}")
    expression = f"({find})"
    for number, mutant in reversed(mutants):
        expression = f"(TOUCHSTONE_MUTANT({number}) ? ({mutant['plant']}) : {expression})"
    return text.replace(within, within.replace(find, expression))


def main(source, out):
    places = collections.defaultdict(list)
    for number, mutant in dict(reversed(listed())).items():  # one for each number
        places[mutant["file"], mutant["find"], mutant.get("within")].append((number, mutant))
    texts = {path.relative_to(source).as_posix(): path.read_text()
             for path in sorted((source / "robust").rglob("*")) if path.suffix in (".h", ".cpp")}
    # Longer expressions first, so that one inside another is still found as it was.
    for (file, find, _), mutants in sorted(places.items(), key=lambda item: -len(item[0][1])):
        texts[file] = mutated(texts[file], file, mutants)
    for file, text in texts.items():
        target = out / file
        target.parent.mkdir(parents=True, exist_ok=True)
        if not target.exists() or target.read_text() != text:
            target.write_text(text)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
