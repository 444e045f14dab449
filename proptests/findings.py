#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whether docs/findings.jsonl holds: findings.py --program PATH; with --self-check, whether wrong lines are found.

Library and version head a table of the page, which has a row for the operation. The words of `says` and `promise` and
the numbers of the input are on the page, and `says` contains the answer. The program computes the same truth. An engine
with the number type, boundary and tolerance of that table replays the answer, and the program judges it as `class`."""
import argparse
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

DOCS = pathlib.Path(__file__).resolve().parent.parent / "docs"
FIELDS = ["page", "library", "version", "engine", "operation", "input", "truth", "answer", "class", "says", "promise"]
CLASSES = ("rounding", "algorithm", "inexact", "invalid")
TABLE = re.compile(r"^touchstone audit of (.*) \((binary\d+)\), boundary (\w+)(?:, tolerance ([\d.]+))?;.*\n"
                   r"((?:.*\n)*?)all ", re.MULTILINE)
# How the pages put an answer's enumerators.
WORDED = {
    "on": r"\bon\b",
    "right": r"\bright\b",
    "inside": r"\binside\b",
    "outside": r"\boutside\b",
    "boundary": r"\bboundary\b",
    "touching": r"\btouches\b|intersection is a line",
    "overlapping": r"common interior points",
    "point": r"\bmeet in\b",
    "overlap": r"share a line|a segment|in common",
    "hit": r"\bhit\b|\bt = 1\b",
    "never": r"\bnever\b|\bnot hit\b",
    "convex": r"\bis convex\b",
    "proper": r"tells three points apart",
    True: r"\bmeet\b",
    False: r"\bsays no\b",
}


def plain(text):
    """Without marks of emphasis and code, and without line ends."""
    return " ".join(re.sub(r"\*\*|`", "", text).split())


def literals(value, name=""):
    """What a page writes for the numbers of a shape: points as (x, y), what defines a plane without signs."""
    if isinstance(value, dict):
        for key, member in value.items():
            yield from literals(member, key)
    elif isinstance(value, list) and name != "normal" and not isinstance(value[0], (list, dict)):
        yield f"({', '.join(value)})"
    elif isinstance(value, list):
        for member in value:
            yield from literals(member, name)
    elif name in ("normal", "offset"):
        yield value.lstrip("-")
    else:
        yield value


def stands(literal, text):
    return re.search(rf"(?<![\d.\-]){re.escape(literal)}(?![\d]|\.\d)", text)


def table_of(line, page):
    """The engine's declaration, as the table of the page has it."""
    for engine, number, boundary, tolerance, table in TABLE.findall(page):
        if engine == line["engine"] and re.search(rf"^{line['operation']} ", table, re.MULTILINE):
            return {"engine": engine, "ops": [line["operation"]], "number": number, "boundary": boundary,
                    "tolerance": float(tolerance or 0)}
    return None


def says_answer(says, answer, written):
    """Corners and faces by index are not looked for: the pages describe them. Lists of bodies and of pairs stand as in
    JSON: [[0, 1]]."""
    if isinstance(answer, bool):
        return re.search(WORDED[answer], says)
    if "replies" in answer or "pairs" in answer:
        return all(json.dumps(found) in says for reply in answer.get("replies", [answer]) for found in reply.values())
    words = [answer[key] for key in ("relation", "side", "location", "contact", "class") if key in answer]
    numbers = {key: written[key] for key in ("t", "point", "overlap") if key in answer}
    return (all(re.search(WORDED.get(word, "(?!)"), says) for word in words)
            and all(stands(literal, says) for literal in literals(numbers)) and answer.get("error", "") in says)


def unstated(line, written, page):
    """What the page does not say. written: the line with its numbers as they are written."""
    if [*line] != FIELDS:
        yield f"its fields are not {', '.join(FIELDS)}"
        return
    named = re.match(rf"{re.escape(line['library'])} (.* )?{re.escape(line['version'])}( .*)?$", line["engine"])
    if not named or not table_of(line, page):
        yield f"{line['page']} has no table of this library, version and operation"
    text = plain(page)
    yield from (f"{line['page']} does not say: {line[field]}" for field in ("says", "promise")
                if line[field] is not None and line[field] not in text)
    # 0 and 1 of a plane x + y = 1.1 are not written.
    yield from (f"{line['page']} has no {literal}" for literal in literals(written["input"])
                if literal not in ("0", "1") and not stands(literal, text))
    if not says_answer(line["says"], line["answer"], written["answer"]):
        yield f"the answer is not what it says: {line['says']}"
    if line["class"] not in CLASSES:
        yield f"{line['class']}: no finding's class"


def untrue(lines, declaration, program):
    """(line, defect): what the program does not confirm, of one engine and operation."""
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump([declaration, *(line["answer"] for line in lines)], file)
        file.flush()
        replay = shlex.join([sys.executable, __file__, "--replay", file.name])
        questions = "".join(json.dumps(line["input"]) + "\n" for line in lines)
        asked = subprocess.run([program, "ask", declaration["ops"][0], "--engine", replay], input=questions, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    told = [json.loads(line) for line in asked.stdout.splitlines()]
    if len(told) != len(lines):
        yield lines[0], f"the program answers {len(told)} of {len(lines)} questions: {asked.stderr}"
    for line, exact in zip(lines, told):
        if line["truth"] != exact["truth"]:
            yield line, f"the truth is {json.dumps(exact['truth'])}"
        judged = exact["engine"]
        if judged.get("remark", "").startswith("answer"):
            yield line, f"such answers are refused: {judged['remark']}"
        if line["class"] != judged.get("cause", judged["verdict"]):
            yield line, f"the class is {judged.get('cause', judged['verdict'])}"


def replay(path):
    """An engine that gives the answers of a file in their order."""
    declaration, *answers = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    sys.stdin.readline()
    print(json.dumps(declaration), flush=True)
    for answer, line in zip(answers, sys.stdin):
        error = isinstance(answer, dict) and "error" in answer
        print(json.dumps({"id": json.loads(line)["id"], **(answer if error else {"answer": answer})}), flush=True)


def defects(texts, program):
    pages, groups = {}, {}
    for number, text in enumerate(texts, 1):
        line, written = json.loads(text), json.loads(text, parse_int=str, parse_float=str)
        page = pages.setdefault(line["page"], (DOCS / line["page"]).read_text(encoding="utf-8"))
        found = list(unstated(line, written, page))
        yield from (f"findings.jsonl:{number}: {defect}" for defect in found)
        if not found:
            groups.setdefault(json.dumps(table_of(line, page)), []).append((number, line))
    for declaration, numbered in groups.items():
        for line, defect in untrue([line for _, line in numbered], json.loads(declaration), program):
            yield f"findings.jsonl:{next(n for n, same in numbered if same is line)}: {defect}"
    if len(set(texts)) != len(texts) or not texts:
        yield "findings.jsonl: no line, or a line twice"


# The first line that has the first text gets the second instead, and what must be found.
WRONG = [
    ('"truth": {"side": "left"}', '"truth": {"side": "right"}', "the truth is"),
    ('"class": "algorithm"', '"class": "rounding"', "the class is algorithm"),
    ('"answer": {"side": "right"}', '"answer": {"side": "above"}', "the answer is not what it says"),
    ('"answer": {"relation": "hit", "t": 1}', '"answer": {"relation": "hit", "t": 0.75}', "the answer is not what it"),
    ('"class": "invalid"', '"class": "convention"', "convention: no finding's class"),
    ('"version": "1.0.3"', '"version": "1.0.4"', "has no table of this library"),
    ('"library": "GEOS"', '"library": "JTS"', "has no table of this library"),
    ('"operation": "ray_segment"', '"operation": "aabb_aabb"', "has no table of this library"),
    ("[1.0000000000000002, 0]", "[1.0000000000000004, 0]", "has no (1.0000000000000004, 0)"),
    ('"radius": 9', '"radius": 8.5', "has no 8.5"),
    ("it says right", "it says so, right", "does not say: "),
    ('"answer": {"class": "proper", "normal"', '"answer": {"class": "proper", "norm"', "such answers are refused"),
    ("which is promised as 0", "which is promised as 1", "does not say: "),
    ('"promise": null', '"promised": null', "its fields are not"),
]


def self_check(texts, program):
    for before, after, wanted in WRONG:
        right = next((text for text in texts if before in text), None)
        if right is None:
            yield f"no line has {before}"
            continue
        found = list(defects([right.replace(before, after, 1)], program))
        if not any(wanted in defect for defect in found):
            yield f"{after}: found {found}"
    if not any("a line twice" in defect for defect in defects(texts[:1] * 2, program)):
        yield "a line twice was not found"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=pathlib.Path)
    parser.add_argument("--self-check", action="store_true")
    parser.add_argument("--replay", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.replay:
        replay(options.replay)
        return
    texts = (DOCS / "findings.jsonl").read_text(encoding="utf-8").splitlines()
    check = self_check if options.self_check else defects
    found = list(check(texts, options.program.resolve()))
    right = "every wrong line is found" if options.self_check else f"the {len(texts)} findings hold"
    print("\n".join(found) or right)
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
