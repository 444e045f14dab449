#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The findings in other people's libraries, docs/findings.jsonl and docs/audits.jsonl, and their page.

  findings.py --write                       writes what lies between the marks of docs/engines_audited.md
  findings.py --program PATH                checks that the data hold and that the page is what would be written
  findings.py --program PATH --self-check   checks that wrong data and a wrong page are noticed

An audit declares the finding's engine and operation. The program computes the same truth; an engine with the number
type, boundary and tolerance of that audit replays the answer, and the program judges it as `class`."""
import argparse
import json
import pathlib
import shlex
import subprocess
import sys
import tempfile

DOCS = pathlib.Path(__file__).resolve().parent.parent / "docs"
PAGE = DOCS / "engines_audited.md"
FIELDS = ["library", "version", "engine", "operation", "input", "truth", "answer", "class", "remark", "promise",
          "vendor"]
CLASSES = ("rounding", "algorithm", "inexact", "invalid")
LONGEST = 120  # characters of a truth in the page
MARKS = "<!-- made by proptests/findings.py -->\n", "<!-- end of what is made -->\n"


def parsed(text, **how):
    return [json.loads(line, **how) for line in text.splitlines()]


# The page.

def code(value):
    """A value as `touchstone ask` takes it, with its numbers as the file writes them."""
    if isinstance(value, dict):
        return "{" + ", ".join(f'"{key}": {code(member)}' for key, member in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(code, value)) + "]"
    return value.literal if isinstance(value, Number) else json.dumps(value)


class Number:
    def __init__(self, literal):
        self.literal = literal


def shortened(text):
    return text if len(text) <= LONGEST else text[:LONGEST] + "..."


def cell(text):
    return text.replace("|", "\\|")


def row(*cells):
    return "| " + " | ".join(map(cell, cells)) + " |\n"


def table(head, rows):
    return row(*head) + "|" + "---|" * len(head) + "\n" + "".join(row(*cells) for cells in rows)


def finding_rows(findings):
    for line in findings:
        yield [f"`{line['operation']}`", f"`{code(line['input'])}`", f"`{shortened(code(line['truth']))}`",
               f"`{code(line['answer'])}`", line["class"], line["remark"], line["promise"] or "none known",
               line["vendor"] or "not reported"]


def section(audits, findings):
    library, version = audits[0]["library"], audits[0]["version"]
    text = f"### {' '.join([library, version]).strip()}\n\n"
    if findings:
        columns = ["operation", "input", "truth", "answer", "class", "what goes wrong", "what is promised",
                   "vendor's answer"]
        text += table(columns, finding_rows(findings)) + "\n"
    several = len({audit["engine"] for audit in audits}) > 1
    remarks = [f"- {audit['engine'] + ': ' if several else ''}{remark}\n" for audit in audits
               for remark in audit["remarks"]]
    if remarks:
        text += "".join(remarks) + "\n"
    return text


def rates(audit):
    counts = (audit["counts"] or {}).get("all")
    if counts is None:
        return ["to be run again"] + [""] * 5
    classes = [counts.get(name, 0) for name in ("rounding", "algorithm", "invalid")]
    answers = sum(counts.values()) - counts["cases"] - counts.get("unsupported", 0)
    return [f"{number:,}" for number in [answers, sum(classes), *classes, counts.get("convention", 0)]]


def declared(audit):
    tolerance = f", tolerance {audit['tolerance']:g}" if audit["tolerance"] else ""
    return f"{audit['number']}, {audit['boundary']}{tolerance}"


def audit_rows(audits):
    for audit in audits:
        operations = ", ".join(audit["operations"])
        families = f"; families {', '.join(audit['families'])}" if audit["families"] else ""
        yield [audit["engine"], f"`{audit['wrapper']}`", declared(audit), f"{operations}{families}",
               f"{audit['cases']:,}", *rates(audit)]


def made(audits, findings):
    libraries = dict.fromkeys((audit["library"], audit["version"]) for audit in audits)
    found_in = len({line["library"] for line in findings})
    text = (f"## Findings by library\n\n{len(findings)} findings with an exact input, in {found_in} libraries. "
            "*Not reported*: this project has no record of a report to the vendor.\n\n")
    for key in libraries:
        of = lambda lines: [line for line in lines if (line["library"], line["version"]) == key]
        text += section(of(audits), of(findings))
    columns = ["engine", "wrapper", "numbers, boundary", "operations", "cases each", "answers", "wrong", "rounding",
               "algorithm", "invalid", "other convention"]
    return text + "## The audits\n\n" + table(columns, audit_rows(audits))


def page_of(page, audits, findings):
    """The page with the part between the marks made anew."""
    before, _, rest = page.partition(MARKS[0])
    _, _, after = rest.partition(MARKS[1])
    numbers = {"parse_int": Number, "parse_float": Number}
    return before + MARKS[0] + "\n" + made(parsed(audits), parsed(findings, **numbers)) + "\n" + MARKS[1] + after


# The data.

def audit_of(line, audits):
    return next((audit for audit in audits if all(audit[key] == line[key] for key in ("library", "version", "engine"))
                 and line["operation"] in audit["operations"]), None)


def declaration(audit, operation):
    return {"engine": audit["engine"], "ops": [operation],
            **{key: audit[key] for key in ("number", "boundary", "tolerance")}}


def malformed(line, audits):
    if [*line] != FIELDS:
        yield f"its fields are not {', '.join(FIELDS)}"
        return
    if not audit_of(line, audits):
        yield "audits.jsonl has no such library, version, engine and operation"
    if line["class"] not in CLASSES:
        yield f"{line['class']}: not a class of findings"


def untrue(lines, declared_engine, program):
    """(line, defect): what the program does not confirm, of one engine and operation."""
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump([declared_engine, *(line["answer"] for line in lines)], file)
        file.flush()
        replayed = shlex.join([sys.executable, __file__, "--replay", file.name])
        questions = "".join(json.dumps(line["input"]) + "\n" for line in lines)
        asked = subprocess.run([program, "ask", declared_engine["ops"][0], "--engine", replayed], input=questions,
                               text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    told = parsed(asked.stdout)
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
    declared_engine, *answers = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    sys.stdin.readline()
    print(json.dumps(declared_engine), flush=True)
    for answer, line in zip(answers, sys.stdin):
        error = isinstance(answer, dict) and "error" in answer
        print(json.dumps({"id": json.loads(line)["id"], **(answer if error else {"answer": answer})}), flush=True)


def inconsistent(audit):
    """Returns whether the counts of an audit differ from its last sentence."""
    answers, wrong = rates(audit)[:2]
    return audit["counts"] is not None and f" {wrong} of {answers} answers wrong " not in audit["printed"][-1]


def defects(findings, audits, page, program):
    """findings, audits, page: texts of the three files."""
    declared_audits, groups, readable = parsed(audits), {}, True
    for number, line in enumerate(parsed(findings), 1):
        found = list(malformed(line, declared_audits))
        yield from (f"findings.jsonl:{number}: {defect}" for defect in found)
        readable = readable and not found
        if not found:
            engine = declaration(audit_of(line, declared_audits), line["operation"])
            groups.setdefault(json.dumps(engine), []).append((number, line))
    for engine, numbered in groups.items():
        for line, defect in untrue([line for _, line in numbered], json.loads(engine), program):
            yield f"findings.jsonl:{next(n for n, same in numbered if same is line)}: {defect}"
    yield from (f"audits.jsonl: {audit['engine']}: counts and last sentence differ" for audit in declared_audits
                if inconsistent(audit))
    texts = findings.splitlines()
    if len(set(texts)) != len(texts) or not texts:
        yield "findings.jsonl: no line, or a duplicate line"
    if readable and page != page_of(page, audits, findings):
        yield "docs/engines_audited.md: not what proptests/findings.py --write makes of the data"


# The first finding that has the first text gets the second instead, and the defect that must be found.
WRONG = [
    ('"truth": {"side": "left"}', '"truth": {"side": "right"}', "the truth is"),
    ('"class": "algorithm"', '"class": "rounding"', "the class is algorithm"),
    ('"class": "invalid"', '"class": "convention"', "convention: not a class of findings"),
    ('"version": "1.0.3"', '"version": "1.0.4"', "audits.jsonl has no such"),
    ('"library": "GEOS"', '"library": "JTS"', "audits.jsonl has no such"),
    ('"operation": "ray_segment"', '"operation": "aabb_aabb"', "audits.jsonl has no such"),
    ('"answer": {"class": "proper", "normal"', '"answer": {"class": "proper", "norm"', "such answers are refused"),
    ('"promise": null', '"promised": null', "its fields are not"),
]


def self_check(findings, audits, page, program):
    for before, after, wanted in WRONG:
        right = next((text for text in findings.splitlines() if before in text), None)
        if right is None:
            yield f"no line has {before}"
            continue
        found = list(defects(right.replace(before, after, 1), audits, page, program))
        if not any(wanted in defect for defect in found):
            yield f"{after}: found {found}"
    first = findings.splitlines()[0]
    if not any("a duplicate line" in defect for defect in defects(f"{first}\n{first}\n", audits, page, program)):
        yield "a duplicate line was not found"
    miscounted = audits.replace('"agree": 3698', '"agree": 3699')
    if not any("differ" in defect for defect in defects(first, miscounted, page, program)):
        yield "counts that differ from the audit's last sentence were not found"
    reported = findings.replace('"vendor": null', '"vendor": "mended in 2.0"', 1)
    for changed in (page.replace("not reported", "reported", 1), page.replace(MARKS[1], "", 1)):
        if changed == page_of(changed, audits, findings):
            yield "a page that was edited by hand was not found"
    if "mended in 2.0" not in page_of(page, audits, reported):
        yield "the vendor's answer is not on the page"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--self-check", action="store_true")
    parser.add_argument("--replay", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.replay:
        replay(options.replay)
        return
    findings, audits, page = (path.read_text(encoding="utf-8")
                              for path in (DOCS / "findings.jsonl", DOCS / "audits.jsonl", PAGE))
    if options.write:
        PAGE.write_text(page_of(page, audits, findings), encoding="utf-8")
        return
    check = self_check if options.self_check else defects
    found = list(check(findings, audits, page, options.program.resolve()))
    right = "every wrong line is found" if options.self_check else f"the {len(findings.splitlines())} findings hold"
    print("\n".join(found) or right)
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
