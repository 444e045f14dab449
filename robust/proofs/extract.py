#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The filters of robust/kernel as Coq definitions: what their C++ text computes, operation by operation.

  extract.py ROOT        all definitions, on standard output; ROOT/robust/kernel/filters/*.h and ROOT/geometry/*.h are read

A function of the headers is run on names instead of numbers. An operation becomes one conjunct of the definition, in
the order of the text; functions that it calls (extent, dot, cross, certain, ...) are run in the same way, from their
own text. Text that this does not understand is an error, never left out. enclosed.py does the same for enclosed.h and
push.h; lane_text.py, lane_shapes.py, lane_solids.py, lane_triangles.py, lane_linear.py and lane_close.py do it for
arrays.
"""
import hashlib
import pathlib
import re
import sys

import enclosed
import lane_close
import lane_linear
import lane_shapes
import lane_solids
import lane_text
import lane_triangles
from cpp import Body, Run
from source import Source, split
from values import TYPES, Array, Index, Number, Truth, chosen_bounds

HEAD = """(* Written by extract.py from the headers of robust/kernel. *)
From Coq Require Import Reals Bool.
From Filters Require Import model.
Open Scope R_scope.
"""
# Definition, function or class and method, how many axes a pack has. A class's "this" is its constructor, as a
# definition of its own: it relates what it is made of to what it computes, and "kept" methods start from both. Of a
# class alone, all of it (see folded). Several functions are one filter: its definitions are the name of it and theirs.
FILTERS = [
    ("cross_sign", "cross_sign"),
    ("orientation", "orientation"),
    ("circle", "circle"),
    ("elevation", "elevation"),
    ("segments", "segments"),
    ("ray", "ray"),
    ("plane", "plane"),
    ("face_side", "FacePlane.side"),
    ("ray_rise", "RayAndTriangle.rise"),
    ("ray_beside_ca", "RayAndTriangle.beside_ca"),
    ("ray_beside_ab", "RayAndTriangle.beside_ab"),
    ("ray_beside_bc", "RayAndTriangle.beside_bc"),
    ("ray_height", "RayAndTriangle.height"),
    ("ray_and_ball", "RayAndBall.meets"),
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
    ("slab", "SlabDepths"),
    ("crossings", "Crossings"),
    ("kdop", ("height", "greater_extent", "lower", "higher", "doubt", "between")),
    ("heights_meeting", "Heights.meeting"),
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


def made(run, owner, names, kept):
    """The constructor's run: its members, and those that it computed as parameters of others."""
    parameters, body, whole = run.source.classes[owner]["this"]
    run.used[f"{owner}.this"] = whole
    run.bounds = chosen_bounds(run.source.classes[owner].get("B", ("", "", ""))[1], "Bounds")
    run.members = scope_of(run, parameters, names)
    given = set(run.members)
    Body(run, body, run.members).run()
    computed, products = [], []
    for name, value in run.members.items():
        if isinstance(value, Array) and f"({value.name} 0%nat)" in run.elements:
            computed.append((value.name, "nat -> T"))
        elif isinstance(value, Number) and name not in given and value.name not in [n for n, _ in names]:
            computed.append((value.name, "T"))
            products += [name] * bool(value.factors)
    run.owner = owner
    if kept and products:
        raise SystemExit(f"a product is kept: {products}")
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
        kept = "kept" in how or method == "this"
        computed = made(run, owner, names, kept)
        if "kept" in how:
            run.steps = []
        if kept:
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


def several(source, name, functions):
    texts, used = [], {}
    for function in functions:
        text, parts = extracted(source, f"{name}_{function}", function)
        texts.append(text)
        used.update(parts)
    return "\n".join(texts), used


def shown(name, run, names, hidden, answer):
    if answer is None:
        return defined(run, name, names, "", "", hidden)
    kind = ("T" if isinstance(answer, Number) else "bool" if isinstance(answer, Truth) else
            "option location" if "Inside" in answer else "option T" if "None" in answer else
            "meeting" if "meeting_" in answer else "sign")
    return defined(run, name, names, f" (answer : {kind})", f"answer = {answer}", hidden)


def defined(run, name, names, result, last, hidden=()):
    lines = [f"Definition {name} (F : format) T (M : machine T) {bound(names)}{result} :="]
    for step, operation, operands in run.steps:
        them = " ".join(f"({' '.join(map(str, o))})" if isinstance(o, tuple) else str(o) for o in operands)
        exists = "" if step.name in hidden or step.name in run.elements else f"exists {step}, "
        lines.append(f"  {exists}{operation} M {them} {step} /\\")
    return "\n".join([*lines, f"  {last}."]) if last else "\n".join(lines)[:-3] + "."


def scope_of(run, parameters, names):
    scope = {}
    for p in split(parameters):
        kind, name = re.sub(r"const |&", "", p).split()
        scope[name] = parameter(run, kind, name, names)
    return scope


def digest(parts):
    return hashlib.sha256("\n".join(" ".join(part.split()) for part in parts).encode()).hexdigest()[:16]


def folded(source, name, owner):
    """A class that its constructor starts, that add goes on with and that sign ends. Each gets a definition, from the
    numbers of the class (the constructor has none yet) and its arguments to these numbers again, or to the answer."""
    kept, used, texts = [n for kind, n in source.data[owner] if kind == "Float"], {}, []
    for method in ("this", "add", "sign"):
        run, names = Run(source, 0), []
        run.owner, run.bounds = owner, "Bounds"
        parameters, body, whole = source.classes[owner][method]
        before = [(kind, n) for kind, n in source.data[owner] if method != "this"]
        run.members = {n: parameter(run, kind, n.rstrip("_"), names) for kind, n in before}
        given = scope_of(run, parameters, names)
        scope = {**run.members, **given}
        if method == "this":
            run.members = scope
        argued = {n: v for n, v in scope.items() if isinstance(v, dict)}
        answer = Body(run, body, scope).run()
        for n, value in scope.items():  # other than numbers, a class keeps what its constructor was given, as it was
            if n.endswith("_") and n not in kept and not any(value is v for v in argued.values()):
                raise SystemExit(f"{owner}.{method}: {n} is changed")
        run.used[f"{owner}.{method}"] = whole
        used.update(run.used)
        if method == "sign":
            texts.append(defined(run, f"{name}_sign", names, " (answer : sign)", f"answer = {answer}"))
        else:
            after = [run.fresh(f"{n}after") for n in kept]
            result = " /\\ ".join(f"{a} = {scope[n]}" for a, n in zip(after, kept))
            texts.append(defined(run, f"{name}_{'first' if method == 'this' else method}", names,
                                 f" ({' '.join(after)} : T)", result))
    return "\n".join(texts), used


def crossings(source, name, owner):
    """Reads in robust/polygons/point_in_polygon.cpp what one lane adds, and what is answered of two."""
    texts = []
    for method, lanes in (("add", ("",)), ("location", ("0", "1"))):
        run, names = Run(source, 0), []
        run.owner, run.bounds = owner, "Bounds"
        parameters, body, _ = source.classes[owner][method]
        parities = [Truth(run.fresh(f"parity{lane}")) for lane in lanes]
        kept = {n: [parameter(run, "Float", f"{n}{lane}", names) for lane in lanes]
                for n in ("sum_x", "sum_y", "least")}
        kept["parity"] = parities
        scope = {f"{n}_": v if len(lanes) > 1 else v[0] for n, v in kept.items()}
        scope.update(scope_of(run, parameters, names))
        answer = Body(run, body, scope).run()
        bools = f" ({' '.join(parities)} : bool)"
        if method == "add":
            after = [run.fresh(f"{n}_after") for n in kept]
            bools += f" ({' '.join(after[:3])} : T) ({after[3]} : bool)"
            answer = " /\\ ".join(f"{a} = {scope[n + '_']}" for a, n in zip(after, kept))
        else:
            bools, answer = bools + " (answer : option location)", f"answer = {answer}"
        texts.append(defined(run, f"{name}_{method}", names, bools, answer))
    return "\n".join(texts), {owner: source.crossings, **run.used}


def all_of(root):
    """The files of definitions, and for each filter its name, its definition and a digest of what it came from."""
    root = pathlib.Path(root)
    source, found = Source(root), []
    for row in FILTERS:
        how = (several if isinstance(row[1], tuple) else crossings if row[1] == "Crossings" else
               folded if source.data.get(row[1]) else extracted)
        definition, used = how(source, *row)
        found.append((row[0], definition, digest([source.relative] + [used[k] for k in sorted(used)])))
    files = {
        "constants": f"{HEAD}Definition relative (twice_c d u : R) := {source.relative}.\n",
        "filters": HEAD.replace("Import model.", "Import model constants.") + "\n".join(d for _, d, _ in found) + "\n"}
    files["enclosed"], others = enclosed.all_of(root)
    for name, reader in (("lane_filters", lane_text), ("lane_shape_filters", lane_shapes),
                         ("lane_solid_filters", lane_solids), ("lane_linear_filters", lane_linear),
                         ("lane_close_filters", lane_close),
                         ("lane_triangle_filters", lane_triangles)):
        files[name], lanes = reader.all_of(root)
        others += lanes
    return files, found + [(name, definition, digest(parts)) for name, definition, parts in others]


def main():
    print("\n".join(all_of(sys.argv[1])[0].values()))


if __name__ == "__main__":
    main()
