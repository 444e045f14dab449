#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""docs/deck.md, the map of the deck: each page with its operations, from the catalogue, and its scenes, from their files.

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
FIRST, LAST = 3, 74
INTRODUCTION = """# The deck, page by page

What of the lecture deck *Collision handling: detection and response* is here: for each page the operations whose formulas it has
([operations.md](operations.md)), and scenes that show it at work (`touchstone simulate`, [simulate.md](simulate.md)). Pages that follow one
another with the same entries share a line; a line without entries is a page that asks no question of its own, or one that nothing answers yet.
Pictures: the report of `./dev audit` lists operations in the deck's order too, each with a right case and its failures drawn. A scene plays after
`touchstone simulate FILE --page runs.html` in any browser.
This page is written by `proptests/deck.py --program build/release/touchstone --write`; do not edit it.

| p. | operations | scenes |
|---|---|---|
"""


def numbers(pages):
    """"22-23, 51" as a set."""
    found = set()
    for part in pages.split(","):
        first, _, last = part.strip().partition("-")
        found.update(range(int(first), int(last or first) + 1))
    return found


def entries(page, operations, scenes):
    linked = [f"[`{o['name']}`](../reference/{o['chapter']}/{o['name']}.h)" for o in operations if page in numbers(o["pages"])]
    shown = [f"[{name}](../simulate/scenes/{name}.json)" for name, pages in sorted(scenes.items()) if page in pages]
    return ", ".join(linked), ", ".join(shown)


def page_of(operations, scenes):
    lines = []
    for page in range(FIRST, LAST + 1):
        here = entries(page, operations, scenes)
        if lines and lines[-1][2] == here:
            lines[-1] = (lines[-1][0], page, here)
        else:
            lines.append((page, page, here))
    rows = [f"| {first}{'' if first == last else f'-{last}'} | {found[0]} | {found[1]} |\n" for first, last, found in lines]
    return INTRODUCTION + "".join(rows)


def with_formula(operations, root):
    """An implementation without a formula of its own has no header to lead to."""
    return [o for o in operations if (root / f"reference/{o['chapter']}/{o['name']}.h").is_file()]


def self_check():
    operations = [{"name": "meet", "chapter": "lines", "pages": "3-4, 74"}, {"name": "touch", "chapter": "planes", "pages": "4"}]
    made = page_of(operations, {"box": [74, 5], "ball": [5]})
    meet, touch = "[`meet`](../reference/lines/meet.h)", "[`touch`](../reference/planes/touch.h)"
    ball, box = "[ball](../simulate/scenes/ball.json)", "[box](../simulate/scenes/box.json)"
    wanted = [f"| 3 | {meet} |  |", f"| 4 | {meet}, {touch} |  |", f"| 5 |  | {ball}, {box} |", "| 6-73 |  |  |",
              f"| 74 | {meet} | {box} |"]
    wrong = [f"expected {line}" for line in wanted if line not in made.splitlines()]
    if numbers("2, 14-16") != {2, 14, 15, 16}:
        wrong.append("ranges of pages are not read")
    print(f"self-check: {len(wanted) + 1 - len(wrong)} of {len(wanted) + 1} as expected")
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
        made, page = page_of(with_formula(json.loads(listing), ROOT), scenes), ROOT / "docs/deck.md"
        if options.write:
            page.write_text(made, encoding="utf-8")
        held = page.read_text(encoding="utf-8") if page.is_file() else ""
        found = [] if held == made else ["docs/deck.md: not what proptests/deck.py --write makes of catalogue and scenes"]
    for defect in found:
        print(defect)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
