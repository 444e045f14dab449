# SPDX-License-Identifier: Apache-2.0
"""Runs a function of the headers on names instead of numbers; see extract.py."""
import re

from source import split
from tokens import Tokens
from values import TYPES, Answer, Array, Index, Number, Real, Truth, chosen_bounds, exponents, fits, power

ANSWERS = {
    "Sign::unknown": "unknown", "Sign::positive": "positive", "Sign::negative": "negative",
    "std::nullopt": "None", "Location::inside": "Some Inside", "Location::outside": "Some Outside",
    "Meeting::unknown": "meeting_unknown", "Meeting::at_start": "meets_at_start", "Meeting::later": "meets_later",
    "Meeting::never": "meets_never"}
TOKEN = re.compile(
    r"\s*(?:(\d+)|((?:[A-Za-z_]\w*|::)(?:::\w+)*)|(\+=|\^=|<=|>=|\+\+|&&|\|\||[-+*/(){}\[\],;<>=!&|?:.^~]))")


class Run:
    """One function on names."""

    def __init__(self, source, pack):
        self.source, self.pack = source, pack
        self.steps, self.used, self.taken, self.owner, self.elements = [], {}, set(), None, set()

    # names and operations
    def fresh(self, wish):
        name, i = wish, 1
        while name in self.taken or name in ("end", "at", "in", "u", "n"):
            name, i = f"{wish}{i}", i + 1
        self.taken.add(name)
        return name

    def step(self, operation, *operands, wish="t", factors=None):
        result = Number(self.fresh(wish), factors)
        self.steps.append((result, operation, operands))
        return result

    def number(self, value):
        if isinstance(value, Real):
            return self.step("constant", value, wish="c")
        if not isinstance(value, Number):
            raise SystemExit(f"not a number: {value!r}")
        return value

    def operand(self, value):
        value = self.number(value)
        if value.factors:
            return ("Product", *value.factors, value)
        return ("Plain", value)

    def arithmetic(self, operator, left, right):
        if isinstance(left, dict) and isinstance(right, dict):
            return self.fieldwise(operator, left, right)
        if isinstance(left, Index) and isinstance(right, tuple) and operator == "+":
            return Index(f"({left} + {right[0]})%nat")
        if operator == "*" and isinstance(left, tuple) and not left[1] and right == "(u F)":  # of the format: exact
            return Real(f"({left[0]} * {right})")
        if isinstance(left, tuple) and isinstance(right, tuple):  # exponents
            return exponents(operator, left, right)
        left, right = (Real(x[0]) if isinstance(x, tuple) and not x[1] else x for x in (left, right))
        if operator == "*":
            left, right = self.number(left), self.number(right)
            return self.step("mul", left, right, factors=(left, right))
        return self.step({"+": "add", "-": "sub"}[operator], self.operand(left), self.operand(right))

    def fieldwise(self, operator, left, right):
        for kinds, body, whole in self.source.functions[f"operator{operator}", 2]:
            if [k for k in TYPES[kinds[0][0]].split()] == list(left):
                return self.call_text(kinds, body, [left, right], whole, f"operator{operator}")
        raise SystemExit(f"no operator{operator} for {list(left)}")

    def compare(self, operator, left, right):
        left, right = self.number(left), self.number(right)
        if operator in ("<", ">="):
            left, right = right, left
        operation = {">": "greater", "<": "greater", "<=": "at_most", ">=": "at_most"}[operator]
        return Truth(self.step(operation, left, right, wish="b").name)

    def choice(self, condition, yes, no):
        yes, no = self.number(yes), self.number(no)
        if yes.factors or no.factors:
            raise SystemExit("a choice between products")
        return self.step("choose", condition, yes, no)

    # calls
    def call(self, name, arguments):
        of, _, last = name.rpartition("::")
        name = last if of != "B" else name
        if name == "Float":
            return arguments[0] if arguments else Real("0")
        if name == "infinity":  # no number of the machine
            return Answer("None")
        if name == "bits":  # of which one is read, the sign
            return Truth(self.step("signed", self.number(arguments[0]), wish="b").name)
        if name in ("magnitude", "fabs"):
            return Number(f"(magnitude M {self.number(arguments[0])})")
        if name == "square_root":
            return self.step("square_root", self.number(arguments[0]))
        if name == "relative":
            c, d = arguments
            return Real(f"(relative {c[0]} {d[0]} (u F))")
        if name == "above":
            return arguments[0]
        if name == "power_of_two":
            (e,) = arguments
            return Real(power(e))
        owner = of if of in self.source.classes else self.owner
        if name.startswith("B::"):
            name = name[3:]
            owner = self.bounds if name in self.source.classes[self.bounds] else "Bounds"
        if owner and name in self.source.classes.get(owner, {}):
            parameters, body, whole = self.source.classes[owner][name]
            kinds = tuple(re.sub(r"const |&", "", p).split() for p in split(parameters))
            return self.call_text(kinds, body, arguments, whole, f"{owner}.{name}", owner)
        for kinds, body, whole in self.source.functions.get((name, len(arguments)), []):
            if all(fits(k[0], a) for k, a in zip(kinds, arguments)):
                return self.call_text(kinds, body, arguments, whole, name)
        raise SystemExit(f"no function {name} of {len(arguments)} such arguments")

    def call_text(self, kinds, body, arguments, whole, name, owner=None):
        self.used[f"{name}/{len(arguments)}/{kinds[0][0] if kinds else ''}"] = whole
        scope = dict(self.members) if owner == self.owner and owner else {}
        scope.update({k[-1]: a for k, a in zip(kinds, arguments)})
        bounds, mine = self.bounds, self.owner
        self.owner = owner or self.owner
        self.bounds = chosen_bounds(body, bounds if owner in (None, mine) else owner)
        kind = re.match(r"(?:static |constexpr |inline )*(\w+)", whole.strip())[1]
        result = Body(self, body, scope, kind).run()
        self.owner, self.bounds = mine, bounds
        return result

    members, bounds = {}, "Bounds"


class Body(Tokens):
    """Statements and expressions."""

    def __init__(self, run, text, scope, kind=None):
        self.r, self.scope, self.kind = run, scope, kind
        super().__init__(TOKEN, self.unfolded(text))

    def unfolded(self, text):
        """(E + ...) over a pack `axis`."""
        def fold(found):
            parts = [found[1].replace("axis.", f"axis{i}.") for i in range(self.r.pack)]
            return "(" + f" {found[2]} (".join(parts) + ")" * self.r.pack
        return re.sub(r"\(((?:\([^()]*(?:\([^()]*\))?[^()]*\)|axis\.\w+)) ([+&]) \.\.\.\)", fold, text)

    def run(self):
        """The value returned; for a constructor, None."""
        token = self.peek()
        if token is None:
            return None
        if token in ("using", "static_assert"):
            while self.take() != ";":
                pass
            return self.run()
        if token == "if":
            self.take()
            self.take("(")
            condition = self.expression()
            self.take(")")
            self.take("return")
            then = self.expression()
            self.take(";")
            otherwise = self.run()
            some = "Some " if then == "None" and isinstance(otherwise, Number) else ""
            return Answer(f"if {condition} then {then} else {some}{otherwise}")
        if token == "for":
            self.loop()
            return self.run()
        if token == "return":
            self.take()
            value = self.initialiser(self.kind) if self.peek() == "{" else self.expression()
            self.take(";")
            return value
        self.declaration()
        return self.run()

    def declaration(self):
        kind = None
        if self.peek() in ("const", "constexpr"):
            self.take()
            kind = self.take()
            while self.peek() == "&":
                self.take()
        elif self.tokens[self.at + 1] not in ("=", "+=", "^=", "["):
            raise SystemExit(f"statement not understood: {' '.join(self.tokens[self.at:self.at + 8])}")
        if kind == "auto" and self.peek() == "[":
            self.binding()
            return
        while True:
            names, index = [self.take()], None
            if self.peek() == "[":
                self.take()
                index = self.expression()
                self.take("]")
            changed = self.take() if self.peek() in ("=", "+=", "^=") else "="
            while self.tokens[self.at + 1] == "=" != self.tokens[self.at + 2]:  # a = b = ...
                names.append(self.take())
                self.take("=")
            value = self.initialiser(kind) if self.peek() == "{" else self.expression()
            if changed == "+=":
                value = self.r.arithmetic("+", self.scope[names[0]], value)
            if changed == "^=":
                value = Truth(f"(xorb {self.scope[names[0]]} {value})")
            steps = self.r.steps
            if isinstance(value, Number) and steps and steps[-1][0] is value and re.fullmatch(r"t\d*", value.name):
                value.name = (self.r.fresh(names[0].rstrip("_")) if index is None
                              else self.element(names[0], index))
            if index is not None:
                if not isinstance(value, Number) or value.factors or value.name not in self.r.elements:
                    raise SystemExit(f"no element: {value}")
                value = Array(names[0].rstrip("_"), "Float")
            self.scope.update(dict.fromkeys(names, value))
            if self.take() == ";":
                return

    def element(self, array, index):
        """The name of one that is assigned, once."""
        name = f"({array.rstrip('_')} {index[0]}%nat)"
        if not isinstance(index, tuple) or name in self.r.elements:
            raise SystemExit(f"assignment not understood: {array}[{index}]")
        self.r.elements.add(name)
        return name

    def binding(self):
        """[a, b] = E;"""
        self.take("[")
        names = []
        while self.peek() != "=":
            names.append(self.take())
            self.take() if self.peek() in (",", "]") else self.take(",")
        self.take("=")
        value = self.expression()
        self.take(";")
        if len(names) != len(value):
            raise SystemExit(f"{len(names)} names for {list(value)}")
        self.scope.update(zip(names, value.values()))

    def loop(self):
        """for (std::size_t i = 0; i < COUNT; ++i) ASSIGNMENT; unrolled."""
        head = self.tokens[self.at:self.at + 14]
        name, count = head[3], head[9]
        if head != f"for ( std::size_t {name} = 0 ; {name} < {count} ; ++ {name} )".split() or not count.isdigit():
            raise SystemExit(f"loop not understood: {' '.join(head)}")
        self.at += len(head)
        end = self.tokens.index(";", self.at) + 1
        body, self.at = " ".join(self.tokens[self.at:end]), end
        for i in range(int(count)):
            once = Body(self.r, body, {**self.scope, name: (i, ())})
            once.run()
            self.scope.update({k: v for k, v in once.scope.items() if k != name})

    def initialiser(self, kind=None):
        self.take("{")
        values = []
        while self.peek() != "}":
            values.append(self.expression())
            if self.peek() == ",":
                self.take()
        self.take("}")
        if all(isinstance(v, Number) for v in values):
            return dict(zip(self.r.source.structs.get(kind) or TYPES.get(kind, "x y z").split(), values))
        raise SystemExit("braces around what is no vector")

    def expression(self, level=0):
        levels = [("?",), ("|", "||"), ("^",), ("&", "&&"), (">", "<", ">=", "<="), ("+", "-"), ("*", "/")]
        if level == len(levels):
            return self.unary()
        left = self.expression(level + 1)
        while self.peek() in levels[level]:
            operator = self.take()
            if operator == "?":
                yes = self.expression()
                self.take(":")
                no = self.expression()
                if isinstance(yes, Answer):
                    return Answer(f"if {left} then {yes} else {no}")
                return self.r.choice(left, yes, no)
            right = self.expression(level + 1)
            if operator in ("|", "||", "&", "&&"):
                left = Truth(f"({left} {operator[0] * 2} {right})")
            elif operator == "^":
                left = Truth(f"(xorb {left} {right})")
            elif level == 4:
                if isinstance(left, Truth) and isinstance(right, tuple):
                    continue
                left = self.r.compare(operator, left, right)
            else:
                left = self.r.arithmetic(operator, left, right)
        if level == 4 and self.peek() == "=" and self.tokens[self.at + 1] == "=":  # (known & guarded) == 0
            self.take(), self.take(), self.take("0")
            left = Truth(f"(negb {left})")
        if level == 3 and self.peek() == "!" and isinstance(left, Truth):  # beyond != 0
            self.take(), self.take("="), self.take("0")
        return left

    def unary(self):
        if self.peek() in ("!", "~"):
            self.take()
            return Truth(f"(negb {self.unary()})")
        token = self.take()
        if token == "(":
            value = self.expression()
            self.take(")")
        elif token == "[":  # a lambda of one parameter that returns an expression
            value = self.lambda_()
        elif token.isdigit():
            value = (int(token), ())
        elif token == "-":
            value = self.unary()
            if isinstance(value, tuple):
                return (-value[0], value[1])
            if self.r.number(value).factors:
                raise SystemExit("a product with its sign turned")
            return Number(f"(opposite M {value})")
        elif token in ANSWERS:
            value = Answer(ANSWERS[token])
        elif token == "B::u":
            value = Real("(u F)")
        elif token in ("Format::min_exponent", "Format::max_exponent"):
            value = (0, (token[8:],))
        elif self.peek() == "(" and token not in self.scope:
            value = self.r.call(token, self.arguments())
        elif token in self.scope:
            value = self.scope[token]
        elif self.r.bounds and token == "high_exponent":
            value = self.r.call("B::high_exponent", [])
        else:
            raise SystemExit(f"unknown name {token!r}")
        while self.peek() in (".", "[", "("):
            if self.peek() == ".":
                self.take()
                value = value[self.take()]
            elif self.peek() == "[":
                self.take()
                index = self.expression()
                value = value[index if isinstance(index, Index) else index[0]]
                self.take("]")
            else:
                value = value(*self.arguments())
        return value

    def lambda_(self):
        while self.take() != "(":
            pass
        while self.tokens[self.at + 1] != ")":
            self.take()
        name = self.take()
        self.take(")")
        self.take("{")
        start = self.at
        while self.peek() != "}":
            self.at += 1
        body = " ".join(self.tokens[start:self.at])
        self.take("}")
        return lambda argument: Body(self.r, body, {**self.scope, name: argument}).run()
