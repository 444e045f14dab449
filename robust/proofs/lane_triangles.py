# SPDX-License-Identifier: Apache-2.0
"""The filters of triangles in robust/batch/isa, as Coq functions. See lane_shapes.py.

A scalar product, the bound of volumes and what is moderate are functions of their own, which the filters call.
"""
import re
from pathlib import Path

import lane_shapes
import lane_text
from lane_solids import Function, Solid, Solids
from lane_text import Term, Truth

HEADERS = ["robust/batch/isa/triangles.h"]
HEAD = lane_text.HEAD
# Definition, class, columns.
FILTERS = [("lane_segment_triangle", "SegmentTriangle", 15), ("lane_ray_triangle", "RayTriangle", 15),
           ("lane_triangle_triangle", "TriangleTriangle", 18)]
NAMES = {name for name, *_ in FILTERS}
XYZ = "xyz"
# Function, its vectors, whether it has a contracted product, what it is.
CALLED = [("dot", "ab", False, Term), ("bound_of", "a", True, Term), ("moderate", "a", False, Truth)]


class AllLanes(str):
    """That a bit is set in all lanes: in this one, and in the others."""


class Triangles(Solids):
    """The text of triangles.h and vectors.h, with the classes in classes."""

    def __init__(self, root):
        super().__init__(root, HEADERS)
        self.text += re.sub(r"//.*", "", (root / HEADERS[0]).read_text(encoding="utf-8"))
        for body in list(self.source.classes.values()):
            for kind, inner in re.findall(r"^  struct (\w+) \{\n(.*?)^  \};", body, re.M | re.S):
                self.source.classes[kind] = re.sub(r"^  ", "", inner, flags=re.M)


class Volumes(Solid):
    """Also arrays of numbers and of bits, and several assignments at once."""

    def call(self, text, scope, result=None, owner=None):
        outer, self.run.scope = self.run.scope, {**self.run.source.constants, **scope}
        Volumes(self.run, text, result, owner).block()
        inner, self.run.scope = self.run.scope, outer
        return inner

    def statement(self):
        scope = self.run.scope
        if self.peek() == "if":  # only where it is so in all lanes
            self.take()
            (condition,) = self.arguments()
            if not isinstance(condition, AllLanes):
                raise SystemExit("a branch by what is not in all lanes")
            self.take("return")
            self.run.early = condition, self.expression()
            self.take(";")
        elif self.peek() in ("Lanes", "Mask") and self.peek(2) == "[":
            name = [self.take(), self.take()][1]
            scope[name] = self.array()
            self.take(";")
        elif self.peek() in scope and self.peek(1) in ("=", "["):
            self.assignment()
            while self.peek() == ",":
                self.take()
                self.assignment()
            self.take(";")
        elif self.peek() == "const":
            self.take()
            self.declarations(self.take())
        else:
            super().statement()

    def declarations(self, kind):
        scope = self.run.scope
        while True:
            name = self.take()
            if self.peek() == "(":
                scope[name] = self.constructed(kind, self.arguments())
            elif self.peek() == "[":
                for token in ("[", "]", "="):
                    self.take(token)
                scope[name] = self.named_elements(name)
            else:
                self.take("=")
                scope[name] = self.run.named(name, self.expression())
            if self.take() == ";":
                return

    def assignment(self):
        place, index, wish = self.run.scope, self.peek(), self.take()
        while self.peek() == "[":
            place, index = place[index], self.index()
        self.take("=")
        place[index] = self.run.named(wish, self.expression())

    def named_elements(self, wish):
        return [self.run.named(wish, value) for value in self.elements()]

    def constructed(self, kind, arguments):
        if kind != "Corners":
            return super().constructed(kind, arguments)
        body = self.run.used[kind] = self.run.source.classes[kind]
        parameters, fields, text = self.run.shapes.constructor(kind, len(arguments))
        if text.strip():
            raise SystemExit(f"{kind}: {text}")
        outer, made = self.run.scope, {}
        given = dict(zip(lane_text.names_of(parameters), arguments, strict=True))
        reader = Volumes(self.run, fields, owner=(kind, made))
        while reader.peek():
            self.run.scope = {**self.run.source.constants, **given, **made}
            name = reader.take()
            if reader.peek() == "{":
                made[name] = reader.named_elements(name)
            else:
                (value,) = reader.arguments()
                made[name] = self.run.named(name, value)
            if reader.peek():
                reader.take(",")
        self.run.scope = outer
        if not re.search(r"^  Mask below\[3\], certain, apart;$", body, re.M):
            raise SystemExit(f"{kind}: other members")
        return made

    def unary(self):
        token = self.peek()
        if token in ("greater", "lesser") and self.peek(1) == "(":
            self.take()
            arguments = self.arguments()
            if all(isinstance(x, dict) for x in arguments):
                return self.method(None, token, {}, arguments)
            return Term(f"({lane_text.FUNCTIONS[token]} {' '.join(arguments)})")
        return super().unary()

    def of_name(self, name):
        if name in self.run.called and self.peek() == "(":
            _, _, contracted, kind = self.run.called[name]
            numbers = [n for vector in self.arguments() for n in vector.values()]
            return kind(f"(lane_{name} {'fused ' if contracted else ''}{' '.join(numbers)})")
        owner, _, function = name.rpartition("::")
        if owner:
            return self.method(owner, function, {}, self.arguments())
        return super().of_name(name)

    def member(self, value, name):
        if self.peek() == "(":
            return self.method("Corners", name, value, self.arguments())
        return super().member(value, name)

    def operation(self, operator, left, right):
        if operator == "==" and isinstance(left, Truth) and right == "true":
            return AllLanes(left)
        if operator == "^" and isinstance(left, Truth) and isinstance(right, Truth):
            return Truth(f"(xorb {left} {right})")
        return super().operation(operator, left, right)


def function(shapes, used, taken, called):
    one = Function(shapes, used, taken, {"all_lanes": Truth("true")})
    one.run.called, one.run.early = called, None
    return one


def called(shapes, used, name, vectors, contracted, kind):
    """One that the filters call."""
    names = [[f"{vector}{axis}".replace("by", "by_") for axis in XYZ] for vector in vectors]
    one = function(shapes, used, sum(names, []), {})
    found = Volumes(one.run, "").method(None, name, {}, [dict(zip(XYZ, map(Term, each))) for each in names])
    given = " ".join(sum(names, []))
    return one.defined(f"lane_{name} {'(fused : bool) ' if contracted else ''}({given} : float) : "
                       f"{'bool' if kind is Truth else 'float'}", found)


def filter_of(shapes, name, owner, count):
    used = {owner: shapes.source.classes[owner]}
    columns = [f"c{i}" for i in range(count)]
    one = function(shapes, used, [*columns, "others"], {row[0]: row for row in CALLED})
    if f"columns = {count};" not in used[owner]:
        raise SystemExit(f"{owner}: other columns")
    kind, ((given, _),), text = shapes.function(owner, "of")
    scope = {given: lane_shapes.Pointer(0), "all_lanes": Truth("true")}
    found = Volumes(one.run, "").call(text, scope, kind, (owner, {}))
    result = "({known}, {set})".format(**found["return"])
    if one.run.early:
        bit, other = one.run.early
        result = f"if others && {bit} then ({other['known']}, {other['set']}) else {result}"
    others = " others" if one.run.early else ""
    lines = [f"Definition {name} (fused{others} : bool) ({' '.join(columns)} : float) : bool * bool :=", *one.run.lets,
             f"  {result}."]
    return "\n".join(lines) + "\n", [used[k] for k in sorted(used)]


def all_of(root):
    """As lane_text.all_of."""
    root = Path(root)
    shapes, used = Triangles(root), {}
    shared = [str(sorted(shapes.source.constants.items())), lane_text.text_of_lanes(root)]
    texts = [called(shapes, used, *row) for row in CALLED]
    shared += [used[k] for k in sorted(used)]
    found = [(name, *filter_of(shapes, name, *row)) for name, *row in FILTERS]
    return (HEAD + "\n".join([*texts, *(d for _, d, _ in found)]),
            [(name, "".join(texts) + d, [*parts, *shared]) for name, d, parts in found])
