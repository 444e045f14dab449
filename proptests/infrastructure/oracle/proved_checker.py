#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks whether the proved checker gives the same verdicts as the two that are written by hand.

  proved_checker.py --program PATH [--work DIR]   builds certify_proved, and gives it and the others claims:
      all test vectors of operations with proved kinds, and their claims; and claims that are tampered with in one
      place, some of each kind: another word, another kind, other numbers of truth, certificate and input; and vectors
      with another double, word or field in `rounded`. The others do not look at that: fractions say what is right, and
      of sums of two numbers the processor.

Ends with 77 where Coq or OCaml is missing.
"""
import argparse
import collections
import copy
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
from fractions import Fraction

ROOT = pathlib.Path(__file__).resolve().parents[3]
CERTIFICATES = ROOT / "oracle/certificates"
PROVED = CERTIFICATES / "proved"
sys.dont_write_bytecode = True
sys.path[:0] = [str(CERTIFICATES), str(PROVED)]
import certify
import kinds
import rounded_in_fractions

WORD_FIELDS = ("side", "relation", "contact", "location", "state", "axis")
FROM_EACH_KIND = 4  # claims of a kind of one operation that are tampered with


def vectors_of(operation):
    with open(ROOT / f"vectors/{operation}.jsonl", encoding="utf-8") as file:
        return [json.loads(line) for line in file]


def claims_of(operation):
    return (CERTIFICATES / f"claims/{operation}.jsonl").read_text(encoding="utf-8").splitlines()


def key_of(claim):
    truth = claim["truth"]
    word = next((truth[name] for name in WORD_FIELDS if isinstance(truth.get(name), str)), "")
    return claim["op"], word, claim["certificate"]["kind"]


def places(value, path=()):
    """Paths of all numbers and words."""
    if isinstance(value, (list, dict)):
        for key in value if isinstance(value, dict) else range(len(value)):
            yield from places(value[key], path + (key,))
    else:
        yield path, value


def with_value(claim, path, value):
    claim = copy.deepcopy(claim)
    inner = claim
    for key in path[:-1]:
        inner = inner[key]
    inner[path[-1]] = value
    return claim


def other_exact(text):
    if "sqrt" in text:
        root = text.index("sqrt")
        found = {text[:root] + "sqrt(1" + text[root + 5:], "1" + text, text[1:], text.replace("/", "/1")}
        found.add(text.replace("+", "-"))
        return found | {text[0] + text[1:].replace("-", "+")}
    x = Fraction(text)
    return {str(x + 1), str(-x), str(x * (1 + Fraction(1, 2**60))), str(x + Fraction(1, 2**1100)), "0", "1"}


def tampered(claim, words):
    """Claims that differ in one place. Some of them are true: another line that separates, an input an ulp away."""
    for path, value in places(claim["truth"], ("truth",)):
        if path[-1] in WORD_FIELDS:
            for word in words - {value}:
                yield with_value(claim, path, word)
    for kind in words:
        yield with_value(claim, ("certificate", "kind"), kind)
    for part in ("truth", "certificate"):
        for path, value in places(claim[part], (part,)):
            if path[-1] in WORD_FIELDS or path[-1] == "kind" or not isinstance(value, str):
                continue
            for other in sorted(other_exact(value) - {value}):
                yield with_value(claim, path, other)
        for name in claim[part]:
            less = copy.deepcopy(claim)
            del less[part][name]
            yield less
        yield with_value(claim, (part, "more"), "1")
    for path, value in places(claim["input"], ("input",)):
        if isinstance(value, (int, float)):
            for other in (math.nextafter(value, math.inf), math.nextafter(value, -math.inf), -value, 0):
                if math.isfinite(other) and other != value:
                    yield with_value(claim, path, other)


def other_doubles(value):
    value = rounded_in_fractions.double(value)
    near = {math.nextafter(value, end) for end in (math.inf, -math.inf)}
    found = sorted((near | {-value, 0.0, value / 2, math.inf, -math.inf}) - {value})
    return [-0.0] + [other if math.isfinite(other) else "inf" if other > 0 else "-inf" for other in found]


def rounded_otherwise(claim, words):
    """Claims whose `rounded` differs in one place. Right are a zero of either sign, and a truth without numbers."""
    for path, value in places(claim["rounded"], ("rounded",)):
        word = isinstance(value, str) and value not in ("inf", "-inf")
        for other in sorted(words - {value})[::10] if word else other_doubles(value):
            yield with_value(claim, path, other)
        for other in (None, [], {}, "1", str(value), "nan", True):
            yield with_value(claim, path, other)
    for name in claim["rounded"]:
        less = copy.deepcopy(claim)
        del less["rounded"][name]
        yield less
    yield with_value(claim, ("rounded", "more"), 1)
    yield claim | {"rounded": claim["truth"]}
    yield claim | {"rounded": []}


# About halves of a unit, the least and the greatest numbers.
EDGES = (sys.float_info.max, 2.0**970, math.nextafter(2.0**970, 0), 2.0**969, 2.0**53 + 2, 2.0**53, 2.0**53 - 1, 1.5,
         1.0, 2.0**-53, 3 * 2.0**-54, 2.0**-54, 2.0**-1022, math.nextafter(2.0**-1022, 0), 5e-324)


def sums_of_two():
    """(claim, whether it is right): the momentum of two bodies, rounded as the processor adds, or beside that."""
    def written(x):
        return x if math.isfinite(x) else "inf" if x > 0 else "-inf"

    numbers = [sign * x for x in EDGES for sign in (1, -1)]
    for a in numbers:
        for b in numbers:
            total = a + b
            for other in sorted({total, *(math.nextafter(total, end) for end in (math.inf, -math.inf))}):
                bodies = [{"mass": 1, "velocity": [x, 0, 0]} for x in (a, b)]
                truth = {"momentum": [str(Fraction(a) + Fraction(b)), "0", "0"]}
                yield {"op": "momentum", "input": {"bodies": bodies}, "truth": truth, "certificate": {"kind": "sum"},
                       "rounded": {"momentum": [written(other), 0, 0]}}, other == total


def wrong_sums(work):
    claims = list(sums_of_two())
    with tempfile.NamedTemporaryFile("w", suffix=".jsonl", encoding="utf-8") as file:
        file.write("".join(json.dumps(claim) + "\n" for claim, _ in claims))
        file.flush()
        verdicts = proved_verdicts(work, file.name)
    if len(verdicts) != len(claims):
        yield f"{len(claims)} sums, but {len(verdicts)} verdicts"
    for (claim, right), verdict in zip(claims, verdicts):
        if verdict != ("accepted" if right else "refused"):
            yield f"a sum that is rounded {'right' if right else 'wrong'}: {verdict}: {json.dumps(claim)}"


def size(claim):
    text = json.dumps(claim)
    return "meshes/" in text, len(text)  # a file holds a large mesh


def chosen(operation, *fields):
    """The shortest claims of each kind, and the longest among short ones; with other fields of vectors too."""
    found = collections.defaultdict(list)
    for claim in vectors_of(operation):
        if "certificate" in claim:
            kept = ("op", "input", "truth", "certificate", *fields)
            found[key_of(claim)].append({name: claim[name] for name in kept})
    for claims in found.values():
        claims.sort(key=size)
        yield from claims[:FROM_EACH_KIND - 1] + claims[len(claims) // 2:][:1]


def by_hand(program, path):
    """The verdicts of certify.py, line by line, after a look at whether touchstone certify refuses the same lines; what
    they accept is refused if `rounded` is wrong."""
    path = pathlib.Path(path)
    lines = path.read_text(encoding="utf-8").splitlines()
    judged = [certify.judged(line, path.parent) for line in lines]
    run = subprocess.run([program, "certify", path], text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    refused = {int(number) for number in re.findall(r": line (\d+): ", run.stderr)}
    for number, (reason, _) in enumerate(judged, 1):
        if (reason is not None) != (number in refused):
            yield number, "the checkers written by hand disagree"
    for number, (reason, of_refused_input) in enumerate(judged, 1):
        if reason is None and of_refused_input:
            yield number, "no certificate"
        else:
            right = reason is None and rounded_in_fractions.is_rounded(json.loads(lines[number - 1]))
            yield number, "accepted" if right else "refused"


def proved_verdicts(work, path):
    run = subprocess.run([work / "certify_proved", "--verdicts", path], text=True, stdout=subprocess.PIPE)
    return run.stdout.splitlines()


def compare(program, work, lines):
    """(how often each verdict of the proved checker is given, which lines have different verdicts)"""
    count, wrong = collections.Counter(), []
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(ROOT / "vectors/meshes", pathlib.Path(folder, "meshes"))
        path = pathlib.Path(folder, "claims.jsonl")
        path.write_text("".join(line + "\n" for line in lines), encoding="utf-8")
        proved = proved_verdicts(work, path)
        if len(proved) != len(lines):
            return count, [f"{len(lines)} lines, but {len(proved)} verdicts"]
        for number, verdict in by_hand(program, path):
            mine = proved[number - 1]
            count[mine] += 1
            if mine != verdict and not mine.startswith("not proved: "):
                wrong.append(f"by hand {verdict}, proved {mine}: {lines[number - 1][:400]}")
    return count, wrong


def check(program, work):
    failed = kinds.build(work, 2)
    if failed:
        return failed
    wrong = []
    operations = kinds.operations(kinds.sources())
    words = {word for operation in operations for claim in vectors_of(operation) if "certificate" in claim
             for word in key_of(claim)[1:]} - {""}
    vectors, changed, rounded = collections.Counter(), collections.Counter(), collections.Counter()
    for operation in operations:
        every = vectors_of(operation)
        count, found = compare(program, work, [json.dumps(claim) for claim in every])
        vectors.update(count)
        wrong += found + [f"{operation}: a vector is refused"] * (count["refused"] > 0)
        if count["accepted"] == 0:
            wrong.append(f"{operation}: no vector is accepted")
        lines = [json.dumps(other) for claim in chosen(operation) for other in tampered(claim, words)]
        count, found = compare(program, work, lines + claims_of(operation))
        changed.update(count)
        wrong += found
        if count["refused"] < len(lines) // 4:
            wrong.append(f"{operation}: of {len(lines)} tampered claims only {count['refused']} are refused")
        if operation in rounded_in_fractions.BY_CONTRACT:
            continue
        lines = [json.dumps(other) for claim in chosen(operation, "rounded")
                 for other in rounded_otherwise(claim, words)]
        count, found = compare(program, work, lines)
        rounded.update(count)
        wrong += found
        if count["accepted"] > len(lines) // 4 or count["refused"] == 0:
            wrong.append(f"{operation}: of {len(lines)} vectors rounded otherwise {count['accepted']} are accepted")
    wrong += wrong_sums(work)
    for what, count in (("vectors", vectors), ("tampered and written claims", changed), ("rounded otherwise", rounded)):
        print(f"{what}: " + ", ".join(f"{n:,} {verdict}" for verdict, n in sorted(count.items())))
    return wrong


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--program")
    options.add_argument("--work", type=pathlib.Path, default=ROOT / "build/certify_proved")
    given = options.parse_args()
    if not kinds.installed():
        print(kinds.MISSING)
        return kinds.prove.SKIPPED
    given.work.parent.mkdir(parents=True, exist_ok=True)
    wrong = check(given.program, given.work)
    for line in wrong[:40]:
        print(line, file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
