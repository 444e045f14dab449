#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The tables of bench/ratios.json, which bench/ratios.py --write fills, and what bench/README.md shows of them.

  bench/tables.py [NAME...]      prints tables of bench/ratios.json, by their first head up to a comma
  bench/tables.py --write        writes the part of bench/README.md between the marks
  bench/tables.py --check        checks that this part is what would be written
  bench/tables.py --self-check   checks that a number changed by hand is noticed"""
import argparse
import dataclasses
import json
import pathlib
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
DATA, README = FOLDER / "ratios.json", FOLDER / "README.md"
MARKS = "<!-- ratios -->\n", "<!-- end of ratios -->\n"
CASES, SHOWN = "cases", "random"  # of a table with this column the README shows these rows


@dataclasses.dataclass
class Table:
    head: list
    rows: list
    measured: str = ""

    @property
    def name(self):
        return self.head[0]

    def __bool__(self):
        return bool(self.rows)

    def __str__(self):
        """As Markdown; empty where nothing was timed."""
        if not self.rows:
            return ""
        widths = [max(len(row[i]) for row in [self.head, *self.rows]) for i in range(len(self.head))]
        line = lambda row: "| " + " | ".join(cell.ljust(width) for cell, width in zip(row, widths)) + " |"
        rule = "|" + "|".join("-" * (width + 2) for width in widths) + "|"
        return "\n".join([line(self.head), rule, *map(line, self.rows)])


def read(text):
    return [Table(**table) for table in json.loads(text)]


def written(tables):
    """With a row a line, so that a new run changes few lines."""
    texts = []
    for table in tables:
        rows = ",\n".join(f"  {json.dumps(row)}" for row in table.rows)
        measured, head = json.dumps(table.measured), json.dumps(table.head)
        texts.append(f'{{"measured": {measured},\n "head": {head},\n "rows": [\n{rows}]}}')
    return "[\n" + ",\n".join(texts) + "\n]\n"


def replaced(kept, new):
    """Tables of a new run take the place of those with the same name."""
    names = {table.name: table for table in kept} | {table.name: table for table in new if table}
    return list(names.values())


def shown(table):
    text = f"`{table.name}`: {table.measured}\n\n"
    if CASES not in table.head:
        return text + f"{table}\n"
    column = table.head.index(CASES)
    rows = [row for row in table.rows if row[column] == SHOWN]
    counted = f"These are the {len(rows)} rows of random cases, of {len(table.rows)} in all."
    return text + f"{Table(table.head, rows)}\n\n{counted}\n"


def readme_of(text, tables):
    before, _, rest = text.partition(MARKS[0])
    _, _, after = rest.partition(MARKS[1])
    return before + MARKS[0] + "\n" + "\n".join(map(shown, tables)) + "\n" + MARKS[1] + after


def keep(new, measured):
    """Writes tables of a run into the data and the README."""
    tables = replaced(read(DATA.read_text()), [Table(table.head, table.rows, measured) for table in new])
    DATA.write_text(written(tables))
    README.write_text(readme_of(README.read_text(), tables))


def self_check():
    rows = [["orientation", "random", "1.2"], ["orientation", "near", "7.5"]]
    tables = [Table(["decision", CASES, "ns"], rows, "here")]
    readme = readme_of("# B\n" + "".join(MARKS) + "end\n", tables)
    newer = [Table(["decision", CASES, "ns"], [["orientation", "random", "1.3"]], "there"), Table(["hulls"], [])]
    changed = readme.replace("1.2", "1.1")
    checks = {
        "the random row is shown": "| orientation | random | 1.2 |" in readme,
        "other rows are counted, not shown": "of 2 in all" in readme and "7.5" not in readme,
        "text around the marks stays": readme.startswith("# B\n") and readme.endswith("end\n"),
        "the data are read as they were written": read(written(tables)) == tables,
        "a page that holds is what would be written": readme_of(readme, tables) == readme,
        "a number changed by hand is noticed": readme_of(changed, tables) != changed,
        "a new run replaces a table, and an empty one replaces none": replaced(tables, newer) == newer[:1],
    }
    return [f"not so: {what}" for what, holds in checks.items() if not holds]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--self-check", action="store_true")
    options = parser.parse_args()
    if options.self_check:
        found = self_check()
    else:
        tables, readme = read(DATA.read_text()), README.read_text()
        found = []
        if options.write:
            README.write_text(readme_of(readme, tables))
        elif options.check:
            if readme != readme_of(readme, tables):
                found = ["bench/README.md: not what bench/tables.py --write makes"]
        else:
            names = [table.name.split(",")[0] for table in tables]
            for name in set(options.names) - set(names):
                parser.error(f"{name} is none of the tables {', '.join(names)}")
            chosen = [table for table in tables if not options.names or table.name.split(",")[0] in options.names]
            print("\n\n".join(f"{table.measured}\n\n{table}" for table in chosen))
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
