#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The filters of robust/kernel as Coq definitions: what their C++ text computes, operation by operation.

  extract.py ROOT        all definitions, on standard output; ROOT/robust/kernel/*.h and ROOT/geometry/*.h are read

A function of the headers is run on names instead of numbers. An operation becomes one conjunct of the definition, in
the order of the text; functions that it calls (extent, dot, cross, certain, ...) are run in the same way, from their
own text. What this does not understand is an error, never left out. enclosed.py does the same for enclosed.h.
"""
import hashlib
import pathlib
import re
import sys

import enclosed
from cpp import TYPES, Array, Body, Index, Number, Run, Truth, chosen_bounds
from source import Source, split

HEAD = """(* Written by extract.py from the headers of robust/kernel. *)
From Coq Require Import Reals Bool.
From Filters Require Import model.
Open Scope R_scope.
"""
# Definition, function or class and method, how many axes a pack has. A class's "this" is its constructor, as a
# definition of its own: it relates what it is made of to what it computes, and "kept" methods start from both.
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
    ("obb_axes", "ObbAxes.this"),
    ("obb_volume", "ObbAxes.volume_is_certain", "kept"),
    ("obb_axis", "ObbAxes.on_axis", "kept"),
    ("point_in_obb", "point_in_obb"),
]


def parameter(run, kind, name, names):
    array = re.fullmatch(r"([\w:]+)\[\d+\]", kind)
    if array:
        for field in TYPES.get(array[1], "").split() or [""]:
            names.append((run.fresh(f"{name}_{field}".rstrip("_")), f"nat -> {COQ[array[1]]}"))
        return Array(name, array[1])
    if kind in COQ and kind not in TYPES:
        names.append((run.fresh(name), COQ[kind]))
        return (Number if kind == "Float" else Index)(names[-1][0])
    fields = [f.partition(":") for f in TYPES[kind].split()]
    return {f: parameter(run, k or "Float", f"{name}_{f}", names) for f, _, k in fields}


COQ = {"Float": "T", "Vector3": "T", "std::size_t": "nat"}


def made(run, owner, names):
    """The constructor's run: its members, and those that it computed as parameters of others."""
    parameters, body, whole = run.source.classes[owner]["this"]
    run.used[f"{owner}.this"] = whole
    run.bounds = chosen_bounds(run.source.classes[owner].get("B", ("", "", ""))[1], "Bounds")
    run.members = scope_of(run, parameters, names)
    given = set(run.members)
    Body(run, body, run.members).run()
    computed = []
    for name, value in run.members.items():
        if isinstance(value, Array) and f"({value.name} 0%nat)" in run.elements:
            computed.append((value.name, "nat -> T"))
        elif isinstance(value, Number) and name not in given and value.name not in [n for n, _ in names]:
            if value.factors:
                raise SystemExit(f"a product is kept: {name}")
            computed.append((value.name, "T"))
    run.owner = owner
    return computed


def bound(names):
    """(a b : T) (c : nat) ..."""
    groups = []
    for name, kind in names:
        if groups and groups[-1][1] == kind:
            groups[-1][0].append(name)
        else:
            groups.append(([name], kind))
    return " ".join(f"({' '.join(group)} : {kind})" for group, kind in groups)


def extracted(source, name, function, *how):
    """The definition, and the text that it came from."""
    run, names = Run(source, how[0] if how and isinstance(how[0], int) else 0), []
    owner, _, method = function.rpartition(".")
    answer, hidden = None, []
    if owner:
        computed = made(run, owner, names)
        if "kept" in how:
            run.steps = []
        if "kept" in how or method == "this":
            names += computed
            hidden = [n for n, _ in computed]
        if method == "this":
            return shown(name, run, names, hidden, None), run.used
        parameters, body, whole = source.classes[owner][method]
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
    run.bounds = chosen_bounds(body, run.bounds)
    answer = Body(run, body, scope).run()
    return shown(name, run, names, hidden, answer), run.used


def shown(name, run, names, hidden, answer):
    kind = "bool" if isinstance(answer, Truth) else "option location" if "Some" in (answer or "") else "sign"
    of_answer = f" (answer : {kind})" if answer else ""
    lines = [f"Definition {name} (F : format) T (M : machine T) {bound(names)}{of_answer} :="]
    for result, operation, operands in run.steps:
        them = " ".join(f"({' '.join(map(str, o))})" if isinstance(o, tuple) else str(o) for o in operands)
        exists = "" if result.name in hidden or result.name in run.elements else f"exists {result}, "
        lines.append(f"  {exists}{operation} M {them} {result} /\\")
    if not answer:
        return "\n".join(lines)[:-3] + "."
    return "\n".join(lines + [f"  answer = {answer}."])


def scope_of(run, parameters, names):
    scope = {}
    for p in split(parameters):
        kind, name = re.sub(r"const |&", "", p).split()
        scope[name] = parameter(run, kind, name, names)
    return scope


def digest(parts):
    return hashlib.sha256("\n".join(" ".join(part.split()) for part in parts).encode()).hexdigest()[:16]


def all_of(root):
    """The files of definitions, and for each filter its name, its definition and a digest of what it came from."""
    root = pathlib.Path(root)
    source, found = Source(root), []
    for row in FILTERS:
        definition, used = extracted(source, *row)
        found.append((row[0], definition, digest([source.relative] + [used[k] for k in sorted(used)])))
    files = {
        "constants": f"{HEAD}Definition relative (twice_c d u : R) := {source.relative}.\n",
        "filters": HEAD.replace("Import model.", "Import model constants.") + "\n".join(d for _, d, _ in found) + "\n"}
    files["enclosed"], others = enclosed.all_of(root)
    return files, found + [(name, definition, digest(parts)) for name, definition, parts in others]


def main():
    print("\n".join(all_of(sys.argv[1])[0].values()))


if __name__ == "__main__":
    main()
