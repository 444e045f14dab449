#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""docs/deck.md, the map of the deck: each page with its title, its operations, from the catalogue, and its scenes.

  deck.py --program PATH --write    writes the page
  deck.py --program PATH            whether the page is what would be written
  deck.py --self-check              small catalogues, whose maps are known
"""
import argparse
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
INTRODUCTION = """# The deck, page by page

This map of the lecture deck *Collision handling: detection and response* lists for each page the operations whose formulas it has
([operations.md](operations.md)), and scenes that show it at work (`touchstone simulate`, [simulate.md](simulate.md)). The titles are
touchstone's; a page that is not listed asks no question of its own.

`./dev deck` writes the same as one living page, build/deck.html: the idea of each page, its formula, a figure to drag or to turn, the
case that breaks the formula, and a scene that plays. The page needs no network.

This page is written by `proptests/deck.py --program build/release/touchstone --write` from the catalogue, the scenes and
[report/pages/deck.json](../report/pages/deck.json); do not edit it.

| p. | title | operations | scenes |
|---|---|---|---|
"""
BESIDE = """
## Operations that are not in the deck

No page asks these; the pages named teach the parts of their formulas.

| operation | p. |
|---|---|
"""


def numbers(pages):
    """"22-23, 51" as a set."""
    found = set()
    for part in pages.split(","):
        first, _, last = part.strip().partition("-")
        found.update(range(int(first), int(last or first) + 1))
    return found


def header(operation):
    return f"reference/{operation['chapter']}/{operation['name']}.h"


def link(operation):
    return f"[`{operation['name']}`](../{header(operation)})"


def page_of(sections, asked, beside, scenes):
    rows = []
    for section in sections:
        pages = numbers(section["pages"])
        linked = ", ".join(link(o) for o in asked if pages & numbers(o["pages"]))
        shown = ", ".join(f"[{name}](../simulate/scenes/{name}.json)" for name, of in sorted(scenes.items()) if pages & set(of))
        rows.append(f"| {section['pages']} | {section['title']} | {linked} | {shown} |\n")
    return INTRODUCTION + "".join(rows) + BESIDE + "".join(f"| {link(o)} | {o['pages']} |\n" for o in beside)


def defects_of(sections, asked, scenes):
    """Checks that deck.json has each operation of the deck in a section of one of its pages, and scenes on theirs."""
    known = {o["name"]: numbers(o["pages"]) for o in asked}
    for section in sections:
        pages = numbers(section["pages"])
        for name in section["operations"]:
            if not pages & known.get(name, set()):
                yield f"report/pages/deck.json: p. {section['pages']}: {name} is no operation of that page"
        scene = section.get("scene")
        if scene is not None and not pages & set(scenes.get(scene, ())):
            yield f"report/pages/deck.json: p. {section['pages']}: {scene} is no scene of these pages"
    named = {name for section in sections for name in section["operations"]}
    yield from (f"report/pages/deck.json: {name} is in no section" for name in sorted(known.keys() - named))
    pages = [page for section in sections for page in sorted(numbers(section["pages"]))]
    if pages != sorted(set(pages)):
        yield "report/pages/deck.json: pages are not in order, or named twice"


def asked_and_beside(operations, root):
    """An implementation without a formula of its own has no header to lead to. The contract of an operation says whether the deck asks it."""
    there = [o for o in operations if (root / header(o)).is_file()]
    asked = [o for o in there if "Deck p. " in (root / header(o)).read_text(encoding="utf-8")]
    return asked, [o for o in there if o not in asked]


def self_check():
    meet, touch = ({"name": "meet", "chapter": "lines", "pages": "3-4, 74"}, {"name": "touch", "chapter": "planes", "pages": "4"})
    sections = [{"pages": "3", "title": "One", "operations": ["meet"]}, {"pages": "4-5", "title": "Two", "operations": [], "scene": "box"}]
    scenes = {"box": [74, 5], "ball": [5]}
    made = page_of(sections, [meet], [touch], scenes)
    ball, box = "[ball](../simulate/scenes/ball.json)", "[box](../simulate/scenes/box.json)"
    wanted = ["| 3 | One | [`meet`](../reference/lines/meet.h) |  |",
              f"| 4-5 | Two | [`meet`](../reference/lines/meet.h) | {ball}, {box} |", "| [`touch`](../reference/planes/touch.h) | 4 |"]
    wrong = [f"expected {line}" for line in wanted if line not in made.splitlines()]
    if numbers("2, 14-16") != {2, 14, 15, 16}:
        wrong.append("ranges of pages are not read")
    if found := list(defects_of(sections, [meet], scenes)):
        wrong.append(f"right sections: {found}")
    for planted, word in [([{**sections[0], "operations": []}, sections[1]], "meet is in no section"),
                          ([{**sections[0], "scene": "ball"}, sections[1]], "ball is no scene"),
                          ([sections[0], {**sections[1], "operations": ["touch"]}], "touch is no operation"),
                          (sections[::-1], "not in order")]:
        if not any(word in one for one in defects_of(planted, [meet], scenes)):
            wrong.append(f"not found: {word}")
    print(f"self-check: {len(wanted) + 6 - len(wrong)} of {len(wanted) + 6} as expected")
    return wrong


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--program", help="the built program; its `ops --json` is the catalogue")
    arguments.add_argument("--write", action="store_true")
    arguments.add_argument("--self-check", action="store_true")
    options = arguments.parse_args()
    if options.self_check:
        found = self_check()
    else:
        listing = subprocess.run([options.program, "ops", "--json"], check=True, capture_output=True, text=True).stdout
        scenes = {file.stem: json.loads(file.read_text(encoding="utf-8")).get("deck_pages", [])
                  for file in (ROOT / "simulate/scenes").glob("*.json")}
        sections = json.loads((ROOT / "report/pages/deck.json").read_text(encoding="utf-8"))
        asked, beside = asked_and_beside(json.loads(listing), ROOT)
        made, page = page_of(sections, asked, beside, scenes), ROOT / "docs/deck.md"
        if options.write:
            page.write_text(made, encoding="utf-8")
        held = page.read_text(encoding="utf-8") if page.is_file() else ""
        found = list(defects_of(sections, asked, scenes))
        found += [] if held == made else ["docs/deck.md: not what proptests/deck.py --write makes of catalogue and scenes"]
    for defect in found:
        print(defect)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
