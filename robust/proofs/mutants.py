# SPDX-License-Identifier: Apache-2.0
"""Headers with a smaller constant, or, of arrays, another comparison: does a run refuse them? See prove.py."""
import math
import pathlib
import re
import shutil
import tempfile

import enclosed
import extract
import lane_close
import lane_linear
import lane_shapes
import lane_solids
import lane_text
import lane_triangles
import source

RELATIVE = re.compile(r"relative<(\d+), (\d+)>")
TAKEN = re.compile(r"(?<=above\()(\d+(?:\.\d+)?)(?=[ )])|(?<=terms_ \+ )(\d+)")  # of enclosed.h
ABSOLUTE = re.compile(r"power_of_two\((\d+) \+ Format::min_exponent")

MULTIPLE = re.compile(r"above\((\d+) \* B::u\)")
LEAST = re.compile(r"least\(\) \{ return Format::above\(power_of_two\(-(\d+)")
UNITS_OF_LANES = re.compile(r"(\d+) \* (?=v\b|size \*)")
# For the filters of arrays: the other choice, 0 taken for positive, an answer turned over, numbers that may be infinite.
OF_LANES = [("flipped", re.compile(r"\blesser\("), "greater("),
            ("flipped", re.compile(r"\bgreater\((?!const |(?:greater\()?(?:magnitudes|sizes))"), "lesser("),
            ("flipped", re.compile(r"\babove\((?=\w+(?:\([\w, ]*\))?, same\(0\)\))"), "not_below("),
            ("flipped", re.compile(r"\bnegative\(depth\)"), "above(depth, same(0))"),
            ("left out", re.compile(r"not_below\(same\(0x1\.f+p1023\), [\w +]+\) & "), ""),
            # of rays with boxes: touching, no direction, max < min, the value's opposite
            ("flipped", re.compile(r"\babove\((?=min, from\)|from, max\)|ways, zero\))"), "not_below("),
            ("left out", re.compile(r" & not_below\(narrowest, zero\)"), ""),
            ("flipped", re.compile("zero - value"), "value"),
            ("flipped", re.compile(r"same\(0\) - value"), "value"),
            ("flipped", re.compile(r"same\(0\) - gap"), "gap"),
            ("left out", re.compile(r" & not_below\(reach, same\(0x1p-250\)\)"), ""),
            # of triangles: what pays for underflow, what overflows, volumes, edges on two sides of a line, ends on one
            ("left out", re.compile(r"same\(for_underflow\)"), "same(0)"),
            ("left out", re.compile(r"(?:\bmoderate\([\w(), ]+\)|(?<=\{)decidable) & "), ""),
            ("flipped", re.compile(r"same\(0\) - (?=ac|bound|with_q)"), ""),
            ("flipped", re.compile(r"(?<=ab \+ bc\)) - "), " + "),
            ("flipped", re.compile(r"(?<=with_q - with_p\)) \+ "), " - "),
            ("flipped", re.compile(r"(?<=above\(least, bound\)) \| "), " & "),
            ("flipped", re.compile(r"(?<=above\(greatest, bound\)) & "), " | "),
            ("left out", re.compile(r"(?<=apart\()certain & | & above\(least, bound\)(?=;)| & ~apart(?=\};)"), ""),
            # of linear functions: signs of their numbers, corners of the box, NaN, the other side of a shape
            ("flipped", re.compile(r"-(?=\(along_x|constant)"), ""),
            ("flipped", re.compile(r"std::min\(least"), "std::max(least"),
            ("left out", re.compile(r"std::min\(std::numeric_limits<double>::infinity\(\), (?=other)"), "("),
            ("left out", re.compile(r"same\(0\) - (?=error|point\.error)"), ""),
            ("flipped", re.compile(r"(?<=beyond) \| (?=outside)"), " & ")]
HEADERS_OF_LANES = [*lane_text.HEADERS, *lane_solids.HEADERS, *lane_linear.HEADERS, *lane_close.HEADERS,
                    *lane_triangles.HEADERS]
TEXTS = source.READ + enclosed.HEADERS + HEADERS_OF_LANES


def mutants(root):
    """(kind, what, header, text): each constant one unit smaller, in its last parameter and in its first."""
    for name in TEXTS:
        text = (root / name).read_text(encoding="utf-8")
        def other_text(found, other):
            where = text.count("\n", 0, found.start()) + 1
            return f"{name}:{where} {other}", name, text[:found.start()] + other + text[found.end():]

        for found in RELATIVE.finditer(text):
            c, d = int(found[1]), int(found[2])
            for kind, other in (("last", f"relative<{c}, {d - 1}>"), ("first", f"relative<{c - 1}, {d}>")):
                yield kind, *other_text(found, other)
        for found in MULTIPLE.finditer(text):
            yield "first", *other_text(found, f"above({int(found[1]) - 1} * B::u)")
        for found in LEAST.finditer(text):
            yield "half", *other_text(found, f"least() {{ return Format::above(power_of_two(-{int(found[1]) + 1}")
        for found in ABSOLUTE.finditer(text):
            other = f"power_of_two({int(found[1]) - 1} + Format::min_exponent"
            yield "half", *other_text(found, other)
        code = re.sub("//.*", lambda comment: " " * len(comment[0]), text)
        for found in UNITS_OF_LANES.finditer(code if name in HEADERS_OF_LANES else ""):
            yield "half", *other_text(found, f"{int(found[1]) // 2} * ")
        for kind, pattern, other in OF_LANES if name in HEADERS_OF_LANES else []:
            for found in pattern.finditer(code):
                yield kind, *other_text(found, other)
        for found in TAKEN.finditer(text if name in enclosed.HEADERS else ""):
            if float(found[0]) > 1:
                yield "taken", *other_text(found, str(math.ceil(float(found[0])) - 1))


def mutated(root):
    """For each mutant: kind, what it is, and what extract has to say of it."""
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder)
        for name in [*TEXTS, *lane_text.LANES, lane_shapes.NUMBERS, lane_solids.AXES]:
            (copy / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(root / name, copy / name)
        for kind, what, name, text in mutants(root):
            kept = (copy / name).read_text(encoding="utf-8")
            (copy / name).write_text(text, encoding="utf-8")
            yield kind, what, extract.all_of(copy)
            (copy / name).write_text(kept, encoding="utf-8")
