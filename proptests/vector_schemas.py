#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that the schemas beside the vectors let the vectors pass and refuse lines with one defect each: vector_schemas.py
VECTORS. It asks every outcome and every 50th line of each file: the checker takes milliseconds a line. Exit code 77
if there is no Python package jsonschema."""
import copy
import json
import pathlib
import sys

try:
    from jsonschema import Draft202012Validator
except ImportError:
    print("skipped: no Python package jsonschema")
    sys.exit(77)
if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(0)
EVERY = 50


def first_number(value, path=()):
    """The path of the first number in a value, at any depth."""
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return path
    pairs = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    return next((found for name, part in pairs if (found := first_number(part, (*path, name))) is not None), None)


def with_value(line, path, value):
    changed = copy.deepcopy(line)
    holder = changed
    for name in path[:-1]:
        holder = holder[name]
    holder[path[-1]] = value
    return changed


def without(line, name):
    return {key: value for key, value in line.items() if key != name}


def defects(line):
    """(what is wrong, the line with it)"""
    yield "another version", line | {"touchstone": 2}
    yield "another operation", line | {"op": "touch"}
    yield "another operation's id", line | {"id": "touch/0123456789"}
    yield "an id without number", line | {"id": line["op"] + "/one"}
    yield "an unknown family", line | {"family": "stranger"}
    yield "an unexpected field", line | {"comment": ""}
    yield "an unexpected field in the input", with_value(line, ("input", "comment"), 0)
    yield "a missing field in the input", line | {"input": without(line["input"], next(iter(line["input"])))}
    yield "an unknown flag", line | {"flags": ["stranger"]}
    yield "a duplicate flag", line | {"flags": ["touch", "touch"]}
    for name in ("touchstone", "id", "op", "family", "input", "flags"):
        yield f"no {name}", without(line, name)
    number = first_number(line["input"], ("input",))
    if number is not None:
        yield "text in place of a number", with_value(line, number, "one")
    if "refused" in line:
        yield "refused without a rule", line | {"refused": {"field": "a"}}
        yield "refused and answered", line | {"truth": {}}
        return
    if number is not None:
        yield "infinite input that is not refused", with_value(line, number, "inf")
    yield "a rounded answer of another kind", line | {"rounded": {"rel": "LEFT"}}
    yield "a truth of another kind", line | {"truth": {"rel": "LEFT"}}
    yield "a margin that is not a number", line | {"margin": "banana"}
    yield "a margin in decimals", line | {"margin": "0.5"}
    yield "an answer as typed of another kind", line | {"as_typed": "LEFT"}
    yield "a certificate without kind", line | {"certificate": without(line["certificate"], "kind")}
    yield "a fact that is not a list", with_value(line, ("certificate", "fact"), "1/2")
    yield "a fact in decimals", with_value(line, ("certificate", "fact"), ["0.5"])
    for name in ("truth", "rounded", "certificate"):
        yield f"no {name}", without(line, name)
    for name, value in line["truth"].items():
        if isinstance(value, str) and value[-1].isalpha():
            yield "an enumerator in capitals", with_value(line, ("truth", name), value.upper())


def outcome(line):
    """Its fields, and of its truth the words and which numbers there are."""
    truth = {name: value if isinstance(value, str) and value[-1:].isalpha() else type(value).__name__
             for name, value in line.get("truth", {}).items()}
    return json.dumps([sorted(line), truth])


def complaints(folder):
    names = [path.stem for path in sorted(folder.glob("*.jsonl"))]
    if len(names) < 50:
        yield f"{folder}: only {len(names)} files of vectors"
    for name in names:
        path = folder / f"schemas/{name}.json"
        schema = json.loads(path.read_text(encoding="utf-8"))
        Draft202012Validator.check_schema(schema)
        validator = Draft202012Validator(schema)
        seen = set()
        with open(folder / f"{name}.jsonl", encoding="utf-8") as file:
            for position, text in enumerate(file, 1):
                if position % EVERY != 1 and '"refused"' in text:
                    continue
                line = json.loads(text)
                new = outcome(line) not in seen
                seen.add(outcome(line))
                if not new and position % EVERY != 1:
                    continue
                for error in validator.iter_errors(line):
                    yield f"{name}: line {position}: {error.json_path}: {error.message[:200]}"
                if new:
                    yield from (f"{name}: line {position}: {what} passes" for what, changed in defects(line)
                                if validator.is_valid(changed))


def main(folder):
    found = list(complaints(pathlib.Path(folder)))
    print("\n".join(found) or "every vector that was asked passes, every defect is refused")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main(sys.argv[1])
