#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Names the ratios of a run that are worse than those of bench/ratios.json by more than 15 %: bench/ratios.py --guard.

  bench/guard.py --self-check    checks that a worse ratio is named, and no other

Only ratios are compared, columns with a slash in their head: nanoseconds differ from processor to processor. A ratio to
one of ours ("Epick / robust") is worse where it is smaller, any other ("robust / naive") where it is larger."""
import sys

import tables

WORSE = 1.15
OURS = {"robust", "AVX2", "AVX-512"}


def better_where_larger(head):
    return head.rpartition("/")[2].strip() in OURS


def key(table, row):
    """The cells that name a row: the first, and the cases where there are such."""
    return tuple(cell for head, cell in zip(table.head, row) if head in (table.name, tables.CASES))


def number(cell):
    try:
        return float(cell)
    except ValueError:  # not timed, "no hull", "not here"
        return None


def worse(kept, new):
    """([(row and column in words, before, now, how many times as bad)], the worst first; the count of compared ratios)"""
    found, compared = [], 0
    before = {table.name: table for table in kept}
    for table in filter(None, new):
        old = before.get(table.name)
        rows = {key(old, row): dict(zip(old.head, row)) for row in old.rows} if old else {}
        for row in table.rows:
            old_row = rows.get(key(table, row), {})
            for head, cell in zip(table.head, row):
                then, now = number(old_row.get(head, "")), number(cell)
                if "/" not in head or not then or not now:
                    continue
                compared += 1
                factor = then / now if better_where_larger(head) else now / then
                if factor > WORSE:
                    found.append((", ".join([*key(table, row), head]), then, now, factor))
    return sorted(found, key=lambda one: -one[-1]), compared


def said(kept, new):
    """(lines in words, one for each worse ratio and one that counts; whether the guard fails)"""
    found, compared = worse(kept, new)
    lines = [f"worse: {what}: {now:g} after {then:g}, {factor:.2f} times as bad" for what, then, now, factor in found]
    return [*lines, f"{len(found)} of {compared} ratios are worse by more than {WORSE - 1:.0%}"], bool(found) or not compared


def self_check():
    head = ["decision", tables.CASES, "naive ns", "robust / naive", "Epick / robust"]
    kept = [tables.Table(head, [["orientation", "random", "1.0", "2.00", "6.00"], ["orientation", "near", "1.0", "8.00", ""]])]
    run = lambda *rows: worse(kept, [tables.Table(head, list(rows))])
    checks = {
        "the same run is not worse": run(*kept[0].rows) == ([], 3),
        "nanoseconds are not compared": run(["orientation", "random", "9.0", "2.00", "6.00"]) == ([], 2),
        "a larger ratio to a peer is worse": run(["orientation", "random", "1.0", "2.40", "6.00"])[0][0][:3] ==
                                             ("orientation, random, robust / naive", 2.0, 2.4),
        "a smaller one is better": run(["orientation", "random", "1.0", "1.00", "6.00"])[0] == [],
        "a smaller ratio of a peer to ours is worse": run(["orientation", "random", "1.0", "2.00", "5.00"])[0][0][1:3] == (6.0, 5.0),
        "15 % are allowed": run(["orientation", "random", "1.0", "2.28", "5.25"])[0] == [],
        "rows are told apart by their cases": run(["orientation", "near", "1.0", "8.00", "1.00"]) == ([], 1),
        "a new row is not compared": run(["segment", "random", "1.0", "9.00", "1.00"]) == ([], 0),
        "where nothing is compared, the guard fails": said(kept, [])[1],
        "the worst comes first": [one[3] for one in run(["orientation", "random", "1.0", "3.00", "2.00"])[0]] == [3.0, 1.5],
    }
    return [f"not so: {what}" for what, holds in checks.items() if not holds]


if __name__ == "__main__":
    if sys.argv[1:] != ["--self-check"]:
        sys.exit(__doc__)
    complaints = self_check()
    print("\n".join(complaints), end="\n" if complaints else "")
    sys.exit(1 if complaints else 0)
