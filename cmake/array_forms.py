# SPDX-License-Identifier: Apache-2.0
"""The decisions over arrays for C and Python, made from what robust/batch declares, so that there is no list of them.

An operand is a struct of robust/batch/isa/columns.h, Polygon2d or Meshd. The comment of a declaration says "its Side:",
the enumeration of the answers, which is looked up in geometry/. Overloads are those of the plane and of space; C has no
overloads, and calls them _2 and _3."""
import re

import declarations


def snake_case(name):
    """TriangleTriangleRelation -> triangle_triangle_relation, Points2 -> points2"""
    return re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", name).lower()


def add(parts, **texts):
    for name, text in texts.items():
        parts[name] = parts.get(name, "") + text


class Shapes:
    """A name for each operand type, and of how many numbers it consists."""

    def __init__(self, parts, columns):
        self.in_c = {"Column": "touchstone_column", "Polygon2d": "touchstone_polygon2", "Meshd": "touchstone_mesh"}
        self.in_python = {"Column": "None", "Polygon2d": "POLYGON2", "Meshd": "MESH"}
        self.numbers = {"Column": 1}
        for name, members in declarations.structs(columns):
            if name != "Column":
                self.add(parts, name, members)

    def add(self, parts, name, members):
        shape, upper = f"touchstone_{snake_case(name)}", snake_case(name).upper()
        numbers, fields_in_c, rows, converted, in_python = 0, "", [], [], []
        for kind, fields in members:
            if kind not in self.in_c:
                raise declarations.Undeclared(
                    f"columns.h: {name}: expected columns, or structs that stand above, found: {kind}")
            fields_in_c += f"  {self.in_c[kind]} {', '.join(fields)};\n"
            for field in fields:
                rows.append(f"{self.in_c[kind]}_rows(first + {numbers}, stride)")
                converted.append(f"operand(of.{field})")
                in_python.append(f"{field}={self.in_python[kind]}")
                numbers += self.numbers[kind]
        self.in_c[name], self.in_python[name], self.numbers[name] = shape, upper, numbers
        joined = ",\n      ".join(rows)
        add(parts,
            shapes_in_c=f"\ntypedef struct {shape} {{\n{fields_in_c}}} {shape};\n"
                        f"static inline {shape} {shape}_rows(const double* first, ptrdiff_t stride) {{\n"
                        f"  const {shape} rows = {{\n      {joined}}};\n  return rows;\n}}\n",
            operands=f"batch::{name} operand(const {shape}& of) {{ return {{{', '.join(converted)}}}; }}\n",
            shapes_in_python=f"{upper} = Shape({', '.join(in_python)})\n")


def add_enumeration(parts, name, meaning, enumerators):
    kind = f"touchstone_{snake_case(name)}"
    numbers = [(f"{kind}_{enumerator}".upper(), enumerator, number) for number, enumerator in enumerate(enumerators)]
    in_c = ",\n".join(f"  {upper} = {number}" for upper, _, number in numbers)
    comment = "\n/* " + meaning.replace("\n", "\n * ") + " */" if meaning else ""
    help_text = '    """' + meaning.replace("\n", "\n    ") + '"""\n\n' if meaning else ""
    add(parts,
        enumerations_in_c=f"{comment}\ntypedef enum {kind} {{\n{in_c}\n}} {kind};\n",
        enumerations_in_python=f"\n\nclass {name}(Enumeration):\n" + re.sub(" +(\n|$)", r"\1", help_text)
                               + "".join(f"    {enumerator} = {number}\n" for _, enumerator, number in numbers),
        checks="".join(f"static_assert(static_cast<int>({name}::{enumerator}) == {upper});\n"
                       for upper, enumerator, _ in numbers))


def add_mask(parts, name, enumeration, enumerators, operands):
    """Where an enumerator says that there is no common point, adds the function of Python that answers so by bool:
    X_contains(X, points) of point_in_X and point_on_X, NAME_intersects of others."""
    nothing = [e for e in enumerators if e in ("outside", "off", "disjoint", "none")]
    boundary = [e for e in enumerators if e in ("boundary", "touching")]
    if not nothing:
        return
    mask, meaning = f"{name}_intersects", "the closed shapes have a point in common"
    interior = "whether their interiors have"
    masked = list(operands)
    if inside := re.match("point_([io]n)_(.*)$", name):
        mask, meaning, interior = f"{inside[2]}_contains", "each point is in the closed shape", "in its interior"
        if inside[1] == "on":
            masked.reverse()
    test = f"answers != {enumeration}.{nothing[-1]}"
    annotated, in_help = ", ".join(f"{operand}: Operand" for operand in masked), ", ".join(masked)
    if boundary:
        others = ", ".join(f"{enumeration}.{e}" for e in enumerators if e not in nothing + boundary)
        test += f" if {boundary[-1]} else answers.isin({others})"
        annotated += f", *, {boundary[-1]}: bool = True"
        in_help += f", {boundary[-1]}=True"
        meaning += f"; with {boundary[-1]}=False, {interior}"
    add(parts,
        functions_in_python=f'\n\ndef {mask}({annotated}) -> Mask:\n    """A mask, by `{name}`: whether {meaning}."""\n'
                            f"    answers = {name}({', '.join(operands)})\n    return {test}\n")
    parts["exported"].append(mask)
    parts["masks_in_help"].append(f"  {mask}({in_help})")


def add_decision(parts, shapes, header, name, contract, overloads):
    """Returns the names of its operands."""
    forms = []
    add(parts, functions_in_c="\n/* " + contract.replace("\n", "\n * ") + " */\n")
    for operands in overloads:
        for kind, operand in operands:
            if kind not in shapes.in_c:
                raise declarations.Undeclared(
                    f"{header}: expected const SHAPE& operand, found: const {kind}& {operand}")
        suffix = re.sub(".*([23])$", r"_\1", operands[0][0]) if len(overloads) > 1 else ""
        in_c = ", ".join(f"{shapes.in_c[kind]} {operand}" for kind, operand in operands)
        passed = ", ".join(f"operand({operand})" for _, operand in operands)
        in_python = ", ".join(f"{operand}={shapes.in_python[kind]}" for kind, operand in operands)
        function = f"int touchstone_{name}{suffix}({in_c},"
        add(parts,
            functions_in_c=f"{function}\n    size_t count, uint8_t* answers, touchstone_error* error);\n",
            functions=f"\n{function} size_t count, uint8_t* answers, touchstone_error* error) {{\n"
                      f"  return answered(error, [&] {{ batch::{name}({passed}, count, answers, limits()); }});\n}}\n",
            forms=f"  form({name}{suffix}) \\\n")
        forms.append(f'Form("{name}{suffix}", {in_python})')
    return forms, [operand for _, operand in overloads[-1]]


def add_prepared(parts, shapes, name, raw, prepared, header):
    """The decision of a shape that is validated once, and that shape, which is the first operand in C; `raw`: the operands
    without it; `header`: what declares it."""
    shape, operands = prepared
    place = [kind for kind, _ in operands].index(shape)
    operand, others = operands[place][1], operands[:place] + operands[place + 1:]
    raw = raw[place][0]
    kind = f"touchstone_{snake_case(shape)}"
    of = "mesh" if raw == "Meshd" else "polygon"  # the field that errors name
    given, error = f"{shapes.in_c[raw]} {of}", "touchstone_error* error"
    in_c = ", ".join(f"{shapes.in_c[other]} {each}" for other, each in others)
    passed = ", ".join(f"{operand}->shape" if each == operand else f"operand({each})" for _, each in operands)
    function = f"int touchstone_{name}_prepared(const {kind}* {operand}, {in_c}, size_t count,"
    parts["includes"].append(f'#include "robust/prepared/{header}"')
    add(parts,
        prepared_in_c=f"\ntypedef struct {kind} {kind};\nint {kind}_make({given}, {kind}** made, {error});\n"
                      f"void {kind}_free({kind}* shape);\n"
                      f"{function}\n    uint8_t* answers, {error});\n",
        functions=f"\nstruct {kind} {{\n  touchstone::robust::{shape} shape;\n}};\n"
                  f"int {kind}_make({given}, {kind}** made, {error}) {{\n  *made = nullptr;\n"
                  f"  return answered(error, [&] {{ *made = new {kind}{{touchstone::robust::{shape}(operand({of}))}}; }});\n}}\n"
                  f"void {kind}_free({kind}* shape) {{ delete shape; }}\n"
                  f"{function} uint8_t* answers, {error}) {{\n"
                  f"  return answered(error, [&] {{ batch::{name}({passed}, count, answers, limits()); }});\n}}\n",
        prepared_forms=f"  form({name}, {shape}, {kind}) \\\n")


def made(root):
    """Returns {name: text}, for the templates."""
    parts = {"exported": [], "decisions_in_help": [], "masks_in_help": [], "includes": [], "prepared_in_c": "", "prepared_forms": ""}
    batch = root / "robust/batch"
    shapes = Shapes(parts, declarations.text_of(batch / "isa/columns.h"))
    geometry = {path.name: declarations.text_of(path) for path in sorted((root / "geometry").glob("*.h"))}
    enumerations = {}
    for path in sorted(batch.glob("*.h")):
        name, header = path.stem, f"robust/batch/{path.name}"
        contract, overloads = declarations.decision(header, declarations.text_of(path), name)
        contract = re.sub(r"\Arobust::[a-z_]+ of", f"`{name}` of", contract)
        named = re.search(" its ([A-Z][A-Za-z]+):", contract.replace("\n", " "))
        if not named:
            raise declarations.Undeclared(f"{header}: the contract does not name the enumeration of the answers, "
                                          '"its Side: left 0, on 1, right 2"')
        enumeration = named[1]
        if enumeration not in enumerations:
            declared = [(file, declarations.enumeration(text, enumeration)) for file, text in geometry.items()]
            found = [each for each in declared if each[1]]
            if not found:
                raise declarations.Undeclared(
                    f"{header}: no header of geometry/ declares the enumeration {enumeration}")
            file, (meaning, enumerations[enumeration]) = found[-1]
            add_enumeration(parts, enumeration, meaning, enumerations[enumeration])
            parts["includes"].append(f'#include "geometry/{file}"')
            parts["exported"].append(enumeration)
        parts["includes"].append(f'#include "{header}"')
        parts["exported"].append(name)
        forms, operands = add_decision(parts, shapes, header, name, contract, overloads)
        prepared = declarations.prepared(declarations.text_of(path), name)
        if prepared:
            header = next(file.name for file in sorted((root / "robust/prepared").glob("*.h"))
                          if re.search(rf"^class {prepared[0]}\b[^;]*$", declarations.text_of(file), re.MULTILINE))
            add_prepared(parts, shapes, name, overloads[0], prepared, header)
        upper, enumerators, joined = name.upper(), enumerations[enumeration], ", ".join(operands)
        help_text = contract.replace("\n", "\n    ")
        add(parts,
            functions_in_python=f"\n\n_{upper} = ({', '.join(forms)},)\n\n\n"
                                f"def {name}({': Operand, '.join(operands)}: Operand, *, out: Out = None) -> Answers:\n"
                                f'    """{help_text}"""\n    return decide(_{upper}, {enumeration}, out, {joined})\n')
        parts["decisions_in_help"].append(f"  {name}({joined})  {enumeration}: {', '.join(enumerators)}")
        add_mask(parts, name, enumeration, enumerators, operands)
    parts["includes"] = list(dict.fromkeys(parts["includes"]))
    parts["exported"] = [f'    "{name}",' for name in parts["exported"]]
    return {name: text if isinstance(text, str) else "\n".join(text) for name, text in parts.items()}
