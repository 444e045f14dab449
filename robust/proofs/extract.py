#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The filters of robust/kernel as Coq definitions: what their C++ text computes, operation by operation.

  extract.py ROOT        all definitions, on standard output; ROOT/robust/kernel/*.h and ROOT/geometry/*.h are read

A function of the headers is run on names instead of numbers. An operation becomes one conjunct of the definition, in
the order of the text; functions that it calls (extent, dot, cross, certain, ...) are run in the same way, from their
own text. What this does not understand is an error, never left out.
"""
import hashlib
import pathlib
import re
import sys

from cpp import TYPES, Body, Number, Run, chosen_bounds
from source import Source, split

HEAD = """(* Written by extract.py from the headers of robust/kernel. *)
From Coq Require Import Reals Bool.
From Filters Require Import model.
Open Scope R_scope.
"""
# Definition, function or class and method, how many axes a pack has.
FILTERS = [
    ("cross_sign", "cross_sign"),
    ("orientation", "orientation"),
    ("circle", "circle"),
    ("elevation", "elevation"),
    ("segments", "segments"),
    ("ray", "ray"),
    ("plane", "plane"),
    ("face_side", "FacePlane.side"),
    ("spheres", "spheres"),
    ("ball_and_box_2", "ball_and_box", 2),
    ("ball_and_box_3", "ball_and_box", 3),
    ("sweep_start", "Sweep.start"),
    ("sweep_slope_at_start", "Sweep.slope_at_start"),
    ("sweep_slope_at_end", "Sweep.slope_at_end"),
    ("sweep_end", "Sweep.end"),
    ("sweep_passage", "Sweep.passage"),
    ("velocity_apart", "velocity_apart"),
]


def parameter(run, kind, name, names):
    if kind == "Float":
        names.append(run.fresh(name))
        return Number(names[-1])
    fields = [f.partition(":") for f in TYPES[kind].split()]
    return {f: parameter(run, k or "Float", f"{name}_{f}", names) for f, _, k in fields}


def extracted(source, name, function, *how):
    """The definition, and the text that it came from."""
    run, names = Run(source, how[0] if how and isinstance(how[0], int) else 0), []
    owner, _, method = function.rpartition(".")
    if owner:
        members = source.classes[owner]
        parameters, body, whole = members["this"]
        run.used[f"{owner}.this"] = whole
        run.bounds = "Bounds"
        run.members = scope_of(run, parameters, names)
        Body(run, body, run.members).run()
        run.owner = owner
        parameters, body, whole = members[method]
    else:
        ((kinds, body, whole),) = [f for (n, _), all_of in source.functions.items() if n == function for f in all_of
                                   if function not in ("plane", "slab") or len(f[0]) > 1]
        parameters = ", ".join(" ".join(k) for k in kinds)
        if run.pack:
            parameters = "Float radius"
    scope = {**run.members, **scope_of(run, parameters, names)}
    for i in range(run.pack):
        scope[f"axis{i}"] = run.call(
            "beyond_interval", list(scope_of(run, f"Float c{i}, Float min{i}, Float max{i}", names).values()))
    run.used[function] = whole
    run.bounds = chosen_bounds(body, "Bounds")
    answer = Body(run, body, scope).run()
    lines = [f"Definition {name} F T (M : machine T) ({' '.join(names)} : T) (answer : sign) :="]
    for result, operation, operands in run.steps:
        shown = " ".join(f"({' '.join(map(str, o))})" if isinstance(o, tuple) else str(o) for o in operands)
        lines.append(f"  exists {result}, {operation} M {shown} {result} /\\")
    lines.append(f"  answer = {answer}.")
    return "\n".join(lines), run.used


def scope_of(run, parameters, names):
    scope = {}
    for p in split(parameters):
        kind, name = re.sub(r"const |&", "", p).split()
        scope[name] = parameter(run, kind, name, names)
    return scope


def constants(source):
    return (f"{HEAD}Definition relative (twice_c d u : R) := {source.relative}.\n")


def all_of(root):
    """The constants' definitions, and for each filter its name, its definition and a digest of what it came from."""
    source, found = Source(pathlib.Path(root)), []
    for row in FILTERS:
        definition, used = extracted(source, *row)
        text = "\n".join([source.relative] + [" ".join(used[k].split()) for k in sorted(used)])
        found.append((row[0], definition, hashlib.sha256(text.encode()).hexdigest()[:16]))
    return constants(source), found


def main():
    defined, filters = all_of(sys.argv[1])
    print(defined + "\n".join(definition for _, definition, _ in filters))


if __name__ == "__main__":
    main()
