# SPDX-License-Identifier: Apache-2.0
"""The mutants: mutants/OPERATION.jsonl for each operation, one {"file", "find", "plant", "what"} a line. In that file
of robust/ the expression `find`, which stands there once (or once in `within`, which does), becomes `plant`.

A mutant of a shared kernel may stand in the lists of several operations, which all have to kill it; it has one
number."""
import json
import pathlib

WAYS = ("properties", "vectors", "fuzzing")


def change(mutant):
    return tuple(mutant.get(key) for key in ("file", "find", "within", "plant"))


def listed():
    """[(number from 1, mutant)], each mutant with its `operation` and its `id`, OPERATION/LINE."""
    numbers, mutants = {}, []
    for path in sorted((pathlib.Path(__file__).resolve().parent / "mutants").glob("*.jsonl")):
        for place, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            mutant = {"operation": path.stem, "id": f"{path.stem}/{place}"} | json.loads(line)
            mutants.append((numbers.setdefault(change(mutant), len(numbers) + 1), mutant))
    return mutants


def chosen(mutants, share, ways=WAYS):
    """Which (number, mutant, way) are run. share: "all"; "N/M", every M-th from the N-th; or "test", a third: each
    mutant in one way, which changes with its place among those of its operation, so that every operation is run in
    every way; and what several operations list only for the first of them. Only those of the given ways are taken."""
    everything = [(number, mutant, way) for number, mutant in mutants for way in WAYS]
    if share == "test":
        everything = third(mutants)
    elif share != "all":
        n, m = map(int, share.split("/"))
        if not 1 <= n <= m:
            raise ValueError("N/M has 1 <= N <= M")
        everything = everything[n - 1 :: m]
    return [cell for cell in everything if cell[2] in ways]


def third(mutants):
    cells, seen = [], set()
    for operation in sorted({mutant["operation"] for _, mutant in mutants}):
        own = [(number, mutant) for number, mutant in mutants if mutant["operation"] == operation]
        first = [one for one in own if one[0] not in seen] or own
        seen |= {number for number, _ in own}
        # Fewer mutants than ways: they take turns until every way has had one.
        cells += [(*first[turn % len(first)], WAYS[turn % len(WAYS)]) for turn in range(max(len(first), len(WAYS)))]
    return cells
