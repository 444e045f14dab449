#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks certificates of geometric answers with fractions alone.

usage: certify.py [FILE...]    (standard input without a FILE, or where FILE is -)

Each line is one claim, {"op":..,"input":{..},"truth":{..},"certificate":{"kind":..,facts}}; other keys are ignored.
An input field "meshes/NAME.json" stands for the value in that file, in the folder of FILE.
A test vector of a refused input, {"op":..,"input":{..},"refused":{"field":..,"rule":..}}, has to break that rule first.
Prints every refused line with its reason and then "N certificates, M refused". Exit code: 0 all hold, 1 some refused,
2 a file cannot be read, or holds nothing. The same checks as the files check_*.cpp beside it, and the same reasons.
"""

import importlib
import io
import json
import os
import pathlib
import pkgutil
import re
import signal
import sys

from certify_reading import Claim, Refusal, expect, only

if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(0)

# Every function check_OPERATION of a file certify_*.py beside this one, in a folder or in an archive.
CHECKS = {
    name.removeprefix("check_"): check
    for module in pkgutil.iter_modules([str(pathlib.Path(__file__).resolve().parent)])
    if module.name.startswith("certify_")
    for name, check in vars(importlib.import_module(module.name)).items()
    if name.startswith("check_")
}


# A claim is nested five deep. What is nested without end may end a program that walks it.
MOST_NESTED = 64
STRING_OR_BRACKET = re.compile(r'"[^"\\]*(?:\\.[^"\\]*)*"?|[][{}]', re.DOTALL)


def nested_too_deep(text):
    depth = 0
    for found in STRING_OR_BRACKET.finditer(text):
        depth += {"[": 1, "{": 1, "]": -1, "}": -1}.get(found.group()[0], 0)
        if depth > MOST_NESTED:
            return True
    return False


def decimal(text):
    value = float(text)
    if value - value != 0:
        raise ValueError(text)  # beyond the greatest double
    return value


def whole(text):
    """An integer where 64 bits hold it, as in most parsers of JSON; so a long one takes no longer than another number."""
    value = int(text) if len(text) <= 20 and text != "-0" else None
    return value if value is not None and -(2**63) <= value < 2**64 else decimal(text)


def no_constant(name):
    raise ValueError(name)


def once(pairs):
    """An object; one text, one meaning: a key given twice is no JSON, nor half of a surrogate pair."""
    json.dumps(pairs, ensure_ascii=False).encode()
    if len(dict(pairs)) < len(pairs):
        raise ValueError(pairs)
    return dict(pairs)


def parsed(text):
    """Raises ValueError where the text is not JSON."""
    text.encode()  # bytes that are no UTF-8 were read as halves of surrogate pairs
    value = json.loads(text, parse_constant=no_constant, parse_float=decimal, parse_int=whole, object_pairs_hook=once)
    json.dumps(value, ensure_ascii=False).encode()
    return value


def expect_fields(line, names):
    expect(isinstance(line, dict), "claim: an object")
    for name in names:
        expect(name in line, f"claim: field {name} is missing")


def check_of(line):
    expect(isinstance(line["op"], str), "op: a string")
    expect(line["op"] in CHECKS, "op: not an operation with certificates")
    return CHECKS[line["op"]]


def refuses_input(line):
    return isinstance(line, dict) and "refused" in line and "truth" not in line and "certificate" not in line


def expect_refused(line):
    """As in check.cpp: a check reads the input before anything else, and complains about the first rule it breaks."""
    expect_fields(line, ["op", "input"])
    refused, given = line["refused"], line["input"]
    only(refused, "refused", ["field", "rule"])
    field, rule = refused["field"], refused["rule"]
    expect(isinstance(field, str) and isinstance(rule, str), "refused: field and rule are strings")
    check, broken = check_of(line), None
    try:
        check(Claim({"input": given, "truth": None, "certificate": None}))
    except Refusal as refusal:
        broken = str(refusal)
    of_input = isinstance(given, dict) and re.split(r"[.[]", field)[0] in given
    expect(of_input and broken == f"{field}: {rule}", "refused: this is not the first rule that the input breaks")


NAMED_FILE = re.compile(r"meshes/[a-z0-9_]+\.json")
FIELD = re.compile(r"[a-z0-9_]+")


def read_named_files(line, folder):
    """Puts the values of files in the places where the input names them, as named_file.cpp does."""
    given = line.get("input") if isinstance(line, dict) else None
    for field, name in sorted(given.items()) if isinstance(given, dict) else ():
        if not (isinstance(name, str) and name.endswith(".json") and FIELD.fullmatch(field)):
            continue
        named = NAMED_FILE.fullmatch(name) is not None
        expect(named, f"{field}: a file meshes/NAME.json, NAME of small letters, digits and _")
        path = pathlib.Path(folder, name)
        try:
            text = path.read_bytes().decode("utf-8", "surrogateescape") if path.is_file() else None
        except OSError:
            text = None
        expect(text is not None, f"{field}: {name}: a file that can be read")
        inside = path.resolve().is_relative_to(pathlib.Path(folder).resolve())
        expect(inside, f"{field}: {name}: a file in the folder of the claims, no link out of it")
        try:
            given[field] = parsed(text) if not nested_too_deep(text) else no_constant(name)
        except ValueError:
            raise Refusal(f"{field}: {name}: JSON, nested at most {MOST_NESTED} deep") from None


def refuse(text, folder="."):
    """Why the claim in one line of text is not accepted, or None. `folder` is that of the file in which it stands."""
    return judged(text, folder)[0]


def judged(text, folder="."):
    """(why the line is not accepted or None, whether it is a test vector of an input that is refused)"""
    if nested_too_deep(text):
        return f"claim: nested at most {MOST_NESTED} deep", False
    try:
        line = parsed(text)
    except ValueError:
        return "not JSON", False
    try:
        read_named_files(line, folder)
        if refuses_input(line):
            expect_refused(line)
        else:
            expect_fields(line, ["op", "input", "truth", "certificate"])
            expect(not isinstance(line.get("refused"), dict), "claim: a truth or refused, not both")
            check_of(line)(Claim(line))
    except Refusal as refusal:
        return str(refusal), refuses_input(line)
    return None, refuses_input(line)


def opened(path):
    if path != "-":
        return open(path, "rb")
    return sys.stdin.buffer if sys.stdin is not None else io.BytesIO()


def main(paths):
    total = refused = without = filled = 0
    for path in paths or ["-"]:
        try:
            stream = opened(path)
        except OSError as error:
            print(f"{path}: {error.strerror}", file=sys.stderr)
            return 2
        folder = "." if path == "-" else pathlib.Path(path).parent
        with stream:
            for position, raw in enumerate(stream, 1):
                if not raw.strip(b" \t\r\n"):
                    continue
                filled += 1
                reason, of_refused_input = judged(raw.removesuffix(b"\n").decode("utf-8", "surrogateescape"), folder)
                if reason is None and of_refused_input:
                    without += 1
                    continue
                total += 1
                if reason is not None:
                    refused += 1
                    print(f"{path}:{position}: {reason}")
    counted = f"; {without} refused inputs, which have none" if without else ""
    print(f"{total} certificates, {refused} refused{counted}")
    if filled == 0:
        print("line: one JSON object, found an empty file", file=sys.stderr)
        return 2
    return 1 if refused else 0


if __name__ == "__main__":
    if hasattr(signal, "SIGPIPE"):
        signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # who reads no further ends it, without a word
    try:
        code = main(sys.argv[1:])
        sys.stdout.flush()
    except (AttributeError, OSError):  # there is no standard output, or it takes nothing
        print("standard output: a stream that can be written", file=sys.stderr)
        os._exit(2)
    sys.exit(code)
