#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whether no source uses an identifier that the vocabulary has replaced (CONTRIBUTING.md).

  words.py               the source tree around this file
  words.py --self-check  small files with one such identifier each: every one must be found
"""
import argparse
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ("audit", "bench", "c", "catalogue", "cmake", "coverage", "docs", "engines", "examples", "fuzz", "geometry",
           "oracle", "program", "proptests", "python", "reference", "report", "robust", "simulate", "testing")
SUFFIXES = {".h", ".cpp", ".py", ".js", ".mjs", ".cmake", ".md"}
# What was replaced, as a pattern of the whole identifier, and what stands for it.
REPLACED = {
    r"Card": "Metadata",
    r"Tape": "EncodedValue",
    r"Choices": "DrawStream",
    r"doubtful": "inconclusive",
    r"looked_at": "reviewed",
    r"as_drawn": "unscaled",
    r"world_count": "domain_count",
    r"world_at": "domain_at",
    r"wired": "connected",
    r"fault(?=\s*[=(])": "the hook defect",
    # as a part of a longer identifier
    r"\w+Tape\w*|Tape\w+|tape_\w*|\w+_tape\w*": "encoded (EncodedValue, encoded_with)",
    r"\w+Choices\w*|Choices\w+|choices_\w*|\w+_choices\w*": "draws (DrawStream, case_draws)",
    r"faults?_\w+|\w+_faults?_?": "defect (defects_of_header)",
}
PATTERN = re.compile("|".join(rf"(?P<w{i}>\b(?:{old})\b)" for i, old in enumerate(REPLACED)))


def complaints(name, text):
    for number, line in enumerate(text.splitlines(), 1):
        for found in PATTERN.finditer(line):
            new = list(REPLACED.values())[int(found.lastgroup[1:])]
            yield f"{name}:{number}: {found.group()}: the word is {new}"


def sources():
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix in SUFFIXES and path.is_file() and path != pathlib.Path(__file__).resolve():
                yield path
    yield from sorted(ROOT.glob("*.md"))


def found_in_tree():
    for path in sources():
        if path.name != "CHANGELOG.md":  # it tells what was called how
            yield from complaints(path.relative_to(ROOT), path.read_text(encoding="utf-8"))


PLANTED = ("const Card& card();", "using Tape = int;", "Choices& c", "if (doubtful) return;", "looked_at = true;",
           "/*as_drawn=*/true", "world_count(4)", "world_at(4, 2)", "wired(question)", "return {.fault = fault};",
           "static std::string fault(const Question&);", "const TrueTape& truth", "Once<TapeOfAnswer> open_;",
           "walk_tape(shape, at, visit);", "tape_.words[0]", "case_choices(operation, 0, 1, 0)", "choices_.below(4)",
           "using AllChoices = int;", "last_fault_ = defect;", "def faults_of_header(text):", "planted_faults(row)")
INNOCENT = ("signal 11 (Segmentation fault)", "DiscardCards", "a fault of the engine", "const Metadata& metadata();",
            "ways_wired_up", "by_default(4)", "setdefault(key)", "default_tag", "a tape of paper", "its choices",
            "encoded_.words[0]")


def self_check():
    wrong = [f"not found: {line}" for line in PLANTED if not list(complaints("planted.h", line))]
    wrong += [f"wrongly found: {line}" for line in INNOCENT if list(complaints("innocent.h", line))]
    if len(list(sources())) < 500:
        wrong.append("the tree's sources are not read")
    checks = len(PLANTED) + len(INNOCENT) + 1
    print(f"self-check: {checks - len(wrong)} of {checks} as expected")
    return wrong


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--self-check", action="store_true")
    found = self_check() if arguments.parse_args().self_check else list(found_in_tree())
    for complaint in found:
        print(complaint)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
