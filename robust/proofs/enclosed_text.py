# SPDX-License-Identifier: Apache-2.0
"""The text of robust/kernel/enclosed/enclosed.h, push.h, float_format.h and window.h: constants, structs, functions. See
enclosed.py."""
import re

from source import cleaned, initialisers, split

HEADERS = [f"robust/kernel/{name}.h"
           for name in ("enclosed/enclosed", "enclosed/push", "filters/float_format", "enclosed/window")]
KINDS = {"Float": "number", "int": "Z", "bool": "bool", "std::optional": "option number"}


class Kernel:
    """The text, and the definitions that come out of it."""

    def __init__(self, root):
        text, push, form, self.window = (cleaned((root / name).read_text(encoding="utf-8")) for name in HEADERS)
        text += push
        for left_out in ("[[gnu::always_inline]] inline ", "filters::"):
            text = text.replace(left_out, "")
        text = text.replace("FloatFormat::", "Format::")
        whole = re.search(r"^struct FloatFormat<double> \{\n(.*?)^\};", form, re.M | re.S)[1]
        self.precision = int(re.search(r"precision = (\d+),", whole)[1])
        cut = re.search(r"const Bits kept = reinterpret_cast<Bits>\(Lanes\{x, 0\}\) & ~\(\(1LL << (\d+)\) - 1\);\s+"
                        r"return reinterpret_cast<Lanes>\(kept\)\[0\];", whole)
        self.kept = self.precision - int(cut[1])
        self.form = whole
        self.structs, self.functions, self.constants = {}, {}, []
        for found in re.finditer(r"inline constexpr double (\w+) = (.*?);", text):
            self.constants.append((found[1], self.constant(found[2]), found[0]))
        kinds = r"^template <[^;{}]*?>\n(class|struct) (\w+) \{\n(.*?)^\};\n"
        for found in re.finditer(kinds, text, re.M | re.S):
            self.add_struct(found[2], found[3])
        text = re.sub(kinds, "", text, flags=re.M | re.S)
        for found in re.finditer(r"^([\w:]+) (operator[-+*/]|\w+)\(([^{;]*)\) \{\n(.*?)^\}", text, re.M | re.S):
            self.add("", *found.groups(), found[0])

    def constant(self, text):
        """Powers of two of the precision alone."""
        text = text.replace("Format::precision", str(self.precision)).replace(" / ", " // ")

        def power(found):
            e = eval(found[1], {"__builtins__": {}})
            return f"2 ^ {e}" if e >= 0 else f"/ 2 ^ {-e}"
        text = re.sub(r"power_of_two\(([-+*/ \d]+)\)", power, text)
        return re.sub(r"\s*\*\s*", " * ", text)

    def add(self, owner, result, name, parameters, body, whole):
        parameters = [re.sub(r"const |&", "", p).split() for p in split(parameters)]
        key = (f"{owner}.{name}" if owner else name, " ".join(p[0] for p in parameters))
        if key in self.functions:
            raise SystemExit(f"twice: {key}")
        self.functions[key] = (owner, result, parameters, body, whole)

    def add_struct(self, name, body):
        fields, starts = [], {}
        for found in re.finditer(r"^  (Float|int|Factor) ([^;()]*);", body, re.M):
            for field in split(found[2]):
                field, _, start = field.partition(" = ")
                fields.append((field, found[1]))
                starts.update({field: start} if start else {})
        self.structs[name] = fields
        for found in re.finditer(rf"^  explicit {name}\(([^{{;]*?)\)\s*:\s*([^;{{]*?) \{{\}}", body, re.M | re.S):
            text = initialisers(found[2]) + "".join(f"{field} = {start};" for field, start in starts.items())
            self.add(name, "", "this", found[1], text, found[0])
        method = r"^  (?:friend )?(?!explicit)([\w:]+&?) (operator[-+*/=]+|\w+)\(([^{};()]*)\) (?:const )?\{"
        for end, flags in ((r"(.*?)\}$", re.M), (r"\n(.*?)^  \}", re.M | re.S)):
            for found in re.finditer(method + end, body, flags):
                self.add(name, *found.groups(), found[0])

    def records(self):
        """The structs, as Coq records."""
        text = "".join(f"Definition {name} := {value}.\n" for name, value, _ in self.constants)
        text += f"Definition precision := {self.precision}%Z.\nDefinition kept := {self.kept}%Z.\n"
        for name, before in (("tiny", "double tiny = processor::at_run_time("), ("least", "size < Two("),
                             ("most", "sizes_ <= Two(")):
            (found,) = re.findall(re.escape(before) + r"0x1p(-?\d+)\b", self.window)
            text += f"Definition {name} := {'/ ' * found.startswith('-')}2 ^ {found.lstrip('-')}.\n"
        for name, fields in self.structs.items():
            shown = "; ".join(f"{field_name(name, field)} : {coq(kind)}" for field, kind in fields)
            text += f"Record {name.lower()} := {name} {{ {shown} }}.\n"
        return text + "\nSection Text.\nVariable round : R -> R.\n"


def coq(kind):
    return KINDS.get(kind, kind.lower())


def field_name(struct, field):
    return f"{struct.lower()}_{field.rstrip('_')}"
