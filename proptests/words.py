#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the words of the tree (CONTRIBUTING.md).

  words.py               the source tree around this file
  words.py --self-check  small files with one wrong word or sentence each: every one must be found

No source uses an identifier that the vocabulary has replaced. In pages, in docstrings of Python and in comments of C++
no sentence begins with Of, Whether or What, unless it asks, nor with Where unless a main clause follows a comma. Pages
and comments use the field's terms."""
import argparse
import ast
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ("arithmetic", "audit", "bench", "c", "catalogue", "cmake", "coverage", "docs", "engines", "examples", "fuzz",
           "geometry", "js", "oracle", "program", "proptests", "python", "reference", "report", "robust", "simulate", "testing")
SUFFIXES = {".h", ".cpp", ".py", ".js", ".mjs", ".cmake", ".md"}
# Replaced identifiers, as patterns of the whole identifier, and their replacements.
REPLACED = {
    r"Card": "Metadata",
    r"Whole[A-Z]\w+": "Integer (IntegerVector)",
    r"whole_(?:vector|points?|segment|list|bodies|normal|step|bits|root)(?!\.)|\w+_whole_(?:length|range)": "integer, full",
    r"WayCount|WayOfOperation|most_ways|by_way|ways_of_cell": "outcome (OutcomeCount)",
    r"\w*(?:squared|shortest|draw|zero)_way\w*": "displacement, distance",
    r"told_\w+|\w+_told_?": "reported, shown",
    r"SeenPolygon|seen_along": "projected (ProjectedPolygon)",
    r"(?:Quotient)?BesideTie|beside_tie|quotient_beside_tie": "near (NearTie, near_tie)",
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
# Phrases in pages, and the field's terms for them.
PHRASES = {
    r"whole numbers?": "integers",
    r"(?:is|are) told(?! to)": "reported, named",
    r"there twice": "duplicate",
}
# The same in comments of C++; names in backquotes and of files do not count.
COMMENT_PHRASES = {
    r"(?i:no one|nobody|whoever|who)(?! is to blame)": "the caller, the engine, the reader",
    r"whole (?:number|ring|mesh|answer|way)s?|as a whole": "integer, entire, full",
    r"beside(?!\.h)": "next to, near, in addition to",
    r"(?:is|are|be|was) told|unless told|told apart": "reported, known, decided, distinguished",
    r"looked at|looks at|look at": "tested, examined",
    r"the other way (?:a?round|about)|on (?:its|the) way|both ways": "reversed, meanwhile, in both directions",
    r"(?:is|was) seen(?= to| in| that)|not seen": "found, noticed",
    r"hangs? together": "is connected",
    r"takes? for granted": "assumes",
    r"coarsest grain": "largest power of two",
    r"for ever": "without limit",
}
# Comments are held to this in the folders whose comments have been rewritten.
COMMENTED = ("arithmetic", "audit", "bench", "c", "catalogue", "fuzz", "geometry", "oracle", "program", "python", "reference",
             "report", "robust", "simulate", "testing")


def any_of(phrases):
    return re.compile("|".join(rf"(?P<p{i}>\b(?:{old})\b)" for i, old in enumerate(phrases)))


PHRASE, COMMENT_PHRASE = any_of(PHRASES), any_of(COMMENT_PHRASES)
# The start of a sentence: of a page, a paragraph, an item, a cell, or after the end of another.
START = r"(?:\A|(?<=\n\n)|(?<=[.!?;] )|(?<=\.\n)|(?<=\.\n  )|(?<=\n- )|(?<=\n\* )|(?<=\| ))"
FRAGMENT = re.compile(START + r"(Of|Whether|What|Where|So many|How many)\b([^|]*?)(\?|[.;!](?=\s|\Z)|\n\n|\||\Z)")
# The first tells what was called how; the program prints the second; the third has titles in cells.
MADE = {"CHANGELOG.md", "docs/operations.md", "docs/deck.md"}
PATTERN = re.compile("|".join(rf"(?P<w{i}>\b(?:{old})\b)" for i, old in enumerate(REPLACED)))


def complaints(name, text):
    for number, line in enumerate(text.splitlines(), 1):
        for found in PATTERN.finditer(line):
            new = list(REPLACED.values())[int(found.lastgroup[1:])]
            yield f"{name}:{number}: {found.group()}: the word is {new}"


def prose(page):
    """Without code and headings; lines stay where they are."""
    lines = lambda found: "\n" * found.group().count("\n")
    without_code = re.sub(r"```.*?```|^ *<!--.*?-->", lines, page, flags=re.DOTALL | re.MULTILINE)
    return re.sub(r"^#.*$", "", without_code, flags=re.MULTILINE)


def fragments(name, text, first=1):
    """Sentences without a main clause. first: the line of the text's beginning."""
    for found in FRAGMENT.finditer(text):
        word, rest, end = found.groups()
        if end != "?" and not (word == "Where" and "," in rest):
            line = first + text.count("\n", 0, found.start())
            yield f"{name}:{line}: {' '.join((word + rest).split())[:50]}: the sentence begins with {word}"


def phrases(name, text, first=1, pattern=PHRASE, terms=tuple(PHRASES.values())):
    """Other words than the field's. first: the line of the text's beginning."""
    for found in pattern.finditer(text):
        line = first + text.count("\n", 0, found.start())
        yield f"{name}:{line}: {found.group()}: the word is {terms[int(found.lastgroup[1:])]}"


def comments(text):
    """Pairs of a line and the comment that begins there, without its slashes: alone on its lines, or behind code."""
    block, first = [], 0
    for number, line in enumerate([*text.splitlines(), ""], 1):
        code, slashes, comment = line.partition("//")
        if slashes and not code.strip():
            first = first if block else number
            block.append(comment.lstrip("/<").removeprefix(" "))
            continue
        if block:
            yield first, "\n".join(block)
            block = []
        if slashes and code.count('"') % 2 == 0:
            yield number, comment.lstrip("/< ")


def docstrings(text):
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.FunctionDef, ast.ClassDef)) and ast.get_docstring(node):
            yield node.body[0].lineno, ast.get_docstring(node)


def unclear(name, text):
    """The sentences of a page, of a script's docstrings, or of the comments of C++."""
    if name.endswith(".md") and name not in MADE:
        yield from fragments(name, prose(text))
        yield from phrases(name, re.sub(r"`[^`\n]*`", "", prose(text)))
    elif name.endswith(".py"):
        for line, docstring in docstrings(text):
            yield from fragments(name, docstring, line)
    elif name.startswith(tuple(f"{folder}/" for folder in COMMENTED)) and name.endswith((".h", ".cpp")):
        for line, comment in comments(text):
            yield from fragments(name, comment, line)
            yield from phrases(name, re.sub(r"`[^`\n]*`|\"[^\"\n]*\"", "", comment), line, COMMENT_PHRASE,
                               tuple(COMMENT_PHRASES.values()))


def sources():
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix in SUFFIXES and path.is_file() and path != pathlib.Path(__file__).resolve():
                yield path
    yield from sorted(ROOT.glob("*.md"))


def found_in_tree():
    for path in sources():
        if path.name not in MADE:
            yield from complaints(path.relative_to(ROOT), path.read_text(encoding="utf-8"))
        yield from unclear(path.relative_to(ROOT).as_posix(), path.read_text(encoding="utf-8"))


PLANTED = ("const Card& card();", "using Tape = int;", "Choices& c", "if (doubtful) return;", "looked_at = true;",
           "/*as_drawn=*/true", "world_count(4)", "world_at(4, 2)", "wired(question)", "return {.fault = fault};",
           "static std::string fault(const Question&);", "const TrueTape& truth", "Once<TapeOfAnswer> open_;",
           "walk_tape(shape, at, visit);", "tape_.words[0]", "case_choices(operation, 0, 1, 0)", "choices_.below(4)",
           "using AllChoices = int;", "last_fault_ = defect;", "def faults_of_header(text):", "planted_faults(row)")
INNOCENT = ("signal 11 (Segmentation fault)", "DiscardCards", "a fault of the engine", "const Metadata& metadata();",
            "ways_wired_up", "by_default(4)", "setdefault(key)", "default_tag", "a tape of paper", "its choices",
            "encoded_.words[0]")


UNCLEAR = {
    "a.md": ("Of polygons it has none.", "It ends. Whether it holds is tested.", "\n- What is refused: a ring.",
             "| field | What it is. |",
             "\n\nWhere two rings meet.\n\n", "The coordinates are whole numbers.", "The first one is told."),
    "robust/a.h": ("/// Whether it holds.", "  // Of the plane.", "/// A part.\n/// What is left.",
                   "x = 1;  ///< Where it is.", 'f("a");  // Of it', "/// It is told.", "// nobody asks",
                   "x;  // beside it", "/// A whole number."),
    "a.py": ('"""Whether it holds."""', 'def f():\n    """Of the plane."""', 'def f():\n    """A part. What is left."""'),
}
CLEAR = {
    "a.md": ("What is an orientation?", "Where rings meet, they touch.", "## What it promises",
             "`Of course`, it says what it is.",
             "```\nOf code nothing is said.\n```"),
    "robust/a.h": ("/// True if it holds.", "f(\"// Of it\");", "/// Where rings meet, they touch.",
                   "/// `beside` and beside.h.", "int told;", "/// What is it?", "x; // as seen from outside"),
    "examples/a.h": ("/// Whether it holds.",),
    "a.py": ('"""Returns whether it holds."""', "# Whether", "x = 'Of strings'"),
    "CHANGELOG.md": ("Of whole numbers.",),
}


def self_check():
    wrong = [f"not found: {text}" for name, texts in UNCLEAR.items() for text in texts if not list(unclear(name, text))]
    wrong += [f"wrongly found: {text}" for name, texts in CLEAR.items() for text in texts if list(unclear(name, text))]
    wrong += [f"not found: {line}" for line in PLANTED if not list(complaints("planted.h", line))]
    wrong += [f"wrongly found: {line}" for line in INNOCENT if list(complaints("innocent.h", line))]
    if len(list(sources())) < 500:
        wrong.append("the tree's sources are not read")
    checks = len(PLANTED) + len(INNOCENT) + 1 + sum(map(len, [*UNCLEAR.values(), *CLEAR.values()]))
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
