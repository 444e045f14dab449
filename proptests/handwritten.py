# SPDX-License-Identifier: Apache-2.0
"""Counts the lines that people wrote for an operation."""
import re

MODULES = ("reference", "robust", "oracle", "catalogue/rows", "catalogue/signatures", "proptests/operations", "fuzz")


def lines(path):
    return path.read_text(encoding="utf-8").count("\n") if path.is_file() else 0


def together(paths):
    return "\n".join(path.read_text(encoding="utf-8") for path in sorted(paths))


def handwritten(root, chapters, names):
    """{operation: (lines, lines of its mutants and claims)}: its files, and its functions in the checkers of
    certificates and in the second truth. chapters: {operation: chapter}; names: {name: operation}, a method's is the
    operation that it answers."""
    certificates = root / "oracle/certificates"
    cpp = together(certificates.glob("check*.cpp"))
    truths = (root / "proptests/infrastructure/oracle").glob("simplest_truth*.py")
    python = together([*certificates.glob("certify*.py"), *truths])
    found = {}
    for operation, chapter in chapters.items():
        own = sum(lines(root / module / chapter / (name + suffix)) for name, of in names.items() if of == operation
                  for module in MODULES for suffix in (".h", ".cpp"))
        in_cpp = re.compile(rf"^\S[^\n;]*\bcheck_{operation}\([^;{{]*\{{\n.*?^\}}\n", re.MULTILINE | re.DOTALL)
        in_python = re.compile(rf"^def (?:check|truth)_{operation}\(.*\n(?:[ \t].*\n|\n(?=[ \t]))*", re.MULTILINE)
        own += sum(body.count("\n") for body in in_cpp.findall(cpp) + in_python.findall(python))
        data = (root / f"proptests/mutation/mutants/{operation}.jsonl", certificates / f"claims/{operation}.jsonl")
        found[operation] = (own, sum(map(lines, data)))
    return found
