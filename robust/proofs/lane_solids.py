# SPDX-License-Identifier: Apache-2.0
"""Filters of robust/batch/isa for boxes with any half axes and for round solids, as Coq functions.

ObbObb is read along one axis, as a function of the numbers of its edges, and all axes are a list. Cores is read for one
guess, as a function of the guess, which may be any numbers: the text that guesses is not read, only that it says
nothing of what is proved. See extract.py; lane_shapes.py does the other filters.
"""
import re
from pathlib import Path

import lane_shapes
import lane_text
from lane_shapes import Lambda, Reader, Shapes, parameters_of
from lane_text import Run, Source, Term, Truth

HEADERS = [f"robust/batch/isa/{name}.h" for name in ("obbs", "round_solids")]
VECTORS = "robust/batch/isa/vectors.h"
AXES = "robust/kernel/solids/axes_of_boxes.h"
HEAD = """(* Written by extract.py from robust/batch/isa. *)
From Coq Require Import Reals ZArith Bool List.
From Filters Require Import floats lanes.
Import ListNotations.

"""
NAMES = {"lane_obb_obb", "lane_sphere_obb", "lane_capsule_capsule"}
# How a loop over the axes goes on, in which an axis is looked at more closely where it is not yet decided in all lanes.
LOOP = re.compile(r"^(.*?)^    for \(const auto& axis : axes\.of\) \{\n(.*?)"
                  r"^      if \(\(apart & all_lanes\) == all_lanes\) break;\n    \}\n"
                  r"    return \{solid & \(apart \| meets\), apart\};\n", re.M | re.S)
CLOSER = re.compile(r"if \(\(\((\w+ \| \w+)\) & all_lanes\) != all_lanes\) (\w+) \|= ([^;]*);")
SIZES = re.compile(r"^    Lanes sizes\[6\], sum = ([^;]*);\n"
                   r"    for \(std::size_t k = 0; k < 6; \+\+k\) sizes\[k\] = ([^;,]*), sum = ([^;]*);\n", re.M)
TABLE = ["for (const auto& [e, f, others] : kernel::axes_of_boxes)",
         "of[i++] = {e, f, {others[0], others[1], others[2], others[3]}};"]
STEP = """Fixpoint lane_obb_axes (fused : bool) (others ends : nat -> bool) (x y z : nat -> float)
    (way_x way_y way_z sum : float) (axes : list (nat * nat * (nat * nat * nat * nat))) (apart meets : bool) :=
  match axes with
  | [] => (apart, meets)
  | (e, f, (p, q, r, s)) :: rest =>
    let '(apart, meets) := lane_obb_axis fused (others (length rest)) x y z way_x way_y way_z sum e f p q r s apart
      meets in
    if apart && ends (length rest) then (apart, meets)
    else lane_obb_axes fused others ends x y z way_x way_y way_z sum rest apart meets
  end.
"""
CONTACT = re.compile(r"^  Verdict contact\(Lanes reach, Lanes& t\) const \{\n    constexpr int turns = [^;\n]*;\n(.*?)"
                     r"^    for \(int turn = 0; [^{]*\{\n(.*?)"
                     r"^      for \(Lanes& part : t\) part = moved\(part\);\n(.*?)"
                     r"^    \}\n    return \{moderate & \(near \| apart\), apart\};\n  \}", re.M | re.S)
CORES = re.compile(r"Cores<(\d), (true|false)>(?: cores)?\{(.*?), \{([^}]*)\}\}")
XYZ = "xyz"


class Index(str):
    """The index of an edge, as a natural number."""


class Edges:
    """Six edges, or their sizes, by an index."""

    def __init__(self, *functions):
        self.functions = functions

    def at(self, index):
        index = index if isinstance(index, Index) else f"{index}%nat"
        terms = [Term(f"({function} {index})") for function in self.functions]
        return dict(zip(XYZ, terms)) if len(terms) == 3 else terms[0]


class Solids(Shapes):
    """The text of classes, with those of kernels.h and vectors.h, and of the functions of one header."""

    def __init__(self, root, headers=tuple(HEADERS), functions=VECTORS):
        self.source = Source(root, [*lane_text.HEADERS, *headers])
        text = (root / functions).read_text(encoding="utf-8")
        self.text = re.sub(r"//.*", "", text)
        for kind, body in self.source.classes.items():
            self.source.classes[kind] = re.sub(r"Lanes \(&t\)\[n\]", "Lanes& t", body)


class Solid(Reader):
    """Also loops over edges, functions that see what is around them, and edges by an index."""

    def call(self, text, scope, result=None, owner=None):
        outer, self.run.scope = self.run.scope, {**self.run.source.constants, **scope}
        Solid(self.run, text, result, owner).block()
        inner, self.run.scope = self.run.scope, outer
        return inner

    def method(self, owner, name, fields, arguments):
        kind, parameters, text = self.run.shapes.function(owner, name)
        self.run.used[f"{owner}.{name}" if owner else name] = text
        scope = {**fields, **dict(zip([n for n, _ in parameters], arguments, strict=True))}
        return self.call(text, scope, kind, (owner, fields))["return"]

    def statement(self):
        scope = self.run.scope
        head = " ".join(self.tokens[self.at:self.at + 9])
        captured = re.match(r"const auto \w+ = \[ ([&\w ,]*?)\] \(", " ".join(self.tokens[self.at:self.at + 14]))
        if head.startswith("for ( const InSpace & edge : edges )"):
            start = self.at = self.at + 9
            for edge in scope["edges"]:
                self.at, scope["edge"] = start, edge
                self.statement()
        elif head.startswith("const auto & ["):
            self.at += 4
            names = [self.take()]
            while self.peek() == ",":
                self.take()
                names.append(self.take())
            self.take("]")
            self.take("=")
            scope.update(zip(names, self.expression(), strict=True))
            self.take(";")
        elif captured:
            name = self.tokens[self.at + 2]
            self.at += 6 + len(captured[1].split())
            self.take("(")
            parameters = self.until(")")
            self.take("{")
            scope[name] = Lambda(parameters_of(parameters), self.until("}"))
            self.take(";")
        elif self.peek() == "InSpace":
            self.tokens.insert(self.at, "const")
            super().statement()
        else:
            super().statement()

    def applied(self, function):
        arguments = self.arguments()
        names = [n for n, _ in function.parameters]
        return self.call(function.text, {**self.run.scope, **dict(zip(names, arguments, strict=True))},
                         owner=self.owner)["return"]

    def operation(self, operator, left, right):
        if isinstance(left, Index) and isinstance(right, int) and operator == "+":
            return Index("(S " * right + left + ")" * right)
        if isinstance(right, dict) and isinstance(left, (Term, dict)):
            return self.method("InSpace" if operator == "-" else None, f"operator{operator}", {}, [left, right])
        return super().operation(operator, left, right)

    def unary(self):
        if self.peek() == "-":
            self.take()
            return -super().unary()
        return super().unary()

    def of_name(self, name):
        if name == "zero" and self.peek() == "(":
            numbers = [n for edge in self.arguments() for n in edge.values()]
            return Truth(f"(lane_obb_zero {' '.join(numbers)})")
        if name not in self.run.scope and self.peek() == "(" and name not in lane_shapes.KINDS:
            owner, fields = self.owner or (None, {})
            if owner and re.search(rf"^  (?:static )?\w+ {name}\(", self.run.source.classes[owner], re.M):
                return self.method(owner, name, fields, self.arguments())
            return self.method(None, name, {}, self.arguments())
        return super().of_name(name)

    @staticmethod
    def element(value, index):
        if isinstance(value, Edges):
            return value.at(index)
        return Reader.element(value, index)


class Function:
    """A definition in the making."""

    def __init__(self, shapes, used, taken, scope):
        self.run = Run(shapes.source, None, used)
        self.run.shapes = shapes
        self.run.taken.update(taken)
        self.run.scope.update(scope)

    def read(self, text, owner=None):
        Solid(self.run, text, None, owner).block()
        return self.run.scope

    def value(self, text, owner=None):
        return Solid(self.run, text, None, owner).expression()

    def guessed(self, text):
        """A statement that may be there for a guess alone; what it defines is not known then."""
        try:
            self.read(text)
        except SystemExit:
            pass

    def defined(self, head, result):
        """With the lines that the result needs."""
        kept, needed = [], set(re.findall(r"\w+", result))
        for line in reversed(self.run.lets):
            name, value = re.fullmatch(r"  let (\w+) := (.*) in", line).groups()
            if name in needed:
                kept.insert(0, line)
                needed.update(re.findall(r"\w+", value))
        return "\n".join([f"Definition {head} :=", *kept, f"  {result}."]) + "\n"


def points(*names):
    return [{axis: Term(f"{name}_{axis}") for axis in XYZ} for name in names]


def numbers(*vectors):
    return " ".join(n for each in vectors for n in each.values())


def table(root, shapes):
    """The axes, as obbs.h takes them from the table for one question."""
    if not all(line in shapes.source.classes["Axes"] for line in TABLE):
        raise SystemExit("obbs.h: Axes is another")
    text = (root / AXES).read_text(encoding="utf-8")
    rows = re.findall(r"\{(\d), (\d), \{(\d), (\d), (\d), (\d)\}\}", text)
    rows = [f"({v}, {w}, ({', '.join(others)}))" for v, w, *others in rows]
    if f"std::array<Spanned, {len(rows)}>" not in text:
        raise SystemExit(f"{AXES}: {len(rows)} axes")
    return "Definition lane_obb_table := [" + "; ".join(rows) + "]%nat.\n", rows


def obbs(root, shapes):
    used, text = {}, shapes.source.classes["ObbObb"]
    axes, rows = table(root, shapes)
    whole = re.search(r"^  static Verdict of\(const Lanes\* c\) \{\n(.*?)^  \}", text, re.M | re.S)[1]
    start, body = LOOP.fullmatch(whole).groups()
    sizes = SIZES.search(start)
    first, then = start[:sizes.start()], start[sizes.end():]
    functions, edges = ["x", "y", "z"], Edges("x", "y", "z")
    names = ["x", "y", "z", "fused", "others", "sum", "k", "e", "f", "p", "q", "r", "s", "apart", "meets"]
    ways = points("way")[0]
    around = {"edges": edges, "sizes": Edges("lane_obb_size x y z"), "sum": Term("sum"), "way": ways}

    def function(scope):
        return Function(shapes, used, [*names, *ways.values()], {**around, **scope})

    one = function({"k": Index("k")})
    size = one.defined("lane_obb_size (x y z : nat -> float) (k : nat) : float", one.value(sizes[2])[1:-1])
    one = function({})
    corners = [point for point in points("e", "f")]
    one.run.taken.update(n for corner in corners for n in corner.values())
    zero = Solid(one.run, "").method("ObbObb", "zero", {}, corners)
    zero = one.defined(f"lane_obb_zero ({numbers(*corners)} : float) : bool", zero)

    lines = re.split(r"^(?=    const Mask solid)", then, flags=re.M)
    one = function({"k": Index("k")})
    scope = one.read(lines[0])
    solid = Lambda([], scope["certain_volume"].text)
    scope["certain"] = solid
    volume = one.defined("lane_obb_volume (fused : bool) (x y z : nat -> float) (sum : float) (k : nat) : bool",
                         one.value("certain()"))
    one = function({"apart": Truth("apart"), "meets": Truth("meets"), "others": Truth("others"),
                    "axis": {"e": Index("e"), "f": Index("f"), "others": [Index(n) for n in "pqrs"]}})
    one.read(lines[0])
    scope = one.read(CLOSER.sub(r"\2 |= ~(others & (\1)) & \3;", body))
    axis = one.defined("lane_obb_axis (fused others : bool) (x y z : nat -> float) (way_x way_y way_z sum : float)\n"
                       "    (e f p q r s : nat) (apart meets : bool) : bool * bool",
                       f"({scope['apart']}, {scope['meets']})")

    columns = [f"c{i}" for i in range(24)]
    one = Function(shapes, used, [*names, *columns], {"c": lane_shapes.Pointer(0)})
    scope = one.read(first)
    corners, scope["edges"] = scope["edges"], edges
    way = scope["way"]
    scope["sizes"] = around["sizes"]
    scope["sum"] = one.run.named("sum", one.value(sizes[1]))
    for k in range(6):
        scope["k"] = k
        scope["sum"] = one.run.named("sum", one.value(sizes[3]))
    certain = re.fullmatch(r"    const Mask solid = certain_volume\((\d)\) & certain_volume\((\d)\);\n"
                           r"    Mask apart = 0, meets = all_lanes;\n", lines[1])
    parts = [f"lane_obb_volume fused x y z {scope['sum']} {k}" for k in certain.groups()]
    last = (f"let '(apart, meets) := lane_obb_axes fused others ends x y z {numbers(way)} {scope['sum']} lane_obb_table"
            f" false true in\n  ({parts[0]} && {parts[1]} && (apart || meets), apart)")
    found = one.defined(f"lane_obb_obb (fused : bool) (others ends : nat -> bool) ({' '.join(columns)} : float) : "
                        "bool * bool", last)
    lists = "".join(f"  let {f} k := nth k [{'; '.join(c[f] for c in corners)}] {corners[0][f]} in\n"
                    for f in functions)
    found = found.replace(" :=\n", " :=\n" + lists, 1)
    used.update({"of": whole, "table": " ".join(rows), "Axes": shapes.source.classes["Axes"]})
    return "".join([size, zero, volume, axis, STEP, axes, found]), [used[k] for k in sorted(used)]


def cores(shapes, count, symmetric):
    """Signs that one guess proves, and where all numbers are moderate."""
    used, text = {}, shapes.source.classes["Cores"]
    found = CONTACT.search(text)
    if not found or re.search(r"\b(?:near|apart|most|moderate|return|break|goto)\b", found[2]):
        raise SystemExit("round_solids.h: contact is another")
    vectors = points("way", *[f"edge{k}" for k in range(count)])
    guess = [Term(f"t{k}") for k in range(count)]
    fields = {"way": vectors[0], "edges": vectors[1:], "n": count, "symmetric": symmetric, "reach": Term("reach")}
    one = Function(shapes, used, [*numbers(*vectors).split(), "reach", *guess], fields)
    owner = ("Cores", fields)
    one.read(found[1], owner)
    one.run.scope["t"] = [one.run.named(f"part{k}", Solid(one.run, "").method("Cores", "moved", fields, [t]))
                          for k, t in enumerate(guess)]
    scope = one.read(found[3], owner)
    given = f"{numbers(*vectors)} reach"
    name = f"lane_cores_{count}"
    used["contact"] = found[1] + found[3]
    return (one.defined(f"{name} (fused : bool) ({given} {' '.join(guess)} : float) : bool * bool",
                        f"({scope['near']}, {scope['apart']})")
            + one.defined(f"{name}_moderate ({given} : float) : bool", scope["moderate"])), used


def round_solids(shapes, name, owner):
    text = shapes.source.classes[owner]
    count = int(re.search(r"columns = (\d+);", text)[1])
    whole = re.search(r"^  static Verdict of\(const Lanes\* c\) \{\n(.*?)^  \}", text, re.M | re.S)[1]
    edges, symmetric, way, those = CORES.search(whole).groups()
    edges = int(edges)
    definition, used = cores(shapes, edges, symmetric == "true")
    reach = re.search(r"^    Verdict found = .*\.contact\((.*), t\);\n", whole, re.M)[1]
    known = re.search(r"^    found\.known &= (.*?);\n    return found;\n$", whole, re.M | re.S)[1]
    if len(re.findall(r"\bfound\b", whole)) != 3:
        raise SystemExit(f"{owner}: another answer")
    columns = [f"c{i}" for i in range(count)]
    one = Function(shapes, used, [*columns, "guesses", "check", "g", "apart", "near"],
                   {"c": lane_shapes.Pointer(0)})
    for statement in re.findall(r"^    const (?:InSpace|Lanes) [^;]*;", whole, re.M):
        one.guessed(statement)
    reader = Solid(one.run, f"{{ {those} }}")
    vectors = [one.value(way), *reader.elements()]
    if len(vectors) != 1 + edges:
        raise SystemExit(f"{owner}: {len(vectors) - 1} edges")
    given = f"{numbers(*vectors)} {one.run.named('reach', one.value(reach))}"
    parts = [f"t{k}" for k in range(edges)]
    check = f"let '({', '.join(parts)}) := g in lane_cores_{edges} fused {given} {' '.join(parts)}"
    last = (f"let check g := {check} in\n  let apart := existsb (fun g => snd (check g)) guesses in\n"
            f"  (lane_cores_{edges}_moderate {given} && (existsb (fun g => fst (check g)) guesses || apart) && "
            f"{one.value(known)}, apart)")
    kind = " * ".join(["float"] * edges)
    definition += one.defined(f"{name} (fused : bool) (guesses : list ({kind})) ({' '.join(columns)} : float) : "
                              "bool * bool", last)
    used["of"] = " ".join([way, those, reach, known])
    return definition, [used[k] for k in sorted(used)]


def all_of(root):
    """As lane_text.all_of."""
    root = Path(root)
    shapes = Solids(root)
    shared = [str(sorted(shapes.source.constants.items())), lane_text.text_of_lanes(root)]
    found = [("lane_obb_obb", *obbs(root, shapes)),
             ("lane_sphere_obb", *round_solids(shapes, "lane_sphere_obb", "SphereObb")),
             ("lane_capsule_capsule", *round_solids(shapes, "lane_capsule_capsule", "CapsuleCapsule"))]
    return HEAD + "\n".join(d for _, d, _ in found), [(name, d, [*parts, *shared]) for name, d, parts in found]
