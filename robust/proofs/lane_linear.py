# SPDX-License-Identifier: Apache-2.0
"""The linear functions of linear_numbers.h and linear.h, as Coq functions: their numbers, their values, what a filter
keeps of them from one edge or face to the next, and what it answers. See lane_shapes.py.

Not read are the order in which numbers stand in memory and what SignBits does, which the text of both headers says. It
is reviewed with each filter.
"""
import re

import lane_text
from lane_shapes import Reader, Shapes
from lane_text import Run, Source, Term, Truth

HEADERS = [f"robust/batch/{name}.h" for name in ("isa/linear", "shapes/linear_numbers", "isa/solid", "isa/filters")]
INFINITY = "std::numeric_limits<double>::infinity()"
FUNCTIONS = {"std::min": "lesser", "std::max": "greater_of"}  # of the second and the first


class Row:
    """A pointer to the numbers of an edge or a face. A step leads to those of the next one, and only then are numbers
    that were `left` behind read.
    """

    def __init__(self, numbers, left=False):
        self.numbers, self.left = numbers, left

    def step(self, stride):
        if stride != len(self.numbers):
            raise SystemExit(f"a step of {stride}")
        self.left = not self.left

    def __add__(self, offset):
        return Row(self.numbers[offset:], self.left)

    def __getitem__(self, index):
        if self.left:
            raise SystemExit("the numbers of another edge or face")
        return self.numbers[index]


class Linear(Shapes):
    """The text of both headers too."""

    def __init__(self, root):
        source = Source(root)
        super().__init__(source, root)
        self.counts = {}
        for name in HEADERS:
            text = re.sub(r"//.*|^inline ", "", (root / name).read_text(encoding="utf-8"), flags=re.M)
            text = text.replace("linear<2>", "linear_in_plane").replace(INFINITY, "infinity")
            text = re.sub(r"<dimensions>|<[23]>", "", text)
            self.text += text
            for kind, body in re.findall(r"^(?:struct|class) (\w+)[^;{]*\{\n(.*?)^\};", text, re.M | re.S):
                source.classes[kind] = body
            for constants in re.findall(r"^constexpr std::size_t (of_.*?);", text, re.M | re.S):
                for constant in constants.split(","):
                    name, value = constant.split("=")
                    if "dimensions" not in value:
                        self.counts[name.strip()] = eval(value, {}, self.counts)  # of digits, names, + and *
        self.text = self.text.replace("<dimensions>", "")


class Lines(Reader):
    """Statements and expressions with them."""

    def call(self, text, scope, result=None, owner=None):
        outer, self.run.scope = self.run.scope, {**self.run.source.constants, **self.run.given, **scope}
        Lines(self.run, text, result, owner).block()
        inner, self.run.scope = self.run.scope, outer
        return inner

    def statement(self):
        if self.peek() == "SignBits":
            self.tokens.insert(self.at, "const")
        if self.peek() == "if" and self.tokens[self.at + 4:self.at + 8] == ["0", ")", "continue", ";"]:
            self.run.skipped = self.run.scope[self.peek(2)], dict(self.run.scope)  # only where it is so in all lanes
            self.at += 8
        elif re.fullmatch(r"\w+", self.peek()) and self.peek(1) in ("=", "^="):  # one or more assignments
            while True:
                name, operator = self.take(), self.take()
                value = self.expression()
                value = value if operator == "=" else self.operation("^", self.run.scope[name], value)
                self.run.scope[name] = self.run.named(name, value)
                if self.take() == ";":
                    return
        elif isinstance(self.run.scope.get(self.peek()), Row):
            self.expression()
            self.take(";")
        else:
            super().statement()

    def constructed(self, kind, arguments):
        if kind != "SignBits":
            return super().constructed(kind, arguments)
        return self.run.named("bits", Truth(f"(negative_lane {arguments[0]})"))

    def of_name(self, name):
        if name == "SignBits":
            return self.constructed(name, self.arguments())
        if name in ("linear", "finite"):
            return self.method(None, name, {}, self.arguments())
        if name == "linear_in_plane":
            return Definition.linear(self, 2, *self.arguments())
        if name == "beside":
            return self.method("Solid", name, {}, self.arguments())
        return super().of_name(name)

    def loop(self):
        head = " ".join(self.tokens[self.at:self.at + 14])
        found = re.fullmatch(r"for \( std::size_t (\w+) = (\w+) ; \1 - - > 0 ; \)", head)
        if not found:
            super().loop()
            return
        start = self.at = self.at + 14
        for i in reversed(range(self.run.scope[found[2]])):
            self.at = start
            self.run.scope[found[1]] = i
            self.statement()

    def operation(self, operator, left, right):
        if operator == "^":
            return Truth(f"(xorb {left} {right})")
        if operator == "+" and isinstance(left, (Row, list)):
            return left + right if isinstance(left, Row) else left[right:]
        if isinstance(left, Term) or isinstance(right, Term):
            left, right = (x if isinstance(x, Term) else lane_text.number(x) for x in (left, right))
        return super().operation(operator, left, right)

    def unary(self):
        if self.peek() == "-":
            self.take()
            return Term(f"(negated {self.unary()})")
        if self.peek() in FUNCTIONS:
            name, (x, y) = FUNCTIONS[self.take()], self.arguments()
            return Term(f"({name} {y} {x})")
        if isinstance(self.run.scope.get(self.peek()), Row) and self.peek(1) == "+=":
            row = self.run.scope[self.take()]
            self.take("+=")
            row.step(self.expression())
            return row
        return super().unary()

    def made_of(self, fields):
        if self.result and self.result.startswith("std::array<double"):
            return fields
        if self.result == "Located" and len(fields) == 3 and fields[2] == 0:
            return dict(zip(("known", "outside"), fields))
        return super().made_of(fields)

    @staticmethod
    def element(value, index):
        return value[index]

    def member(self, value, name):
        if isinstance(value, Truth) and name == "set":
            self.arguments()
            return value
        if isinstance(value, dict) and "beyond" in value and self.peek() == "(":
            return self.method("Framed", name, value, self.arguments())
        return super().member(value, name)


def names_of(prefix, count):
    return [f"{prefix}{i}" for i in range(count)]


class Definition:
    """One function of Coq, of those numbers and bits of these names that it reads."""

    def __init__(self, shapes, name, names, dimensions, bits=()):
        self.name, self.names, self.bits, self.used = f"lane_{name}", names, bits, {}
        self.run = Run(shapes.source, None, self.used)
        self.run.shapes, self.run.points, self.run.skipped = shapes, None, None
        self.run.given = {**shapes.counts, "dimensions": dimensions, "all_lanes": Truth("true"),
                          "infinity": Term("infinity")}
        self.run.taken.update([*names, *bits])
        self.reader = Lines(self.run, "")

    @staticmethod
    def terms(names):
        return list(map(Term, names))

    def function(self, name, *arguments):
        return self.reader.method(None, name, {}, list(arguments))

    @staticmethod
    def linear(reader, dimensions, numbers, d):
        outer = reader.run.given
        reader.run.given = {**outer, "dimensions": dimensions}
        value = reader.method(None, "linear", {}, [numbers, d])
        reader.run.given = outer
        return value

    def framed(self, frame, p):
        """The constructor: the error, the displacement, and whether a point is beyond the box."""
        parameters, fields, text = self.run.shapes.constructor("Framed", 2)
        body = self.run.shapes.source.classes["Framed"]
        if fields != "error(same(frame[2 * dimensions]))" or "\n  Mask beyond = 0;\n" not in body:
            raise SystemExit(f"Framed: {fields}")
        dimensions = self.run.given["dimensions"]
        return self.reader.call(text, {"frame": frame, "p": p, "beyond": Truth("false"), "d": [None] * dimensions})

    def text(self, result, kind=""):
        read = set(re.findall(r"\w+", " ".join([*self.run.lets, result])))
        lines = [f"Definition {self.name}"]
        for names, of in ((["fused"], "bool"), (self.names, "float"), (self.bits, "bool")):
            names = [n for n in names if n in read]
            lines[0] += f" ({' '.join(names)} : {of})" if names else ""
        return "\n".join([f"{lines[0]}{kind} :=", *self.run.lets, f"  {result}."]), self.used


def tuple_of(values):
    return f"({', '.join(values)})" if len(values) > 1 else str(values[0])


def kind_of(state):
    return " : " + " * ".join("bool" if of is Truth else "float" for of in state.values())


def pieces(shapes, dimensions):
    """The box, the numbers of a function, its value, a point's displacement, the size and the error."""
    least, most, p = (names_of(x, dimensions) for x in "ogp")
    n, d = names_of("n", dimensions + 1), names_of("d", dimensions)

    def define(name, names):
        return Definition(shapes, name, names, dimensions)

    one = define(f"box_add_{dimensions}", [*least, *most, *p])
    box = one.reader.call(shapes.function("LeastBox", "add")[2],
                          {"least": one.terms(least), "most": one.terms(most), "point": one.terms(p)})
    yield one.text(tuple_of([*box["least"], *box["most"]]))
    one = define(f"linear_{dimensions}", [*n, *d])
    yield one.text(one.function("linear", one.terms(n), one.terms(d)), " : float")
    one = define(f"framed_{dimensions}", [*least, *most, *p])
    made = one.framed(one.terms([*least, *most, "error"]), one.terms(p))
    yield one.text(tuple_of([made["beyond"], *made["d"]]))
    if dimensions == 2:
        one = define("size_of_lines", [*least, *most])
        box = {"least": one.terms(least), "most": one.terms(most)}
        yield one.text(one.reader.method("LeastBox", "size_of_lines", box, [0]), " : float")
        a, b = names_of("a", 2), names_of("b", 2)
        one = define("line_numbers", [*a, *b, *least])
        yield one.text(tuple_of(one.function("line_numbers", *map(one.terms, (a, b, least)))))
        one = define("error_of_linear", ["s"])
        yield one.text(one.function("error_of_linear", Term("s")), " : float")
    else:
        t, a, n = names_of("t", 3), names_of("a", 3), names_of("n", 3)
        one = define("size_of_plane", [*t, *least, *most])
        box = {"least": one.terms(least), "most": one.terms(most)}
        yield one.text(one.reader.method("LeastBox", "size_of_plane", box, [one.terms(t)]), " : float")
        one = define("plane_function", [*a, *n, *least])
        yield one.text(tuple_of(one.function("plane_function", *map(one.terms, (a, n, least)))))
        one = define("greater_size", ["s", "t"])
        yield one.text(one.function("greater_size", Term("s"), Term("t")), " : float")


# Definition, class, dimensions, pointers with their names and counts of numbers; texts as names of numbers.
FOLDS = [
    ("lane_convex_ring", "ConvexRingByLines", 2, {"line": ("n", "of_line")}, {}),
    ("lane_convex_solid", "ConvexSolidByPlanes", 3, {"plane": ("n", "of_plane")}, {}),
    ("lane_ring", "RingByLines", 2, {"line": ("n", "of_line")},
     {"shared.numbers[vertices - 1]": "last_y", "shared.numbers[2 * vertex + 1]": "end_y"}),
    ("lane_solid", "SolidByPlanes", 3, {"face": ("c", "of_boxed_face"), "functions": ("n", "3 * of_line + of_plane")},
     {"functions[of_frame]": "error_of_turns"}),
]
LAYOUT = re.compile(
    r"^    (?:const std::size_t vertices|const Framed point\(|const double\* \w+ =|functions \+=).*?;\n", re.M)
LOOP = re.compile(r"^    for \(std::size_t \w+ = ([01]); \w+ < shared\.count; \+\+\w+((?:, \w+ \+= [^;,]*?)*)\) "
                  r"(?:\{\n(.*?)^    \}|([^\n]*))\n", re.M | re.S)
NAMES = {"lane_line", "lane_plane"} | {name for name, *_ in FOLDS}


def fold(shapes, name, owner, dimensions, pointers, other):
    """The start of a filter, its step from one edge or face to the next, and its answer."""
    kind, parameters, text = shapes.function(owner, "filtered")
    for before, after in other.items():
        if text.count(before) != 1:
            raise SystemExit(f"{owner}: {before}")
        text = text.replace(before, after)
    (loop,) = LOOP.finditer(text)
    head, tail = LAYOUT.sub("", text[:loop.start()]), text[loop.end():]
    d, p = names_of("d", dimensions), names_of("p", dimensions)
    rows = {x: names_of(letter, eval(count, {}, shapes.counts)) for x, (letter, count) in pointers.items()}
    after_one, steps, body = loop[1] == "1", loop[2], loop[3] or loop[4]
    state = None

    def define(part, left):
        names = [*(state or {}), *sum(rows.values(), []), *d, "error", *p, *other.values()]
        bits = [x for x, of in (state or {}).items() if of is Truth]
        one = Definition(shapes, f"{name[5:]}_{part}", [x for x in names if x not in bits], dimensions,
                         [*bits, "beyond"])
        point = {"error": Term("error"), "d": one.terms(d), "beyond": Truth("beyond")}
        given = {x: of(x) for x, of in (state or {}).items()}
        return one, {**given, "point": point, "p": one.terms(p), **{x: Term(x) for x in other.values()},
                     **{x: Row(one.terms(row), left) for x, row in rows.items()}}

    one, scope = define("first", False)
    after = one.reader.call(head, scope, kind, (owner, {}))
    state = {x: type(v) for x, v in after.items() if isinstance(v, (Term, Truth)) and x not in scope
             and x not in one.run.given and x not in shapes.source.constants}
    yield one.text(tuple_of([after[x] for x in state]), kind_of(state))
    one, scope = define("next", after_one)
    text = body + "".join(f"{step};\n" for step in steps.split(", ")[1:])
    after = one.reader.call(text, scope, kind, (owner, {}))
    if any(scope[x].left == after_one for x in rows):
        raise SystemExit(f"{owner}: the steps from one edge or face to the next")
    result = tuple_of([after[x] for x in state])
    if one.run.skipped:
        bit, before = one.run.skipped
        one.bits = [*one.bits, "others"]
        result = f"if others || {bit} then {result} else {tuple_of([before[x] for x in state])}"
    yield one.text(result, kind_of(state))
    one, scope = define("answer", True)
    found = one.reader.call(tail, scope, kind, (owner, {}))["return"]
    yield one.text(f"({found['known']}, {found['outside']})", " : bool * bool")


def all_of(root):
    """As lane_text.all_of."""
    shapes, found = Linear(root), []
    shared = [lane_text.text_of_lanes(root), str(sorted(shapes.counts.items()))] + [
        re.sub("//.*", "", (root / name).read_text(encoding="utf-8")) for name in HEADERS[:2]]
    parts = [("lane_line", pieces(shapes, 2)), ("lane_plane", pieces(shapes, 3))]
    for name, definitions in parts + [(name, fold(shapes, name, *row)) for name, *row in FOLDS]:
        texts, used = zip(*definitions)
        used = {k: text for each in used for k, text in each.items()}
        found.append((name, "\n".join(texts), [*(used[k] for k in sorted(used)), *shared]))
    return lane_text.HEAD + "\n".join(d for _, d, _ in found) + "\n", found
