# SPDX-License-Identifier: Apache-2.0
"""The filters of robust/batch/isa as Coq functions: what their C++ text computes in one lane, operation by operation.

A class of kernels.h is run on names instead of numbers: its `of` becomes one function of the columns, or its
constructor one of the numbers that it is given. Text that this does not understand is an error, never left out. See
extract.py.
"""
import re
from fractions import Fraction

from tokens import Tokens

HEADERS = [f"robust/batch/isa/{name}.h" for name in ("kernels", "vectors", "beside")]
# What the functions of lanes.v are; their text is reviewed with each filter.
LANES = ["robust/batch/isa/lanes.h",
         *(f"robust/batch/isa/lanes/{name}.h" for name in ("lanes", "avx512", "avx2", "sse2", "neon", "one"))]
HEAD = """(* Written by extract.py from robust/batch/isa. *)
From Coq Require Import Reals ZArith Bool.
From Filters Require Import floats lanes.

"""
# Definition, class, its dimensions.
FILTERS = [("lane_turn", "Turn", None), ("lane_orientation", "Orientation", None),
           ("lane_point_on_segment", "PointOnSegment", None), ("lane_segment_segment", "SegmentSegment", None),
           ("lane_point_plane", "PointPlane", None), ("lane_spheres_2", "Spheres", 2), ("lane_spheres_3", "Spheres", 3),
           ("lane_turn_seen", "TurnSeen", None), ("lane_boxes_2", "Boxes", 2), ("lane_boxes_3", "Boxes", 3),
           ("lane_sphere_box_2", "SphereBox", 2), ("lane_sphere_box_3", "SphereBox", 3)]
NAMES = {name for name, _, _ in FILTERS}
FUNCTIONS = {"magnitude": "size", "__builtin_fabs": "size", "multiply_add": "multiply_add fused", "above": "above",
             "not_below": "not_below", "equal": "equal", "negative": "negative_lane", "lesser": "lesser",
             "greater": "greater_of"}
RESERVED = {*FUNCTIONS.values(), "plus", "minus", "times", "number", "fused", "v", "end", "at", "in"}
TRUTHS = {"above", "not_below", "equal", "negative"}
OPERATORS = {"+": "plus", "-": "minus", "*": "times"}
TOKEN = re.compile(r"\s*(0x[0-9a-f.]+p-?\d+|\d+|[A-Za-z_]\w*(?:::\w+)*"
                   r"|\+=|&=|\|=|\^=|==|&&|\+\+|[-+*/%(){}\[\],;<>=&|?:.~^])")


def text_of_lanes(root):
    return "".join((root / name).read_text(encoding="utf-8") for name in LANES)


class Term(str):
    """A number of a lane."""


class Truth(str):
    """A bit of a lane."""


def number(value):
    """A constant, as same() gives it to all lanes."""
    mantissa, exponent = Fraction(value), 0
    while mantissa.denominator > 1:
        mantissa, exponent = mantissa * 2, exponent - 1
    mantissa = mantissa.numerator
    while mantissa and mantissa % 2 == 0:
        mantissa, exponent = mantissa // 2, exponent + 1
    mantissa = mantissa if mantissa >= 0 else f"({mantissa})"
    return Term(f"(number {mantissa} {exponent if exponent >= 0 else f'({exponent})'})")


class Source:
    def __init__(self, root, headers=HEADERS):
        self.classes, self.constants = {}, {}
        for name in headers:
            text = re.sub(r"//.*", "", (root / name).read_text(encoding="utf-8"))
            for kind, body in re.findall(r"^(?:struct|class) (\w+)[^;{]*\{\n(.*?)^\};", text, re.M | re.S):
                self.classes[kind] = body
            for found in re.findall(r"^constexpr double (.*?);", text, re.M | re.S):
                for each in found.split(","):
                    constant, value = each.split("=")
                    self.constants[constant.strip()] = Fraction(float.fromhex(value.strip()))

    def function(self, owner, name):
        """Parameters and body of a constructor or of a static function."""
        head = rf"^  (?:explicit )?{owner}" if name == owner else rf"^  static Verdict {name}"
        found = re.search(head + r"\(([^)]*)\) \{\n(.*?)^  \}", self.classes[owner], re.M | re.S)
        if not found:
            raise SystemExit(f"{owner}: no {name}")
        return found[1], found[2]


class Run:
    """A function, on names."""

    def __init__(self, source, dimensions, used):
        self.source, self.used, self.taken, self.lets = source, used, set(RESERVED), []
        self.scope = dict(source.constants)
        if dimensions:
            self.scope["dimensions"] = dimensions
        self.scope["all_lanes"] = Truth("true")

    def named(self, wish, value):
        """A number or bit under a name of its own."""
        if not isinstance(value, (Term, Truth)) or re.fullmatch(r"\w+", value):
            return value
        name, i = wish, 1
        while name in self.taken:
            name, i = f"{wish}{i}", i + 1
        self.taken.add(name)
        self.lets.append(f"  let {name} := {value[1:-1] if value.startswith('(') else value} in")
        return type(value)(name)

    def body(self, text):
        Body(self, text).block()
        return self


class Body(Tokens):
    """Statements and expressions of one text."""

    def __init__(self, run, text):
        super().__init__(TOKEN, text)
        self.run = run

    def block(self, end=None):
        while self.peek() != end:
            self.statement()

    def statement(self):
        scope = self.run.scope
        if self.peek() == "{":
            self.take()
            self.block("}")
            self.take("}")
        elif self.peek() == "for":
            self.loop()
        elif self.peek() == "return":
            self.take()
            scope["return"] = self.expression()
            self.take(";")
        elif self.peek() == "constexpr":
            self.take()
            self.take("std::size_t")
            name = self.take()
            self.take("=")
            scope[name] = self.expression()
            self.take(";")
        elif self.peek() in ("const", "Lanes", "Mask", "Verdict"):
            if self.peek() == "const":
                self.take()
            kind = self.take()
            while True:
                if self.peek() == "&":
                    self.take()
                name = self.take()
                if self.peek() == "(":  # a constructor
                    scope[name] = self.constructed(kind, self.arguments())
                else:
                    self.take("=")
                    value = self.expression()
                    value = Truth("false") if kind == "Mask" and value == 0 else value
                    scope[name] = self.run.named(name, value) if not isinstance(value, dict) else dict(value)
                if self.take() == ";":
                    return
        else:  # an assignment
            path = [self.take()]
            while self.peek() == ".":
                self.take()
                path.append(self.take())
            operator = self.take()
            value = self.expression()
            self.take(";")
            target = scope if len(path) == 1 else scope[path[0]]
            if operator in ("&=", "|="):
                value = Truth(f"({target[path[-1]]} {operator[0] * 2} {value})")
            elif operator != "=":
                raise SystemExit(f"assignment not understood: {operator}")
            target[path[-1]] = self.run.named(path[-1], value)

    def loop(self):
        head = " ".join(self.tokens[self.at:self.at + 14])
        found = re.fullmatch(r"for \( std::size_t (\w+) = 0 ; \1 < (\w+) ; \+\+ \1 \)", head)
        if not found:
            raise SystemExit(f"loop not understood: {head}")
        start = self.at = self.at + 14
        for i in range(int(found[2]) if found[2].isdigit() else self.run.scope[found[2]]):
            self.at = start
            self.run.scope[found[1]] = i
            self.statement()

    def constructed(self, kind, arguments):
        parameters, text = self.run.source.function(kind, kind)
        self.run.used[kind] = self.run.source.classes[kind]
        outer = self.run.scope
        self.run.scope = {**self.run.source.constants, **dict(zip(names_of(parameters), arguments))}
        self.run.body(text)
        made, self.run.scope = self.run.scope, outer
        return {k: x for k, x in made.items() if k not in self.run.source.constants}

    def expression(self, level=0):
        levels = [("?",), ("&&",), ("|",), ("^",), ("&",), ("==",), ("+", "-"), ("*", "%")]
        if level == len(levels):
            return self.unary()
        left = self.expression(level + 1)
        while self.peek() in levels[level]:
            operator = self.take()
            if operator == "?":
                yes = self.expression()
                self.take(":")
                no = self.expression()
                if not isinstance(left, bool):
                    raise SystemExit("a choice by what is not a constant")
                return yes if left else no
            left = self.operation(operator, left, self.expression(level + 1))
        return left

    @staticmethod
    def operation(operator, left, right):
        if isinstance(left, Truth) and isinstance(right, Truth) and operator in "|&":
            return Truth(f"({left} {operator * 2} {right})")
        if isinstance(left, Term) and isinstance(right, Term) and operator in OPERATORS:
            return Term(f"({OPERATORS[operator]} {left} {right})")
        if isinstance(left, (int, Fraction)) and isinstance(right, (int, Fraction)):
            if operator in ("==", "&&", "%"):
                return left == right if operator == "==" else left and right if operator == "&&" else left % right
            return left + right if operator == "+" else left - right if operator == "-" else left * right
        raise SystemExit(f"not understood: {left!r} {operator} {right!r}")

    def unary(self):
        token = self.take()
        if token == "(":
            value = self.expression()
            self.take(")")
        elif token == "{":
            fields = []
            while self.peek() != "}":
                fields.append(self.expression())
                if self.peek() == ",":
                    self.take()
            self.take("}")
            value = self.made_of(fields)
        elif token == "~":
            value = Truth(f"(negb {self.unary()})")
        elif token.startswith("0x"):
            value = Fraction(float.fromhex(token))
        elif token.isdigit():
            value = int(token)
        elif token == "same":
            (value,) = self.arguments()
            value = value if isinstance(value, Term) else number(value)
        elif token == "by_sign":
            value, bound = self.arguments()
            value = self.run.named("value", value)
            bound = self.run.named("bound", bound)
            value = {"known": Truth(f"(above (size {value}) {bound})"), "set": Truth(f"(negative_lane {value})")}
        elif token in FUNCTIONS and self.peek() == "(":
            kind = Truth if token in TRUTHS else Term
            value = kind(f"({FUNCTIONS[token]} {' '.join(self.arguments())})")
        else:
            value = self.of_name(token)
        while self.peek() in (".", "["):
            if self.take() == ".":
                value = self.member(value, self.take())
            else:
                index = self.expression()
                self.take("]")
                value = self.element(value, index)
        return value

    def of_name(self, name):
        if name not in self.run.scope:
            raise SystemExit(f"unknown name {name!r}")
        return self.run.scope[name]

    @staticmethod
    def made_of(fields):
        if len(fields) != 2:
            raise SystemExit("braces around what is no verdict")
        fields = [Truth("false") if x == 0 and not isinstance(x, str) else x for x in fields]
        return dict(zip(("known", "set"), fields))

    def member(self, value, name):
        return value[name]

    @staticmethod
    def element(value, index):
        return Term(f"{value}{index}")


def names_of(parameters):
    return [p.split()[-1].lstrip("*&") for p in parameters.split(",")]


BY_SIGN = "Verdict by_sign(Lanes value, Lanes bound) { return {above(magnitude(value), bound), negative(value)}; }"


def extracted(source, name, owner, dimensions):
    used = {owner: source.classes[owner]}
    run = Run(source, dimensions, used)
    if "static Verdict of" in source.classes[owner]:
        counted = re.search(r"columns = ([\w +*]+);", source.classes[owner])[1]
        count = eval(counted, {}, {"dimensions": dimensions})  # of digits, names, + and *
        parameters, text = source.function(owner, "of")
        names = [f"c{i}" for i in range(count)]
        run.scope["c"] = "c"
        run.taken.update(names)
        found = run.body(text).scope["return"]
        result = ("bool * bool", f"({found['known']}, {found['set']})")
    else:
        parameters, text = source.function(owner, owner)
        names = names_of(parameters)
        run.taken.update(names)
        run.scope.update({n: Term(n) for n in names})
        made = run.body(text).scope
        result = ("float * float", f"({made['value']}, {made['bound']})")
    lines = [f"Definition {name} (fused : bool) ({' '.join(names)} : float) : {result[0]} :=", *run.lets,
             f"  {result[1]}."]
    return "\n".join(lines), [used[k] for k in sorted(used)]


def all_of(root):
    """The file of definitions, and for each its name, its definition and the text that it came from."""
    source, found = Source(root), []
    operations = text_of_lanes(root)
    if BY_SIGN not in (root / HEADERS[0]).read_text(encoding="utf-8"):
        raise SystemExit("kernels.h: by_sign is another")
    for name, owner, dimensions in FILTERS:
        definition, parts = extracted(source, name, owner, dimensions)
        found.append((name, definition, [*parts, str(sorted(source.constants.items())), operations]))
    return HEAD + "\n".join(d for _, d, _ in found) + "\n", found
