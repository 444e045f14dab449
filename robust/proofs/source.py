# SPDX-License-Identifier: Apache-2.0
"""The functions and classes of the headers, as text; see extract.py."""
import re

HEADERS = ["geometry/points.h", "geometry/space.h"] + [
    f"robust/kernel/filters/{name}.h"
    for name in "filters plane_filter slab_filter sphere_filter sphere_box_filter sweep_filter face_filter obb_filter "
    "contact_filter extreme_filter height_filter ray_filter".split()
]


CROSSINGS = "robust/polygons/point_in_polygon.cpp"
READ = [*HEADERS, CROSSINGS]


def of_lanes(text):
    """Crossings, which works on two doubles at a time, as what it does in each lane."""
    text = re.sub(r"\b(Lanes|double)\b", "Float", text.replace("Perhaps<Location>", "Location"))
    return text.replace("filters::Bounds", "Bounds")


def cleaned(text):
    text = re.sub(r"//.*", "", text)
    text = re.sub(r"<Float, Format>|<Float>|<Real>|\btemplate (?=relative)|\[\[unlikely\]\]", "", text)
    text = re.sub(r"static_cast<int>", "", text)
    text = re.sub(r"\b(?:B|Bounds)::relative<(\d+), (\d+)>\(\)", r"relative(\1, \2)", text)
    text = re.sub(r"std::array<([\w:]+), (\d+)>", r"\1[\2]", text)
    return re.sub(r"\bReal\(", "Float(", text)


class Source:
    """Functions, classes and their methods of all headers, as text."""

    def __init__(self, root):
        self.functions, self.classes, self.structs, self.data = {}, {}, {}, {}
        filters = cleaned((root / "robust/kernel/filters/filters.h").read_text(encoding="utf-8"))
        # Read as Coq just as it is.
        body = r"static Float relative\(\) \{\n    constexpr double c = ([-+*/ ()\w]+);\n"
        self.relative = re.search(body, filters)[1]
        if "double u = power_of_two(1 - Format::precision);" not in filters:
            raise SystemExit("filters.h: u is not 2^(1 - precision)")
        for name in HEADERS:
            text = cleaned((root / name).read_text(encoding="utf-8"))
            kinds = r"^(?:template <[^;{}]*?>\n)(class|struct) (\w+)[^;]*?\{\n(.*?)^\};"
            for found in re.finditer(kinds, text, re.M | re.S):
                self.add_class(found[2], found[3])
            text = re.sub(r"^template <[^;{}]*?>\n(class|struct) \w+[^;]*?\{\n.*?^\};", "", text, flags=re.M | re.S)
            functions = r"^(?:inline )?(\w+|Perhaps<\w+>) (operator[-+]|\w+)\(([^{;]*)\) \{\n(.*?)^\}"
            for found in re.finditer(functions, text, re.M | re.S):
                self.add(found[2], found[3], found[4], found[0])
        text = cleaned(of_lanes((root / CROSSINGS).read_text(encoding="utf-8")))
        parts = r"^\w+ (?:bits|lesser)\([^\n]*\}$|^\w+ (?:magnitude|by_filter)\(.*?^\}$|^struct Crossings .*?^\};"
        self.crossings = "\n".join(re.findall(parts, text, re.M | re.S))
        self.add_class("Crossings", re.search(r"^struct Crossings \{\n(.*?)^\};", text, re.M | re.S)[1])
        found = re.search(r"^Float (lesser)\((.*?)\) \{ (.*?) \}$", text, re.M)
        self.add(*found.groups(), found[0])

    def add(self, name, parameters, body, whole):
        kinds = tuple(re.sub(r"const |&|\.\.\. ?", "", p).split() for p in split(parameters))
        self.functions.setdefault((name, len(kinds)), []).append((kinds, body, whole))

    def add_class(self, name, body):
        members = {}
        constructor = rf"^  (?:explicit )?{name}\(([^{{;]*?)\)(?:\s*:\s*(.*?))? \{{(\}}|\n(.*?)^  \}})"
        for found in re.finditer(constructor, body, re.M | re.S):
            members["this"] = (found[1], initialisers(found[2] or "") + (found[4] or ""), found[0])
        for found in re.finditer(r"^  (?:static |constexpr )*\w+ (\w+)\(([^{;]*)\) (?:const )?\{(.*?)\}$", body, re.M):
            members[found[1]] = (found[2], found[3], found[0])
        for found in re.finditer(r"^  (?:static )?\w+ (\w+)\(([^{;]*)\) (?:const )?\{\n(.*?)^  \}", body, re.M | re.S):
            members[found[1]] = (found[2], found[3], found[0])
        found = re.search(r"high_exponent = ([^;]*);", body)
        if found:
            members["high_exponent"] = ("", f"return {found[1]};", found[0])
        found = re.search(r"^  using B = \w+;", body, re.M)
        if found:
            members["B"] = ("", found[0], found[0])
        self.classes[name] = members
        for found in re.finditer(r"^  struct (\w+) \{\n\s*Float ([\w, ]+);\n  \};", body, re.M):
            self.structs[found[1]] = found[2].split(", ")
        self.data[name] = [(kind, n) for kind, names in re.findall(r"^  (\w+) ((?:\w+_, )*\w+_);$", body, re.M)
                           for n in names.split(", ")]


def split(text):
    """At commas outside of brackets."""
    parts, depth, last = [], 0, ""
    for c in text:
        depth += (c in "([{") - (c in ")]}")
        if c == "," and depth == 0:
            parts.append(last.strip())
            last = ""
        else:
            last += c
    return [p for p in parts + [last.strip()] if p]


def initialisers(text):
    result = ""
    for part in split(text):
        name, value = re.fullmatch(r"(\w+)[({](.*)[)}]", part, re.S).groups()
        result += f"{name} = {{{value}}};" if part[-1] == "}" else f"{name} = {value};"
    return result
