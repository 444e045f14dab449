# SPDX-License-Identifier: Apache-2.0
"""Second stages of robust/batch/isa as Coq functions: of numbers with their rounding errors. See extract.py.

They are compiled where there is an FMA, so each product and sum of multiply_add is rounded once.
"""
from pathlib import Path

import lane_text
from lane_solids import Function, Solid, Solids
from lane_text import Term

HEADERS = ["robust/batch/isa/sums.h", "robust/batch/isa/close.h"]
HEAD = lane_text.HEAD
NAMES = {"lane_close_turn"}
PAIRS = ("Difference", "Product", "Sum")


class Close(Solid):
    """Also makes numbers with their errors."""

    def call(self, text, scope, result=None, owner=None):
        outer, self.run.scope = self.run.scope, {**self.run.source.constants, **scope}
        Close(self.run, text, result, owner).block()
        inner, self.run.scope = self.run.scope, outer
        return inner

    def constructed(self, kind, arguments):
        if kind not in PAIRS:
            return super().constructed(kind, arguments)
        self.run.used[kind] = self.run.source.classes[kind]
        parameters, fields, text = self.run.shapes.constructor(kind, len(arguments))
        made = dict(zip(lane_text.names_of(parameters), arguments, strict=True))
        reader, outer = Close(self.run, fields), self.run.scope
        self.run.scope = {**self.run.source.constants, **made}
        while reader.peek():
            name = reader.take()
            (value,) = reader.arguments()
            self.run.scope[name] = self.run.named(name, value)
            if reader.peek():
                reader.take(",")
        made, self.run.scope = self.run.scope, outer
        inner = self.call(text, made)
        return {name: inner[name] for name in ("head", "tail")}

    def made_of(self, fields):
        if self.result == "Sides":
            return dict(zip(("left", "right"), fields, strict=True))
        return super().made_of(fields)


def pair(name):
    return {part: Term(f"{name}_{part}") for part in ("head", "tail")}


def all_of(root):
    """As lane_text.all_of."""
    shapes, used = Solids(Path(root), HEADERS, HEADERS[1]), {}
    one = Function(shapes, used, ["x", "y"], {})
    made = Close(one.run, "").constructed("Difference", [Term("x"), Term("y")])
    difference = one.defined("lane_difference (x y : float) : float * float", f"({made['head']}, {made['tail']})")
    pairs = [pair(name) for name in "uwst"]
    given = " ".join(part for each in pairs for part in each.values())
    one = Function(shapes, used, given.split(), {})
    found = Close(one.run, "").method(None, "close_turn", {}, pairs)
    turn = one.defined(f"lane_close_turn ({given} : float) : bool * bool", f"({found['left']}, {found['right']})")
    text = (difference + turn).replace("multiply_add fused", "multiply_add true")
    parts = [used[k] for k in sorted(used)]
    shared = [str(sorted(shapes.source.constants.items())), lane_text.text_of_lanes(Path(root))]
    return f"{HEAD}{text}", [("lane_close_turn", text, [*parts, *shared])]
