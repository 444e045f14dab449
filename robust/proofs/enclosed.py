# SPDX-License-Identifier: Apache-2.0
"""robust/kernel/enclosed/enclosed.h and push.h as Coq definitions: each function from its own text, operation by operation, a
call of another function by that one's definition. Text that this does not understand is an error. See extract.py."""
import re
from fractions import Fraction

from enclosed_text import HEADERS, Kernel, coq, field_name  # HEADERS: for others

HEAD = """(* Written by extract.py from robust/kernel/enclosed/enclosed.h, push.h, float_format.h and window.h. *)
From Coq Require Import Reals ZArith Bool.
From Filters Require Import arithmetic.
Open Scope R_scope.

"""
# Definition: function or class and method, kinds of its parameters.
NAMES = {
    "two_sum": ("two_sum", "Float Float"), "difference": ("difference", "Float Float"),
    "factor_of_pair": ("factor", "Pair"), "factor_of_number": ("factor", "Float"),
    "negated_term": ("Term2.operator-", "Term2"), "product": ("product", "Factor Factor"),
    "settled": ("Enclosed.settled", ""), "sum_first": ("Sum.this", "Term2"), "sum_plus": ("Sum.operator+=", "Term2"),
    "sum_minus": ("Sum.operator-=", "Term2"), "sum_plus_number": ("Sum.operator+=", "Float"),
    "sum_value": ("Sum.value", ""), "add": ("operator+", "Enclosed Enclosed"), "negate": ("operator-", "Enclosed"),
    "subtract": ("operator-", "Enclosed Enclosed"), "factor_of_enclosed": ("factor", "Enclosed"),
    "multiply": ("operator*", "Enclosed Enclosed"), "in_order": ("in_order", "Enclosed"),
    "times": ("times", "Enclosed Enclosed"), "along_factor": ("along", "Float Factor Float Factor"),
    "along": ("along", "Float Enclosed Factor"), "divisor_of": ("Divisor.this", "Enclosed"),
    "divide": ("operator/", "Enclosed Divisor"), "square_root": ("square_root", "Enclosed"),
    "rounded": ("rounded", "Enclosed"), "share_of_number": ("share", "Float"),
    "push": ("along", "Float Share Factor"), "enclosed_push": ("enclosed_push", "Float Share Factor"),
}
# Each of these has a theorem about these definitions. The others are parts of these.
PROVED = {name: [name] for name in "two_sum difference add subtract multiply in_order times along rounded".split()} | {
    "product": ["factor_of_pair", "factor_of_number", "product"], "divide": ["divisor_of", "divide"],
    "sum": ["sum_first", "sum_plus", "sum_minus", "sum_plus_number", "sum_value"],
    "square_root": ["settled", "square_root"], "enclosed_push": ["share_of_number", "push", "enclosed_push"]}
THEOREMS = {*PROVED, "window"}
OPERATIONS = {"+": "added", "-": "subtracted", "*": "multiplied", "/": "divided"}
TOKEN = re.compile(r"\s*(?:(\d+\.\d+|\d+)|((?:[A-Za-z_]\w*)(?:::\w+)*)|(\+=|-=|<=|>=|[-+*/(){},;!=.]))")


class Value:
    """A Coq term of that kind: Float, int, real (a constant), bool, or a struct's name."""

    def __init__(self, text, kind):
        self.text, self.kind = text, kind


class Definition:
    """One function, run on names."""

    def __init__(self, kernel, name):
        self.kernel, self.name, key = kernel, name, NAMES[name]
        owner, self.result, parameters, body, whole = kernel.functions[key]
        self.used, self.owner, self.steps, self.taken = {name}, owner, [], {"result", "at", "in", "end"}
        self.whole, self.parameters, self.scope = whole, [], {}
        if owner and self.result and (key[0], key[1]) != (f"{owner}.operator-", owner):
            this = self.parameter("this", owner)
            self.scope["*this"] = this
            for field, kind in kernel.structs[owner]:
                self.scope[field] = Value(f"({field_name(owner, field)} {this.text})", kind)
        for kind, wish in parameters:
            self.scope[wish] = self.parameter(wish, kind)
        self.changed = False
        self.tokens, at = [], 0
        body = body.rstrip()
        while at < len(body):
            found = TOKEN.match(body, at)
            if not found:
                raise SystemExit(f"{name}: not understood: {body[at:at + 40]!r}")
            self.tokens.append(found[1] or found[2] or found[3])
            at = found.end()
        self.at = 0
        self.answer = self.statements()

    def parameter(self, wish, kind):
        name = self.fresh(wish)
        self.parameters.append((name, kind))
        return Value(name, kind)

    def fresh(self, wish):
        name, i = wish, 1
        while name in self.taken:
            name, i = f"{wish}{i}", i + 1
        self.taken.add(name)
        return name

    def text(self):
        kinds = {"": self.owner}.get(self.result, self.result).rstrip("&")
        given = "".join(f" ({name} : {coq(kind)})" for name, kind in self.parameters)
        lines = [f"Definition {self.name}{given} (result : {coq(kinds)}) : Prop :="]
        lines += [f"  exists {name}, {said} /\\" for name, said in self.steps]
        return "\n".join(lines + [f"  result = {self.answer}."])

    # operations
    def step(self, said, kind, wish="t"):
        name = self.fresh(wish)
        self.steps.append((name, f"{said} {name}"))
        return Value(name, kind)

    def number(self, value):
        if value.kind != "Float":
            raise SystemExit(f"{self.name}: not a number: {value.text}")
        return value.text

    def operation(self, operator, x, y):
        kinds = {x.kind, y.kind}
        if kinds == {"Float"}:
            return self.step(f"{OPERATIONS[operator]} round {x.text} {y.text}", "Float")
        if kinds <= {"int"}:
            return Value(f"({x.text} {operator} {y.text})%Z", "int")
        if kinds <= {"int", "real"}:
            return Value(f"({real(x)} {operator} {real(y)})", "real")
        return self.call(f"operator{operator}", [x, y])

    def call(self, name, values):
        kinds = " ".join(v.kind for v in values)
        short = name.removeprefix("Format::")
        if short != name:
            (x,) = values
            if short == "above":
                return Value(f"(Plain {real(x)})", "Float")
            if short in ("magnitude", "head"):
                return Value(f"({short} {'' if short == 'magnitude' else 'kept '}{self.number(x)})", "Float")
            if short == "square_root":
                return self.step(f"rooted round {self.number(x)}", "Float")
        if name == "Float" and not values:
            return Value("(Plain 0)", "Float")
        if name in self.kernel.structs:
            name += ".this"
        for definition, key in NAMES.items():
            if key == (name, kinds) or (name == "operator-" and key == (f"{kinds}.operator-", kinds)):
                return self.by(definition, values, self.kernel.functions[key])
        raise SystemExit(f"{self.name}: no function {name} of {kinds}")

    def by(self, definition, values, function):
        self.used.add(definition)
        kind = {"": function[0]}.get(function[1], function[1]).rstrip("&")
        return self.step(" ".join([definition] + [v.text for v in values]), kind)

    # statements
    def peek(self, ahead=0):
        return self.tokens[self.at + ahead] if self.at + ahead < len(self.tokens) else None

    def take(self, token=None):
        found = self.peek()
        if token is not None and found != token:
            raise SystemExit(f"{self.name}: {token!r} expected at {' '.join(self.tokens[self.at - 5:self.at + 5])}")
        self.at += 1
        return found

    def this(self):
        fields = self.kernel.structs[self.owner]
        return self.record(self.owner, [self.scope[field] for field, _ in fields])

    def record(self, struct, values):
        fields = self.kernel.structs[struct]
        if [v.kind for v in values] != [kind for _, kind in fields]:
            raise SystemExit(f"{self.name}: {[v.kind for v in values]} for {struct}")
        return Value(f"({struct} {' '.join(v.text for v in values)})", struct)

    def statements(self):
        """Runs the statements up to the end and returns their value."""
        while True:
            token = self.peek()
            if token is None:
                if self.result:
                    raise SystemExit(f"{self.name}: nothing is returned")
                return self.this().text
            if token == "using":
                while self.take() != ";":
                    pass
            elif token == "if":
                self.take(), self.take("(")
                condition = self.expression()
                self.take(")"), self.take("return")
                then = self.returned()
                return f"if {condition.text} then {then} else {self.statements()}"
            elif token == "return":
                self.take()
                answer = self.returned()
                if self.peek() is not None:
                    raise SystemExit(f"{self.name}: more than one return")
                return answer
            else:
                self.statement()

    def returned(self):
        if self.peek() == "{":
            value = self.record(self.result, self.braces())
        elif self.peek() == "std::nullopt":
            self.take()
            value = Value("None", "option")
        elif self.peek() == "*" and self.peek(1) == "this" and self.peek(2) == ";":
            self.at += 2
            value = self.this()
        else:
            value = self.expression()
        self.take(";")
        if self.result == "std::optional" and value.kind == "Float":
            return f"Some {value.text}"
        return value.text

    def statement(self):
        constant = self.peek() == "const"
        if constant or (self.peek() in ["Float", *self.kernel.structs] and self.peek(1) in self.names_after()):
            self.at += constant
            kind = self.take()
            while True:
                name = self.take()
                if self.peek() == "(":
                    value = self.call(kind, self.arguments())
                else:
                    self.take("=")
                    value = self.expression()
                if value.kind != kind:
                    raise SystemExit(f"{self.name}: {name} is no {kind}")
                self.bind(name, value)
                if self.take() == ";":
                    return
        name = self.take()
        field = None
        if self.peek() == ".":
            self.take()
            field = self.take()
        operator = self.take()
        value = self.expression()
        self.take(";")
        old = self.scope.get(name)
        if operator in ("+=", "-=") and not field:
            value = (Value(f"({old.text} {operator[0]} {value.text})%Z", "int") if old.kind == value.kind == "int" else
                     self.by(*next((d, [old, value], self.kernel.functions[k]) for d, k in NAMES.items()
                                   if k == (f"{old.kind}.operator{operator}", value.kind))))
        elif operator != "=":
            raise SystemExit(f"{self.name}: not understood: {name} {operator}")
        if field:
            fields = self.kernel.structs[old.kind]
            value = self.record(old.kind, [value if f == field else Value(f"({field_name(old.kind, f)} {old.text})", k)
                                           for f, k in fields])
        self.scope[name] = value

    def names_after(self):
        return [t for t in self.tokens[self.at + 1:self.at + 2] if re.fullmatch(r"[A-Za-z_]\w*", t)]

    def bind(self, name, value):
        """The last step's result takes the name that the text gives it."""
        if self.steps and self.steps[-1][0] == value.text and re.fullmatch(r"t\d*", value.text):
            said = self.steps[-1][1]
            fresh = self.fresh(name)
            self.steps[-1] = (fresh, said[:-len(value.text)] + fresh)
            value = Value(fresh, value.kind)
        self.scope[name] = value

    def braces(self):
        self.take("{")
        return self.listed("}")

    def arguments(self):
        self.take("(")
        return self.listed(")")

    def listed(self, end):
        values = []
        while self.peek() != end:
            values.append(self.expression())
            if self.peek() == ",":
                self.take()
        self.take(end)
        return values

    def expression(self, level=0):
        levels = [("+=", "-="), (">=", "<="), ("+", "-"), ("*", "/")]
        if level == len(levels):
            return self.unary()
        left = self.expression(level + 1)
        while self.peek() in levels[level]:
            operator = self.take()
            right = self.expression(level + 1)
            if level == 0:
                left = self.by(*next((d, [left, right], self.kernel.functions[k]) for d, k in NAMES.items()
                                     if k == (f"{left.kind}.operator{operator}", right.kind)))
            elif level == 1:
                if operator == ">=":
                    left, right = right, left
                left = self.step(f"at_most {self.number(left)} {self.number(right)}", "bool", "b")
            else:
                left = self.operation(operator, left, right)
        return left

    def unary(self):
        token = self.take()
        if token == "!":
            return Value(f"negb {self.unary().text}", "bool")
        if token == "-":
            value = self.unary()
            if value.kind == "Float":
                return Value(f"(negated {value.text})", "Float")
            return self.call("operator-", [value])
        if token == "*":
            self.take("this")
            return self.scope["*this"]
        if token == "(":
            value = self.expression()
            self.take(")")
        elif token[0].isdigit():
            if "." in token:
                exact = Fraction(token)
                value = Value(f"({exact.numerator} / {exact.denominator})", "real")
            else:
                value = Value(token, "int")
        elif self.peek() == "(" and token not in self.scope:
            value = self.call(token, self.arguments())
        elif token in self.kernel.structs and self.peek() == "{":
            value = self.record(token, self.braces())
        elif token in self.scope:
            value = self.scope[token]
        elif token in [name for name, _, _ in self.kernel.constants]:
            value = Value(token, "real")
        else:
            raise SystemExit(f"{self.name}: unknown name {token!r}")
        while self.peek() == ".":
            self.take()
            field = self.take()
            if self.peek() == "(":
                value = self.by(*next((d, [value, *self.arguments()], self.kernel.functions[k])
                                      for d, k in NAMES.items() if k[0] == f"{value.kind}.{field}"))
            else:
                kinds = dict(self.kernel.structs[value.kind])
                value = Value(f"({field_name(value.kind, field)} {value.text})", kinds[field])
        return value


def real(value):
    if value.kind == "int":
        return value.text if value.text.isdigit() else f"(IZR {value.text})"
    if value.kind != "real":
        raise SystemExit(f"no constant: {value.text}")
    return value.text


def all_of(root):
    """The Coq file, and for each of PROVED the name, its definitions and the texts that they are from."""
    kernel = Kernel(root)
    definitions = {name: Definition(kernel, name) for name in NAMES}
    text = HEAD + kernel.records() + "\n".join(d.text() for d in definitions.values()) + "\nEnd Text.\n"
    found = []
    for name, about in PROVED.items():
        uses, parts = set(), set(about)
        while parts - uses:
            uses |= parts
            parts = {p for n in parts for p in definitions[n].used}
        uses = [n for n in NAMES if n in uses]
        rests = [kernel.form, kernel.records()] + [definitions[n].whole for n in uses]
        found.append((name, "\n".join([kernel.records()] + [definitions[n].text() for n in uses]), rests))
    found.append(("window", kernel.records(), [kernel.window]))
    return text, found


if __name__ == "__main__":
    import pathlib
    import sys
    print(all_of(pathlib.Path(sys.argv[1]))[0])
