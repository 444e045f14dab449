# SPDX-License-Identifier: Apache-2.0
"""Filters of robust/batch/isa that work with points, axes and sides, as Coq functions: lane_text.py does the others.

Points and axes are fields of numbers here, and classes have constructors, methods and operators: each is run from its
own text.
"""
import copy
import re
from fractions import Fraction

import lane_text
from lane_text import Body, Run, Source, Term, Truth

HEADERS = ["robust/batch/isa/beside.h"]
NUMBERS = "robust/batch/shapes/faces.h"  # what a convex solid's faces are to beside.h
SPACE = "geometry/space.h"
HEAD = lane_text.HEAD.replace("Import floats lanes.", "Import floats lanes lane_filters.")
# Definition, class or None, a function without one, how many arguments, dimensions.
FILTERS = [("lane_side_of_face", None, "side_of_face", 9), ("lane_ray_box_2", "RayBox", None, 8, 2),
           ("lane_ray_box_3", "RayBox", None, 12, 3)]
NAMES = {name for name, *_ in FILTERS}
FIELDS = {"Certain": ("positive", "negative"), "Verdict": ("known", "set")}
KINDS = ("InSpace", "Certain", "OfAxis")


class Break(Exception):
    """Out of a loop."""


class Pointer:
    """To a column."""

    def __init__(self, offset):
        self.offset = offset


class Lambda:
    def __init__(self, parameters, text):
        self.parameters, self.text = parameters, text


def parameters_of(text):
    """Name, and whether it is a number that is changed."""
    return [(p.split()[-1].lstrip("*&"), "&" in p and "const" not in p) for p in text.split(",") if p]


class Shapes:
    """The text of classes, and of the functions of beside.h."""

    def __init__(self, source, root):
        self.source = source
        text = "".join((root / name).read_text(encoding="utf-8") for name in [*HEADERS, NUMBERS])
        self.text = re.sub(r"//.*|^inline ", "", text, flags=re.M)
        text = (root / SPACE).read_text(encoding="utf-8")
        for head in (r"operator-\(const Point3<Real>&", r"cross\("):
            found = re.search(rf"^Vector3<Real> {head}.*?^\}}\n", text, re.M | re.S)[0]
            self.text += re.sub(r"<Real>|\bReal(?=\()", "", found)
        for body in list(source.classes.values()):
            for kind, inner in re.findall(r"^  struct (\w+) \{\n(.*?)^  \};", body, re.M | re.S):
                source.classes[kind] = re.sub(r"^  ", "", inner, flags=re.M)

    def members(self, owner):
        """The names of its fields."""
        found = re.findall(r"^  (?:Lanes|Mask|InSpace) ([\w, ]+);$", self.source.classes[owner], re.M)
        return [name for line in found for name in line.split(", ")]

    def constructor(self, owner, count):
        """Parameters, initializers and body of the constructor with so many arguments."""
        found = re.findall(rf"^  (?:explicit )?{owner}\(([^)]*)\)\s*: (.*?) \{{(?:\}}$|\n(.*?)^  \}})",
                           self.source.classes[owner], re.M | re.S)
        (one,) = [f for f in found if len(f[0].split(",")) == count]
        return one

    def function(self, owner, name):
        """Result, parameters and body; of a method, or without a class."""
        text, indent = (self.source.classes[owner], "  ") if owner else (self.text, "")
        before = r"(?:\[\[gnu::\w+\]\] inline |friend |static )?"
        found = re.findall(rf"^{indent}{before}(\w[\w:<>, ]*?) {re.escape(name)}\(([^)]*)\)(?: const)? "
                           rf"\{{(?: ([^\n]*) \}}$|\n(.*?)^{indent}\}})", text, re.M | re.S)
        if len(found) != 1:
            raise SystemExit(f"{owner} {name}: {len(found)} of them")
        kind, parameters, line, lines = found[0]
        return kind, parameters_of(parameters), line or lines


class Reader(Body):
    """Statements and expressions with objects."""

    def __init__(self, run, text, result=None, owner=None):
        super().__init__(run, text)
        self.result, self.owner = result, owner

    def call(self, text, scope, result=None, owner=None):
        """Runs a text in a scope of its own; the scope afterwards."""
        outer, self.run.scope = self.run.scope, {**self.run.source.constants, **scope}
        Reader(self.run, text, result, owner).block()
        inner, self.run.scope = self.run.scope, outer
        return inner

    def method(self, owner, name, fields, arguments):
        kind, parameters, text = self.run.shapes.function(owner, name)
        scope = {**fields, **dict(zip([n for n, _ in parameters], arguments, strict=True))}
        if owner:
            self.run.used[owner] = self.run.source.classes[owner]
        else:
            self.run.used[name] = text
        return self.call(text, scope, kind, (owner, fields))["return"]

    def constructed(self, kind, arguments):
        if kind not in KINDS:
            return super().constructed(kind, arguments)
        self.run.used[kind] = self.run.source.classes[kind]
        parameters, fields, text = self.run.shapes.constructor(kind, len(arguments))
        names = [n for n, _ in parameters_of(parameters)]
        scope = dict(zip(names, arguments, strict=True))
        made, reader = {}, Reader(self.run, fields)
        outer, self.run.scope = self.run.scope, {**self.run.source.constants, **scope}
        while reader.peek():
            name = reader.take()
            (value,) = reader.arguments()
            made[name] = dict(value) if isinstance(value, dict) else self.run.named(name, value)
            if reader.peek():
                reader.take(",")
        self.run.scope = outer
        inner = self.call(text, {**scope, **made})
        return {name: inner[name] for name in self.run.shapes.members(kind)}

    def statement(self):
        scope = self.run.scope
        if self.peek() in KINDS and self.peek(2) == "[":  # an array
            name = [self.take(), self.take()][1]
            scope[name] = self.array()
            self.take(";")
        elif self.peek() == "const" and self.peek(3) == "[":  # one with its elements
            self.take()
            name = [self.take(), self.take()][1]
            for token in ("[", "]", "="):
                self.take(token)
            scope[name] = self.elements()
            self.take(";")
        elif self.peek(1) == "[" and self.peek() in scope:  # one of its elements
            place, index = scope[self.take()], None
            while self.peek() == "[":
                place, index = place if index is None else place[index], self.index()
            self.take("=")
            place[index] = self.expression()
            self.take(";")
        elif self.peek() == "if":
            self.take()
            (condition,) = self.arguments()
            if not isinstance(condition, bool):
                raise SystemExit("a branch by what is not a constant")
            elif condition:
                self.statement()
            else:
                self.at = self.after(self.at)
        elif self.peek() == "break":
            raise Break
        elif self.peek() == "const" and self.peek(1) == "auto":
            for token in ("const", "auto"):
                self.take(token)
            name = self.take()
            for token in ("=", "[", "]", "("):
                self.take(token)
            parameters = self.until(")")
            self.take("{")
            self.run.scope[name] = Lambda(parameters_of(parameters), self.until("}"))
            self.take(";")
        else:
            super().statement()

    def index(self):
        self.take("[")
        value = self.expression()
        self.take("]")
        return value

    def elements(self):
        self.take("{")
        values = [self.expression()]
        while self.peek() == ",":
            self.take()
            values.append(self.expression())
        self.take("}")
        return values

    def array(self):
        """With elements that are not there yet."""
        counts, made = [], None
        while self.peek() == "[":
            counts.append(self.index())
        for count in reversed(counts):
            made = [copy.deepcopy(made) for _ in range(count)]
        return made

    def loop(self):
        outside = self.after(self.at)
        try:
            super().loop()
        except Break:
            self.at = outside

    def after(self, at):
        """Returns where a statement ends."""
        if self.tokens[at] == "for":
            return self.after(self.tokens.index(")", at) + 1)
        depth = 0
        while True:
            depth += (self.tokens[at] == "{") - (self.tokens[at] == "}")
            at += 1
            if depth == 0 and self.tokens[at - 1] in (";", "}"):
                return at

    def until(self, end):
        """The text before the next such token, which has to match the one taken."""
        depth, start = 1, self.at
        while depth:
            token = self.take()
            depth += (token in "({") - (token in ")}")
        if token != end:
            raise SystemExit(f"{end} expected")
        return " ".join(self.tokens[start:self.at - 1])

    def operation(self, operator, left, right):
        if isinstance(left, dict) and isinstance(right, dict):
            return self.method(self.run.points, f"operator{operator}", {}, [left, right])
        if isinstance(left, Term) and isinstance(right, Fraction):
            right = lane_text.number(right)
        if isinstance(left, Pointer) and isinstance(right, int) and operator == "+":
            return Pointer(left.offset + right)
        return Body.operation(operator, left, right)

    def of_name(self, name):
        if name in KINDS and self.peek() == "(":
            return self.constructed(name, self.arguments())
        if isinstance(self.run.scope.get(name), Lambda):
            return self.applied(self.run.scope[name])
        if name not in self.run.scope and self.peek() == "(":
            owner, fields = self.owner or (None, {})
            if owner and re.search(rf"\b{name}\(", self.run.source.classes[owner]):
                return self.method(owner, name, fields, self.arguments())
            return self.method(None, name, {}, self.arguments())
        return super().of_name(name)

    def applied(self, function):
        """A lambda; what it changes is a field here."""
        scope, changed = {}, []
        self.take("(")
        for name, is_changed in function.parameters:
            if is_changed:
                place = [self.take(), self.take("."), self.take()]
                changed.append((self.run.scope[place[0]], place[2], name))
            else:
                scope[name] = self.expression()
            self.take(")" if name == function.parameters[-1][0] else ",")
        inner = self.call(function.text, scope)
        for fields, field, name in changed:
            fields[field] = inner[name]
        return inner["return"]

    def made_of(self, fields):
        if self.result == "InSpace":
            return self.constructed("InSpace", fields)
        if self.result == "Vector3":
            return dict(zip("xyz", fields, strict=True))
        if self.result == "std::array<double, 9>" and len(fields) == 9:
            return fields
        if self.result not in FIELDS or len(fields) != 2:
            raise SystemExit(f"braces around what is no {self.result}")
        return dict(zip(FIELDS[self.result], Body.made_of(fields).values()))

    def member(self, value, name):
        if self.peek() == "(":
            return self.method("Certain", name, value, self.arguments())
        return super().member(value, name)

    @staticmethod
    def element(value, index):
        if isinstance(value, Pointer):
            return Term(f"c{value.offset + index}")
        if isinstance(value, list):
            return value[index]
        return Body.element(value, index)


def extracted(shapes, name, owner, function, arguments, dimensions=None):
    used = {}
    run = Run(shapes.source, dimensions, used)
    run.shapes, run.points = shapes, "InSpace"
    reader = Reader(run, "")
    if function:
        names = [f"n{i}" for i in range(arguments)]
        points = [f"p{axis}" for axis in "xyz"]
        run.taken.update([*names, *points])
        found = reader.method(None, function, {}, [list(map(Term, names)), list(map(Term, points))])
        result = f"({found['positive']}, {found['negative']})"
        names += points
    else:
        names = [f"c{i}" for i in range(arguments)]
        run.taken.update(names)
        used[owner] = shapes.source.classes[owner]
        counted = re.search(r"columns = ([\w +*]+);", used[owner])[1]
        if eval(counted, {}, {"dimensions": dimensions}) != arguments:  # of digits, names, + and *
            raise SystemExit(f"{owner}: other columns")
        kind, ((given, _),), text = shapes.function(owner, "of")
        scope = {given: Pointer(0), "all_lanes": Truth("true"), "dimensions": dimensions}
        found = reader.call(text, scope, kind)["return"]
        result = f"({found['known']}, {found['set']})"
    lines = [f"Definition {name} (fused : bool) ({' '.join(names)} : float) : bool * bool :=", *run.lets,
             f"  {result}."]
    return "\n".join(lines), [used[k] for k in sorted(used)]


def plane_numbers(shapes):
    """The numbers of a face, from its corners and the side that is outside."""
    used = {}
    run = Run(shapes.source, None, used)
    run.shapes, run.points = shapes, None  # of geometry/space.h
    names = [f"{point}{axis}".replace("by", "by_") for point in "abc" for axis in "xyz"]
    run.taken.update([*names, "outside"])
    points = [dict(zip("xyz", map(Term, names[i:i + 3]))) for i in range(0, 9, 3)]
    found = Reader(run, "").method(None, "plane_numbers", {}, [*points, Term("outside")])
    lines = [f"Definition lane_plane_numbers ({' '.join(names)} outside : float) :=", *run.lets,
             f"  ({', '.join(found)})."]
    return "\n".join(lines) + "\n", [used[k] for k in sorted(used)]


def all_of(root):
    """As lane_text.all_of."""
    shapes, found = Shapes(Source(root), root), []
    shared = [str(sorted(shapes.source.constants.items())), lane_text.text_of_lanes(root)]
    for row in FILTERS:
        definition, parts = extracted(shapes, *row)
        if not row[1]:
            numbers, texts = plane_numbers(shapes)
            definition, parts = numbers + definition, texts + parts
        found.append((row[0], definition, [*parts, *shared]))
    return HEAD + "\n".join(d for _, d, _ in found) + "\n", found
